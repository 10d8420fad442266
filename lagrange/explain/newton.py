"""Newton's law with reactions, the free bodies, the count of unknowns, the work of the reactions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.core.symbols import Dot, Sign, VectorSymbol, differential, t
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Equation,
    Part,
    Prose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.words import counted, plural, spoken
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.friction import Rubbing
from lagrange.mechanics.dynamics.newton import Count, FreeBody, Newton, Reaction
from lagrange.mechanics.dynamics.workless import WorkOfReaction

ZERO = sp.S.Zero
LONGEST = 8
"""Operations of what stands in running text."""


def explain_newton(
    newton: Newton,
    rubbed: Sequence[Rubbing],
    configuration: Configuration,
    freedom: int,
    at_rest: bool = False,
    unknown_forces: bool = False,
) -> Step:
    """Free bodies, the components of Newton's law, unknowns against equations.

    unknown_forces  whether applied forces are unknown too, which are not counted
    """
    body: list[Block] = []
    if newton.bodies is None:
        body += _without_bodies(newton, bool(configuration.rotations))
    else:
        body.append(paragraph(*(s for r in newton.reactions for s in nature(r))))
        for b in newton.bodies:
            body += _free_body(b, field_called(configuration))
        body += explain_friction(rubbed)
        body += _law(newton, newton.bodies, at_rest)
        if newton.before is not None and newton.after is not None and not unknown_forces:
            body += _counted(newton, newton.before, newton.after, configuration, freedom)
    title = "The reactions" if at_rest else "Newton's law and the reactions"
    return Step(Rule.REACTIONS, title, tuple(body))


def _without_bodies(newton: Newton, rigid: bool) -> list[Block]:
    one = len(newton.reactions) == 1
    multipliers = listed(math(r.multiplier) for r in newton.reactions)
    return [
        prose(
            "The constraint is kept by a reaction: " if one else "The constraints are kept by reactions: ",
            "the coefficients of its form, times an unknown " if one
            else "the coefficients of each form, times an unknown ",
            *multipliers, ", are its generalized forces. " if one else ", are the generalized forces. ",
            "" if rigid else "How it is shared out among particles the coordinates do not tell." if one
            else "How they are shared out among particles the coordinates do not tell.",
        )
    ]  # fmt: skip


def nature(reaction: Reaction) -> list[Prose]:
    """What kind of force keeps a constraint."""
    name = spoken(reaction.name)
    multiplier = math(reaction.multiplier)
    if reaction.rod is not None:
        rod = reaction.rod
        first, second = rod.ends
        other = second or ("O" if rod.centre is not None and rod.centre.is_zero else "a given point")
        beginning: list[Part] = [
            f"{_capital(name)} keeps {first} at the distance ", math(rod.length), f" from {other}: its reaction is "
            "along the line that joins them, as that of a rod",
            "" if second else ", or of a smooth circle or sphere", ". ",
        ]  # fmt: skip
        if reaction.tension is None:
            return [prose(*beginning)]
        tension = (reaction.tension,) if reaction.named else (reaction.tension, rod.factor * reaction.multiplier)
        return [prose(*beginning, "Its tension, positive where it pulls, is ", math(*tension), ".")]
    if reaction.is_normal and reaction.directions:
        [particle] = reaction.directions
        words = f"{_capital(name)} keeps {particle} on a surface: its reaction is normal to that, a multiple "
        return [prose(words, multiplier, " of the gradient.")]
    if not reaction.acts_on:
        return [prose(f"{_capital(name)} acts on no particle.")]
    on = "".join(str(p) for p in listed(reaction.acts_on))
    words = f"The reaction of {name} on {on} is a multiple "
    return [prose(words, multiplier, " of the coefficients of its form.")]


def _capital(name: str) -> str:
    return f"The constraint {name}"


def field_called(configuration: Configuration) -> str:
    """What has a force without a name: fields, springs, dampers."""
    springs, dampers = configuration.springs, configuration.dampers
    fields = configuration.potential - sp.Add(*(s.energy for s in springs)) != 0
    whats = ["the field"] * fields + [plural(len(springs), "the spring", "the springs")] * bool(springs)
    whats += [plural(len(dampers), "the damper", "the dampers")] * bool(dampers)
    return "the force of " + "".join(str(p) for p in listed(whats))


def _free_body(body: FreeBody, of_field: str) -> list[Block]:
    """Everything that acts on one particle."""
    name = body.particle.name
    acting = ["its weight" if n == "weight" else f"the force {spoken(n)}" if n else of_field for n in body.loads]
    acting += [f"the reaction of {spoken(r.name)}" for r in body.bound]
    if not acting:
        return [prose(f"Nothing acts on {name}.")]
    verb = plural(len(acting), "acts", "act")
    if not body.bound:
        return [prose(f"On {name} {verb} ", *listed(acting), ".")]
    lines = []
    for kind, label, terms in (("R", "reaction", body.reactions), ("Gamma", "couple", body.moments)):
        if terms:
            total = sum((g * r.force for r, g in terms), Vector.zero(terms[0][1].triad))
            lines.append(Equation((VectorSymbol(f"{kind}_{name}"), total), label=f"{label}-{name}"))
    words = f"; {_with(body.bound)}"
    if body.moments:
        one = len(body.bound) == 1
        its, force = ("its", "it and ") if one else ("their", "their sum and ")
        moment = f"{its} moment about the mass centre"
        words += f", {force}{moment} are" if body.reactions else f", {moment} is"
    return [prose(f"On {name} {verb} ", *listed(acting), words), display(*lines)]


def _with(reactions: Sequence[Reaction]) -> str:
    """What the force is written with."""
    kinds = {"tension" if r.named else "multiplier" for r in reactions}
    words = plural(len(reactions), " and ", "s and ").join(sorted(kinds))
    return f"with the {words}{'s' if len(reactions) > 1 else ''}"


def explain_friction(rubbed: Sequence[Rubbing]) -> list[Block]:
    """How large friction is, and when."""
    found: list[Block] = []
    for r in rubbed:
        begin = f"While {r.friction.on} slides, the friction {spoken(r.friction.name)} is "
        first: tuple[Part, ...] = (begin, math(r.friction.coefficient), " times the magnitude of the reaction")
        second: tuple[Part, ...] = (
            "against the slip ", math(r.slip), ". It does work, and counts as an applied force. This holds where the "
            "slip is not zero; without slip friction is what keeps it so, up to a limit.",
        )  # fmt: skip
        if r.magnitude.count_ops() > LONGEST:
            found += [prose(*first), display(Equation((r.magnitude,))), prose(*second)]
        else:
            found.append(prose(*first, ", ", math(r.magnitude), ", ", *second))
        if isinstance(r.contact, Sign):
            continue
        sense = "positive" if r.contact == 1 else "negative"
        found.append(prose("The file says that ", math(r.reaction.multiplier), f" is {sense}."))
    return found


def _law(newton: Newton, bodies: Iterable[FreeBody], at_rest: bool) -> list[Block]:
    lines = []
    turned = False
    for b in bodies:
        for kind, components in (("newton", b.components), ("turning", b.turning)):
            for n, c in enumerate(components, start=1):
                lines.append(Equation((c.inertia, c.right), label=f"{kind}-{b.name}-{n}"))
        turned = turned or bool(b.turning)
    if at_rest:
        words = "At rest nothing is accelerated: by Newton's law applied force and reaction cancel, "
        words += "and their moments too, in components" if turned else "in components"
    elif turned:
        words = "Newton's law, inertia equal to applied force and reaction, and the law of angular momentum, its rate "
        words += "about the mass centre equal to the moment of both, have the components"
    else:
        words = "Newton's law, inertia equal to applied force and reaction, has the components"
    found: list[Block] = [prose(words)]
    found.append(display(*lines))
    if newton.idle:
        names = listed(math(q) for q in newton.idle)
        lines = [Equation((ZERO, right), label=f"idle-{q.name}") for q, right in newton.idle.items()]
        words = plural(len(newton.idle), " moves no particle, so that no force is left to balance what acts on it:",
                       " move no particle, so that no force is left to balance what acts on them:")  # fmt: skip
        found += [prose(*names, words), display(*lines)]
    return found


def _counted(newton: Newton, before: Count, after: Count, configuration: Configuration, freedom: int) -> list[Block]:
    coordinates = len(configuration.slots.coordinates)
    components = before.unknowns - coordinates
    constraints = before.equations - sum(len(b.laws) for b in newton.bodies or ()) - len(newton.idle)
    laws = before.equations - constraints
    many = before.missing
    turned = any(b.turning for b in newton.bodies or ())
    whose = "the laws of Newton and of angular momentum" if turned else "Newton's law"
    words = (
        f"If nothing were known of the reactions but that they act, {counted(coordinates, 'coordinate')} and "
        f"{counted(components, 'component')} of reactions would be unknown, {before.unknowns} in all, in "
        f"{before.equations} equations: {counted(laws, 'component')} of {whose} and "
        f"{counted(constraints, 'independent constraint')}. {many or 'None'} {plural(many or 1, 'is', 'are')} missing"
    )
    words += ", as many as there are degrees of freedom. " if many == freedom and many else ". "
    multipliers = len(newton.reactions)
    unknown = counted(multipliers, "multiplier")
    words += f"The directions leave {unknown}: {after.unknowns} unknowns in {after.equations} equations."
    if after.missing > 0:
        words += (
            " The constraints are not independent of one another, so that the multipliers are not determined one by "
            "one, only what they do together."
        )
    return [prose(words)]


def explain_works(works: Sequence[WorkOfReaction], configuration: Configuration) -> Step:
    """The virtual work of the reactions, of each particle's share, and the work in a possible displacement."""
    body: list[Block] = []
    total = sp.Add(*(w.reaction.force * w.virtual for w in works))
    on = [p.name for p in configuration.points if any(w.reaction.on(p.name) is not None for w in works)]
    about = [r.name for r in configuration.rotations if any(r.name in w.reaction.moments for w in works)]
    left = sp.Add(
        *(Dot(VectorSymbol(f"R_{n}"), VectorSymbol(f"delta(r_{n})")) for n in on),
        *(Dot(VectorSymbol(f"Gamma_{n}"), VectorSymbol(f"delta(pi_{n})")) for n in about),
    )
    known = all(w.reaction.directions is not None and not w.reaction.others for w in works)
    zero = listed(Ref(f"virtual-{w.reaction.name}") for w in works)
    body.append(
        prose("In a virtual displacement ", plural(len(works), "the reaction does", "the reactions do"), " the work")
    )
    body.append(display(Equation((left, total) if known and (on or about) else (total,), label="virtual-work")))
    good = all(w.vanishes for w in works)
    if good:
        vanish = plural(len(works), "which is zero by ", "which is zero, term by term, by ")
        workless = plural(len(works), ": the constraint is workless.", ": the constraints are workless.")
        body.append(prose(vanish, *zero, workless))
    else:
        body.append(prose("whether it is zero could not be decided."))
    for w in works:
        body += _shares(w)
    body += _possible(works)
    return Step(
        Rule.WORKLESS, "The reactions do no virtual work" if good else "The virtual work of the reactions", tuple(body)
    )


def _shares(work: WorkOfReaction) -> list[Block]:
    """Each particle's share, where it is not zero."""
    if len(work.working) < 2:
        return []
    reaction = work.reaction
    lines = [
        Equation((reaction.force * share,), label=f"share-{reaction.name}-{particle}")
        for particle, share in work.shares.items()
        if particle in work.working
    ]
    particles = listed(work.working)
    found: list[Block] = []
    if reaction.rod is not None and reaction.rod.centre is None:
        found += _ends(reaction.name, *reaction.rod.ends)
    found.append(prose(f"The reaction of {spoken(reaction.name)} works on ", *particles, " one by one:"))
    ending = "None of these need be zero, only their sum: what is taken from one is given to another."
    return [*found, display(*lines), prose(ending)]


def _ends(name: str, first: str, second: str) -> list[Block]:
    """The ends of a rod move alike along it, and are pulled oppositely."""
    along = VectorSymbol(f"r_{first}") - VectorSymbol(f"r_{second}")
    moved = (Dot(along, VectorSymbol(f"delta(r_{end})")) for end in (first, second))
    return [
        prose(
            f"By {spoken(name)} the displacements of {first} and {second} along the line that joins them are the same,"
        ),
        display(Equation(tuple(moved), label=f"ends-{name}")),
        prose("and the forces on the two are opposite."),
    ]


def _possible(works: Sequence[WorkOfReaction]) -> list[Block]:
    moving = [w for w in works if w.possible != 0]
    if not moving:
        return []
    names = listed(f"that of {spoken(w.reaction.name)}" for w in moving)
    dt = math(differential(t))
    lines = [Equation((w.possible,), label=f"possible-work-{w.reaction.name}") for w in moving]
    return [
        prose(
            "In a possible displacement, in the time ",
            dt,
            ", it is otherwise; the work of the reaction, ",
            *names,
            ", is",
        ),
        display(*lines),
        prose("which need not be zero: what moves the constraint does work through it."),
    ]
