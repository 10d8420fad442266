"""Newton's law with reactions, the free bodies, the count of unknowns, the work of the reactions."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import DotProduct, Sign, VectorSymbol, differential, t
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Equation,
    EquationKind,
    Part,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
    series,
)
from lagrange.explain.contact.one_sided import explain_held_bodies
from lagrange.explain.limits import LONGEST_IN_TEXT, MOST_LAWS
from lagrange.explain.words import (
    capital,
    constraints_called,
    counted,
    friction_called,
    joined,
    load_called,
    plural,
    the,
)
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.free_bodies import Rod
from lagrange.mechanics.dynamics.friction import FrictionForce
from lagrange.mechanics.dynamics.newton import Count, FreeBody, Newton, Reaction, WorkOfReaction
from lagrange.mechanics.dynamics.reaction_signs import SURFACES, ForceKind, SingleForce
from lagrange.mechanics.rewriting.factors import in_factors
from lagrange.problem.model import Keeper

ZERO = sp.S.Zero


def explain_newton(
    newton: Newton,
    friction_forces: Sequence[FrictionForce],
    configuration: Configuration,
    freedom: int,
    at_rest: bool = False,
    unknown_forces: bool = False,
) -> Step:
    """Free bodies, the components of Newton's law, unknowns against equations.

    unknown_forces  whether applied forces are unknown too: then unknowns are not counted
    """
    body: list[Block] = []
    if newton.bodies is None:
        body += _without_bodies(newton, bool(configuration.rotations))
    else:
        body.append(paragraph(*natures(newton.reactions)))
        for b in newton.bodies:
            body += _free_body(
                b,
                field_called(configuration),
                {r.friction.name for r in friction_forces},
                {m.name for m in configuration.torques},
            )
        body += explain_friction(friction_forces)
        body += _law(newton, newton.bodies, at_rest, field_called(configuration))
        if newton.before is not None and newton.after is not None and not unknown_forces:
            body += _counted(newton, newton.before, newton.after, configuration, freedom)
        body += explain_held_bodies(newton, at_rest)
    title = "The reactions" if at_rest else "Newton's law and the reactions"
    return Step(Rule.REACTIONS, title, tuple(body))


def _without_bodies(newton: Newton, rigid: bool) -> list[Block]:
    one = len(newton.reactions) == 1
    multipliers = listed(math(r.multiplier) for r in newton.reactions)
    words = f"{'The' if one else 'Each'} constraint is maintained by a reaction, whose generalized forces are the "
    words += f"coefficients of its form times an unknown multiplier{' ' if one else ': '}"
    shared = f" How {'it is' if one else 'they are'} distributed among the particles, the coordinates do not determine."
    known = natures(r for r in newton.reactions if r.single is not None)
    return [prose(words, *multipliers, "." if rigid else f".{shared}"), *known]


_LIKE = (Keeper.ROD, Keeper.STRING)
KEEPERS = {
    Keeper.ROD: "a rod",
    Keeper.STRING: "a string",
    Keeper.SURFACE: "a surface",
    Keeper.WIRE: "a wire",
    Keeper.HINGE: "a hinge",
    Keeper.ROLLING: "rolling without slipping",
    Keeper.GEAR: "gears in mesh",
}
"""What maintains a constraint, in words."""


def nature(reaction: Reaction) -> list[Prose]:
    """What maintains a constraint, if the file says so, and the kind of force."""
    by = reaction.constraint.by
    is_said = by in SURFACES if _is_on_surface(reaction) else by in _LIKE and reaction.rod is not None
    called = constraints_called([reaction.name])
    if by is None or is_said or _is_tension(reaction) or by.value in called:
        return _force(reaction)
    return [prose(f"{capital(called)} is maintained by {KEEPERS[by]}."), *_force(reaction)]


def natures(reactions: Iterable[Reaction]) -> list[Prose]:
    """What maintains each constraint; of several on the same bodies, known by their forms only, in one sentence."""
    said: list[Prose] = []
    alike: dict[tuple[object, ...], list[Reaction]] = {}
    for r in reactions:
        by_form = _is_of_form(r) and r.constraint.by is None and r.row.nonlinear is None
        key: tuple[object, ...] = (r.acts_on, str(_why_no_force(r)), r.is_partial) if by_form else (r.name,)
        if _is_along_unit_vector(r):
            key = (r.acts_on, ForceKind.ALONG)
        if r.constraint.by is Keeper.WIRE and r.is_normal and r.single is not None and r.given is not None:
            key = (r.acts_on, Keeper.WIRE)
        alike.setdefault(key, []).append(r)
    for key, group in alike.items():
        first, *others = group
        together = (
            _on_a_wire if Keeper.WIRE in key else _along_unit_vectors if ForceKind.ALONG in key else _by_their_forms
        )
        said += together(group) if others else nature(first)
    return said


def _on_a_wire(reactions: Sequence[Reaction]) -> list[Prose]:
    """`The sphere and plane constraints together keep P on a wire, ...`: forces along the unit normals."""
    [particle] = reactions[0].acts_on
    words = f"{capital(constraints_called(r.name for r in reactions))} together keep {the(particle)} on a wire, and "
    forces = series(
        (math(r.force), " along ", math(r.single.direction))
        for r in reactions
        if r.single is not None and r.single.direction is not None
    )
    return [prose(words, "their reactions are normal to it: forces ", *forces, ".")]


def _is_along_unit_vector(reaction: Reaction) -> bool:
    """Whether all that is said is: a named force on one body, along a unit vector."""
    single = reaction.single
    if single is None or single.direction is None or reaction.given is None or reaction.rod is not None:
        return False
    plain = not (reaction.is_normal or reaction.is_partial or single.opposite or _is_tension(reaction))
    short = sum(count_operations(c) for c in single.direction.components) <= LONGEST_IN_TEXT
    stated = reaction.constraint.side is not None or any(e.is_Add for e in single.presumed)
    by = reaction.constraint.by
    is_said = by is None or by.value in constraints_called([reaction.name])
    return plain and short and not stated and is_said


def _along_unit_vectors(reactions: Sequence[Reaction]) -> list[Prose]:
    """`The reactions of the downward and sideways constraints on the ball are forces F₁ along e₁ and F₂ along e₂.`"""
    words = f"The reactions of {constraints_called(r.name for r in reactions)} on "
    forces = series(
        (math(r.force), " along ", math(r.single.direction))
        for r in reactions
        if r.single is not None and r.single.direction is not None
    )
    return [prose(f"{words}{the(reactions[0].acts_on[0])} are the forces ", *forces, ".")]


def _is_of_form(reaction: Reaction) -> bool:
    """Whether all that is said is: λ times the coefficients of its form."""
    named = reaction.single is not None and (reaction.given is not None or _is_tension(reaction))
    normal = reaction.is_normal and bool(reaction.directions)
    return reaction.rod is None and not named and not normal and bool(reaction.acts_on)


def _by_their_forms(reactions: Sequence[Reaction]) -> list[Prose]:
    """`The reactions of the rolling 1 and rolling 2 constraints on the ball are λ_1 and λ_2 times ...`."""
    multipliers = listed(math(r.multiplier) for r in reactions)
    words = f"The reactions of {constraints_called(r.name for r in reactions)} on "
    words += f"{joined(map(the, reactions[0].acts_on))} are "
    end: tuple[Part, ...] = ()
    if why := _why_no_force(reactions[0]):
        they = (
            "They have moments and are no single forces: " if why == "has a moment" else "They act on several bodies: "
        )
        they = "They act on coordinates that move no particle: " if reactions[0].others else they
        they = "Their directions cannot be told from the coordinates: " if reactions[0].is_partial else they
        end = (f" {they}", *multipliers, " are the multipliers.")
    return [prose(words, *multipliers, " times the coefficients of their forms.", *end)]


def _is_tension(reaction: Reaction) -> bool:
    """Whether it is the tension of something that keeps a sum of lengths constant, and describes itself."""
    return reaction.rod is None and reaction.single is not None and reaction.single.kind is ForceKind.TENSION


def _is_on_surface(reaction: Reaction) -> bool:
    """Whether the reaction is stated to be normal to the surface or curve that the particle is kept on."""
    return reaction.rod is None and reaction.is_normal and bool(reaction.directions)


def _support(reaction: Reaction) -> str:
    by = reaction.constraint.by
    if by is not None and by in SURFACES:
        return KEEPERS[by]
    normal = next(iter(reaction.directions.values())).fixed().components if reaction.directions else ()
    straight = bool(normal) and all(s.is_positive for c in normal for s in c.free_symbols)  # parameters, no coordinates
    match len(reaction.row.coefficients):
        case 2:
            return "a straight line" if straight else "a curve"
        case 3:
            return "a plane" if straight else "a surface"
    return "a surface or curve"


def _force(reaction: Reaction) -> list[Prose]:
    if not reaction.is_partial or not reaction.acts_on:
        return _whole_force(reaction)
    words = f"Of it, only the part along the path that the coordinates leave to {joined(map(the, reaction.acts_on))} "
    return [*_whole_force(reaction), prose(words, "enters the equations.")]


def _whole_force(reaction: Reaction) -> list[Prose]:
    if reaction.rod is not None:
        return [_of_rod(reaction, reaction.rod)]
    called, single = constraints_called([reaction.name]), reaction.single
    if _is_tension(reaction) and single is not None:
        by = reaction.constraint.by
        keeper = f", {KEEPERS[by]}," if by is not None and by.value not in called else ""
        if reaction.symbol_of_force is None:
            what: tuple[Part, ...] = ("a tension. It is ", math(single.factor * reaction.multiplier))
        else:
            what = ("the tension ", math(*_valued(reaction, reaction.symbol_of_force)))
        beginning = f"{capital(called)}{keeper} keeps a length constant: its reaction is "
        return [prose(beginning, *what, ", positive where it pulls.")]
    if single is not None and reaction.given is not None and not reaction.is_partial:
        return [_along(reaction, single, reaction.given)]
    multiplier = math(reaction.multiplier)
    if reaction.is_normal and reaction.directions:
        [particle] = reaction.directions
        words = f"{capital(called)} keeps {the(particle)} on {_support(reaction)}, and its reaction is normal to it: "
        return [prose(words, multiplier, " times the gradient.")]
    if not reaction.acts_on:
        return [prose(f"{capital(called)} acts on no particle.", *_not_a_force(reaction))]
    form = "the coefficients of its form"
    if reaction.row.nonlinear is not None:
        form = "the derivatives of the constraint with respect to the velocities"
    words = f"The reaction of {called} on {joined(map(the, reaction.acts_on))} is "
    if single is not None and reaction.given is not None:
        multiplier, form = math(reaction.given), f"{form}, to the permitted side"
    return [prose(words, multiplier, f" times {form}.", *_not_a_force(reaction))]


def _of_rod(reaction: Reaction, rod: Rod) -> Prose:
    """A distance between two points, and its tension."""
    first, second = rod.ends
    other = the(second) if second else ("O" if rod.centre is not None and rod.centre.is_zero else "a given point")
    by = reaction.constraint.by
    like = f", as that of {KEEPERS[by]}" if by is not None and by in _LIKE else ""
    if reaction.constraint.side is not None and by is None:
        like = ", as that of a string"
    beginning: list[Part] = [
        f"{capital(constraints_called([reaction.name]))} keeps {the(first)} at the distance ", math(rod.length),
        f" from {other}: its reaction acts along the line joining them{like}.",
    ]  # fmt: skip
    if reaction.tension is None:
        return prose(*beginning)
    tension = math(*_valued(reaction, reaction.tension))
    return prose(*beginning, " Its tension, positive where it pulls, is ", tension, ".")


def _valued(reaction: Reaction, symbol: sp.Symbol) -> tuple[sp.Expr, ...]:
    """The force, and what it is in terms of λ, unless the file names it and equations are written in it."""
    if reaction.single is None or (reaction.given is not None and reaction.directions is not None):
        return (symbol,)
    factor = reaction.single.factor
    return (symbol,) if factor == 1 else (symbol, factor * reaction.multiplier)


def _along(reaction: Reaction, single: SingleForce, name: sp.Symbol) -> Prose:
    """A named force along a unit vector."""
    called, body, direction = constraints_called([reaction.name]), the(single.on), single.direction
    is_short = direction is not None and sum(count_operations(c) for c in direction.components) <= LONGEST_IN_TEXT
    unit: tuple[Part, ...] = (" ", math(direction)) if is_short and direction is not None else ()
    if reaction.is_normal:
        words = f"{capital(called)} keeps {body} on {_support(reaction)}, and its reaction is normal to it: a force "
        along: tuple[Part, ...] = (math(name), " along the unit normal", *unit)
    else:
        words = f"The reaction of {called} on {body} is a force "
        along = (math(name), " along the unit vector", *unit)
    where = "" if unit else ", in the direction in which the left side less the right side increases"
    if reaction.constraint.side is not None:
        where = ", to the permitted side"
    lengths = [math(e, ZERO, relation=">") for e in single.presumed if e.is_Add]
    taken: tuple[Part, ...] = (", with ", *listed(lengths)) if lengths else ()
    end = f", and the opposite force acts on {the(single.opposite)}." if single.opposite else "."
    return prose(words, *along, *taken, where, end)


def _not_a_force(reaction: Reaction) -> list[Part]:
    """Why the name that the file gives to a reaction is that of the multiplier."""
    why = _why_no_force(reaction)
    if why is None or reaction.given is None:
        return []
    if reaction.is_partial:
        return [" Its direction cannot be told from the coordinates: ", math(reaction.given), " is the multiplier."]
    return [" It ", why, " and is no single force: ", math(reaction.given), " is the multiplier."]


def _why_no_force(reaction: Reaction) -> str | None:
    """`has a moment`; None if it is a single force, or the file gives it no name."""
    if reaction.given is None or reaction.single is not None:
        return None
    if reaction.others:
        return "acts on a coordinate that moves no particle"
    if reaction.directions is None or len(reaction.acts_on) > 2 or len(reaction.directions) > 1:
        return "acts on several bodies"
    return "has a moment"


def field_called(configuration: Configuration) -> str:
    """The sources of forces without a name: fields, springs, dampers."""
    springs, dampers = configuration.springs, configuration.dampers
    whats = [plural(len(springs), "the spring", "the springs")] * bool(springs)
    whats += [plural(len(dampers), "the damper", "the dampers")] * bool(dampers)
    fields = ["the force that derives from the potential energy"] * configuration.has_field
    return joined([*fields, *([f"the force of {joined(whats)}"] if whats else [])])


def _free_body(body: FreeBody, of_field: str, rough: Collection[str], turning: Collection[str]) -> list[Block]:
    """All forces that act on one particle."""
    name, called = body.particle.name, the(body.particle.name)
    acting = [
        "its weight"
        if n == "weight"
        else friction_called(n, rough)
        if n in rough
        else load_called(n, "moment" if n in turning else "force")
        if n
        else of_field
        for n in body.loads
    ]
    if body.bound:
        acting.append(f"the {plural(len(body.bound), 'reaction', 'reactions')} of "
                      + constraints_called(r.name for r in body.bound))  # fmt: skip
    if not acting:
        return [prose(f"No force acts on {called}.", purpose=Purpose.ACTING)]
    verb = plural(len(acting) + len(body.bound[1:]), "acts", "act")
    sentence = f"On {called} {verb} {joined(acting)}."
    if not body.bound:
        return [prose(sentence, purpose=Purpose.ACTING)]
    lines = []
    for letter, kind, terms in (
        ("R", EquationKind.REACTION, body.reactions),
        ("Gamma", EquationKind.COUPLE, body.moments),
    ):
        if terms:
            total = Vector.total((g * r.force for r, g in terms), terms[0][1].triad)
            lines.append(Equation((VectorSymbol(f"{letter}_{name}"), total), label=f"{kind}-{name}", kind=kind))
    its, force = plural(len(body.bound), "its", "their"), plural(len(body.bound), "the reaction", "their sum")
    moment = f"{its} moment about the mass centre"
    what = f"{force} and {moment} are" if body.reactions and body.moments else f"{moment if body.moments else force} is"
    words = f"{sentence} In terms of {_unknowns(body.bound)}, {what}"
    if len(body.bound) > 1 and body.reactions and body.moments:
        words = Phrase(words, Purpose.SUM_AND_MOMENT, "Their sum and their moment about the mass centre are")
    return [prose(words, purpose=Purpose.ACTING), display(*lines)]


def _unknowns(reactions: Sequence[Reaction]) -> str:
    """The unknowns in terms of which the force is written."""
    kinds = {r.called for r in reactions}
    words = plural(len(reactions), " and ", "s and ").join(sorted(kinds))
    return f"the {words}{'s' if len(reactions) > 1 else ''}"


def explain_friction(friction_forces: Sequence[FrictionForce]) -> list[Block]:
    """The magnitude of the friction, its direction, and when the law holds."""
    blocks: list[Block] = []
    names = {r.friction.name for r in friction_forces}
    for n, r in enumerate(friction_forces):
        first_of = next((f for f in friction_forces[:n] if _are_opposite(f, r)), None)
        if first_of is not None:
            called = capital(friction_called(r.friction.name, names))
            blocks.append(prose(f"{called} on {the(r.friction.on)} is the opposite of this force."))
            continue
        begin = f"While {the(r.friction.on)} slides, {friction_called(r.friction.name, names)} is "
        of_what = "resultant of these reactions" if r.also else "reaction"
        first: tuple[Part, ...] = (begin, math(r.coefficient), f" times the magnitude of the {of_what}")
        while_: tuple[Part, ...] = ("the slip is not zero",)
        if r.speed is not None and r.sense in (1, -1):
            while_ = (math(r.speed, ZERO, relation=">" if r.sense == 1 else "<"),)
        elif r.speed is not None and r.friction.slip is not None:
            while_ = (math(r.sense * r.speed, ZERO, relation=">"),)
        second: tuple[Part, ...] = (
            "directed against the slip ", math(r.slip), ". It does work and counts as an applied force. This holds "
            "while ", *while_, "; without slip, static friction takes whatever value prevents it, up to a limit.",
        )  # fmt: skip
        if count_operations(r.magnitude) > LONGEST_IN_TEXT:
            blocks += [prose(*first), display(Equation((r.magnitude,))), prose(*second)]
        else:
            blocks.append(prose(*first, ", ", math(r.magnitude), ", ", *second))
        if not r.also and not isinstance(r.contact, Sign):
            relation = ">" if r.sign_of_force == 1 else "<"
            blocks.append(prose("In contact ", math(r.reaction.force, ZERO, relation=relation), "."))
    return blocks


def _are_opposite(first: FrictionForce, second: FrictionForce) -> bool:
    """Whether the second is what the first body does to the other one."""
    same = (first.reaction.name, first.coefficient, first.magnitude) == (
        second.reaction.name, second.coefficient, second.magnitude)  # fmt: skip
    return same and first.friction.on != second.friction.on and (first.slip + second.slip).is_zero


def _law(newton: Newton, bodies: Sequence[FreeBody], at_rest: bool, of_field: str) -> list[Block]:
    lines = []
    turned = False
    for b in bodies:
        for kind, components in ((EquationKind.NEWTON, b.components), (EquationKind.TURNING, b.turning)):
            for n, c in enumerate(components, start=1):
                lines.append(Equation((c.inertia, c.right), label=f"{kind}-{b.name}-{n}", kind=kind, about=b.name))
        turned = turned or bool(b.turning)
    if at_rest:
        also = ", and so do their moments" if turned else ""
        words = (
            f"At rest nothing is accelerated: by Newton's law applied force and reaction cancel{also}; in components,"
        )
    elif turned:
        words = "Newton's law, mass times acceleration equal to applied force plus reaction, and the law of angular "
        words += "momentum, its rate of change about the mass centre equal to the moment of both, have the components"
        short = "Newton's law and the law of angular momentum about the mass centre have the components"
        words = Phrase(words, Purpose.LAW, short)
    else:
        words = "Newton's law"
    blocks: list[Block] = [prose(words), display(*lines)]
    if not at_rest and not turned:
        end = Phrase(" the components", Purpose.COMPONENTS)
        blocks[0] = prose("Newton's law, mass times acceleration equal to applied force plus reaction, has", end)
        if len(bodies) <= MOST_LAWS:
            laws = listed(math(*law_of(b)) for b in bodies)
            law, have = ("Newton's law, ", ", has") if len(bodies) == 1 else ("Newton's laws, ", ", have")
            added: tuple[Part, ...] = ()
            if any("" in b.loads for b in bodies):
                added = (f" with {of_field} included in ", math(VectorSymbol(f"F_{bodies[0].name}")))
                added = added if len(bodies) == 1 else (f" with {of_field} included",)
            blocks[0] = prose(law, *laws, *added, have, end)
    if newton.idle:
        names = listed(math(q) for q in newton.idle)
        lines = [Equation((ZERO, right), label=f"idle-{q.name}") for q, right in newton.idle.items()]
        words = plural(len(newton.idle), " moves no particle, so the generalized force on it must vanish:",
                       " move no particle, so the generalized forces on them must vanish:")  # fmt: skip
        blocks += [prose(*names, words), display(*lines)]
    return blocks


def law_of(body: FreeBody) -> tuple[sp.Expr, sp.Expr]:
    """m r'' = F + R."""
    applied = VectorSymbol(f"F_{body.name}") if not body.applied.is_zero else ZERO
    reaction = VectorSymbol(f"R_{body.name}") if body.bound else ZERO
    return body.particle.mass * VectorSymbol(f"r_{body.name}''"), applied + reaction


def _counted(newton: Newton, before: Count, after: Count, configuration: Configuration, freedom: int) -> list[Block]:
    coordinates = len(configuration.slots.coordinates)
    components = before.unknowns - coordinates
    constraints = before.equations - sum(len(b.laws) for b in newton.bodies or ()) - len(newton.idle)
    laws = before.equations - constraints
    missing = before.missing
    turned = any(b.turning for b in newton.bodies or ())
    whose = "the laws of Newton and of angular momentum" if turned else "Newton's law"
    bound = "the constraint" if constraints == 1 else f"the {constraints} constraints"
    words = (
        f"The {counted(laws, 'component')} of {whose} and {bound} are {before.equations} equations for "
        f"{before.unknowns} unknowns ({counted(coordinates, 'coordinate')}, {counted(components, 'component')} of "
        "reactions)"
    )
    if missing > 0:
        words += f": {missing} too few" + (", as many as there are degrees of freedom" if missing == freedom else "")
    same = "" if after.unknowns == after.equations else f" in {after.equations} equations"
    words += f". With the directions of the reactions known, {after.unknowns} unknowns remain{same}."
    if after.missing > 0 and len(newton.reactions) > coordinates - freedom:
        words += (
            " The constraints are not independent, so the multipliers are not determined individually, only their "
            "combined effect."
        )
    return [prose(words, purpose=Purpose.COUNT)]


def explain_works(works: Sequence[WorkOfReaction], configuration: Configuration) -> Step:
    """The virtual work of the reactions, of each particle's share, and the work in a possible displacement."""
    body: list[Block] = []
    total = sp.Add(*(w.reaction.force * w.virtual for w in works))
    on = [p.name for p in configuration.points if any(w.reaction.on(p.name) is not None for w in works)]
    about = [r.name for r in configuration.rotations if any(r.name in w.reaction.moments for w in works)]
    left = sp.Add(
        *(DotProduct(VectorSymbol(f"R_{n}"), VectorSymbol(f"delta(r_{n})")) for n in on),
        *(DotProduct(VectorSymbol(f"Gamma_{n}"), VectorSymbol(f"delta(pi_{n})")) for n in about),
    )
    known = all(w.reaction.directions is not None and not w.reaction.others for w in works)
    zero = listed(Ref(f"virtual-{w.reaction.name}") for w in works)
    turned = f"_{about[0]}" if len(about) == 1 else ""
    rotation = (" with the rotation ", math(VectorSymbol(f"delta(pi{turned})"))) if about else ()
    work = (plural(len(works), "the reaction does", "the reactions do"), " the work")
    body.append(prose("In a virtual displacement", *rotation, " ", *work))
    body.append(display(Equation((left, total) if known and (on or about) else (total,), label="virtual-work")))
    good = all(w.vanishes for w in works)
    if good:
        vanish = plural(len(works), "which is zero by ", "which is zero, term by term, by ")
        workless = plural(len(works), ": the constraint is workless.", ": the constraints are workless.")
        body.append(prose(vanish, *zero, workless))
    else:
        body.append(prose("It could not be decided whether this is zero."))
    for w in works:
        body += _shares(w)
    body += works_when_moving(works)
    none = plural(len(works), "The reaction does no virtual work", "The reactions do no virtual work")
    return Step(Rule.WORKLESS, none if good else "The virtual work of the reactions", tuple(body))


def _shares(work: WorkOfReaction) -> list[Block]:
    """Each particle's share, where it is not zero."""
    if len(work.working) < 2:
        return []
    reaction = work.reaction
    lines = [
        Equation(
            (reaction.force * share,),
            label=f"share-{reaction.name}-{particle}",
            kind=EquationKind.SHARE,
            about=reaction.name,
        )
        for particle, share in work.shares.items()
        if particle in work.working
    ]
    blocks: list[Block] = []
    if reaction.rod is not None and reaction.rod.centre is None:
        blocks += _ends(reaction.name, *reaction.rod.ends)
    particles = joined(map(the, work.working))
    words = f"On {particles} taken separately, the reaction of {constraints_called([reaction.name])} does the work"
    ending = "Only the sum need vanish: what is taken from one is given to another."
    return [*blocks, prose(words), display(*lines), prose(ending, purpose=Purpose.ONLY_SUM)]


def _ends(name: str, first: str, second: str) -> list[Block]:
    """The ends of a rod move alike along it, and are pulled oppositely."""
    along = VectorSymbol(f"r_{first}") - VectorSymbol(f"r_{second}")
    moved = (DotProduct(along, VectorSymbol(f"delta(r_{end})")) for end in (first, second))
    return [
        prose(
            f"By {constraints_called([name])}, {the(first)} and {the(second)} have equal displacements along the line "
            "joining them,"
        ),
        display(Equation(tuple(moved), label=f"ends-{name}")),
        prose("and the forces on the two are opposite."),
    ]


def _through(moving: Sequence[WorkOfReaction]) -> str:
    """What does that work: a drive, or the force itself where nothing moves and only the velocities are restricted."""
    if all(w.reaction.row.nonlinear is not None for w in moving):
        return "nothing moves, but the motion itself is not among the virtual displacements."
    return "whatever drives the constraint does work through it."


def works_when_moving(works: Sequence[WorkOfReaction]) -> list[Block]:
    """The work of reactions in a possible displacement, where constraints move."""
    moving = [w for w in works if w.possible != 0]
    if not moving:
        return []
    lines = [
        Equation((in_factors(w.possible),), label=f"possible-work-{w.reaction.name}", kind=EquationKind.POSSIBLE_WORK)
        for w in moving
    ]
    reactions = plural(len(moving), "the reaction of ", "the reactions of ")
    does = plural(len(moving), " does the work", " do the work")
    return [
        prose("In a possible displacement, in the time ", math(differential(t)), ", ", reactions,
              constraints_called(w.reaction.name for w in moving), does),
        display(*lines),
        prose("which need not be zero: ", _through(moving)),
    ]  # fmt: skip
