"""Newton's law and the work of the reactions, for geometric constraints: the law itself, then what is known of R.

The law m r'' = F + R comes as it is, in vectors; the count of equations shows that one statement about R is missing for
each degree of freedom; the direction of R is that statement. A virtual displacement is introduced where it is needed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import DotProduct, VectorSymbol, free_letter, variation
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
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
    has_purpose,
    index_of,
    listed,
    math,
    paired,
    paragraph,
    prose,
    series,
)
from lagrange.explain.contact.one_sided import explain_held_bodies
from lagrange.explain.limits import FEWEST_WITHOUT_SUMS, LONGEST_FORMS, MOST_NAMED, SHORT_WORK
from lagrange.explain.newton import field_called, law_of, natures
from lagrange.explain.page.system import are_short, is_letter
from lagrange.explain.words import NORMAL_FORCES, capital, constraints_called, counted, joined, plural, the
from lagrange.mechanics.constraints.displacements import virtual_displacement
from lagrange.mechanics.dynamics.equations import DalembertMotion
from lagrange.mechanics.dynamics.newton import FreeBody, Newton, Reaction, WorkOfReaction, works_of_reactions
from lagrange.mechanics.path_reaction import path_reaction
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.constraint_forms import without_common_number
from lagrange.mechanics.rewriting.factors import with_common_factor
from lagrange.mechanics.rewriting.readable_forms import is_same
from lagrange.mechanics.rewriting.vectors import Directions, in_named_components, unit_along, unit_directions

ZERO = sp.S.Zero


def has_vector_laws(solution: Solution) -> bool:
    """Whether Newton's law for particles without friction suffices."""
    own, law = solution.own, solution.law
    if law is None or own.dynamics is None or not solution.works or own.equilibrium is not None:
        return False
    particles = law.newton.bodies is not None and not own.configuration.rotations and not law.newton.idle
    without_friction = not law.all_frictions and not solution.problem.unknowns
    workless = all(w.vanishes for w in solution.works)
    return particles and without_friction and workless and isinstance(own.dynamics.written, DalembertMotion)


def explain_laws(solution: Solution, newton: Newton) -> Step:
    """The law in vectors, what is missing, the direction of the reactions, and the components."""
    units = unit_directions(solution.problem)
    bodies = tuple(in_named_components(b, units) for b in newton.bodies or ())
    along: list[Block] = []
    if len(bodies) == 1 and bodies == newton.bodies and all(r.is_normal for r in newton.reactions):
        bodies = (in_named_components(bodies[0], _directions_of_forces(bodies[0])),)
        if bodies != newton.bodies:
            forces = listed(math(r.force) for r in newton.reactions)
            along = [prose("and, along ", *forces, " and at a right angle to it," if len(forces) == 1 else ",")]
    lines = (Equation(law_of(b), label=f"law-{b.name}") for b in bodies)
    components = [
        Equation((c.inertia, c.right), label=f"newton-{b.name}-{n}", kind=EquationKind.NEWTON)
        for b in bodies
        for n, c in enumerate(b.components, start=1)
    ]
    vectors = [line for b in bodies if (line := _reaction_line(b, units)) is not None]
    body: list[Block] = [
        prose(
            *_named(bodies, field_called(solution.own.configuration)),
            plural(len(bodies), "Newton's law is", "Newton's law for each particle is"),
        ),
        display(*lines),
        *_together([*missing_relations(solution, newton), *_directions(newton.reactions)]),
        *([display(*vectors), *along] if along else []),
        display(*(() if along else vectors), *(paired(components) if are_short(components) else components)),
        *explain_held_bodies(newton),
    ]
    return Step(Rule.REACTIONS, "Newton's law and the reactions", tuple(body))


def along_named(solution: Solution, step: Step) -> Step:
    """The step with the components of Newton's law for bodies along vectors of `let`, where they are shorter so.

    Of a single body also along its normal force and at a right angle to it.
    """
    units = unit_directions(solution.problem)
    bodies = () if solution.law is None else solution.law.newton.bodies or ()
    lines: dict[str, tuple[sp.Expr, sp.Expr]] = {}
    if len(bodies) == 1 and in_named_components(bodies[0], units) is bodies[0]:
        step, units = _along_forces(bodies[0], step)
    for body in bodies:
        named = in_named_components(body, units)
        if named is not body:
            step = _with_directions(step, named, units, several=len(bodies) > 1 or any(b.turning for b in bodies))
            lines |= {f"newton-{body.name}-{n}": (c.inertia, c.right) for n, c in enumerate(named.components, start=1)}
    if not lines:
        return step

    def line(e: Equation) -> Equation:
        return replace(e, sides=lines.get(e.label or "", e.sides))

    return step.map(line)


def _ends_with_components(lead: Prose) -> bool:
    """Whether a paragraph ends with `the components`, of Newton's law or of both laws."""
    return any(index_of(p, lead.parts[-1:]) is not None for p in (Purpose.COMPONENTS, Purpose.LAW))


def _with_directions(step: Step, body: FreeBody, units: Directions, several: bool) -> Step:
    """The step, with the named vectors along which the law of a body is written."""
    along = [unit_along(c.along, units) for c in body.components]
    label = f"newton-{body.name}-1"
    at = next(
        (n for n, b in enumerate(step.body) if isinstance(b, Display) and label in [e.label for e in b.equations]), 0
    )
    lead = step.body[at - 1] if at else None
    if not isinstance(lead, Prose) or not _ends_with_components(lead):
        return step
    named = listed(math(u) for u in along if u is not None and not str(u).startswith(("across", "-across")))
    if len(named) < 2 * len(along) - 1:
        return step
    of = f", those of {the(body.name)} along " if several else ", along "
    said = prose(*lead.parts, of, *named, purpose=lead.purpose)
    return replace(step, body=(*step.body[: at - 1], said, *step.body[at:]))


def _directions_of_forces(body: FreeBody) -> dict[str, Vector]:
    """The unit vectors of the forces that the file names, on a body in a plane; of one, and at a right angle to it."""
    forces = {r.force: r.single.direction.fixed() for r in body.bound
              if r.given and r.single and r.single.direction is not None and r.single.on == body.name}  # fmt: skip
    units = {f.name: u for f, u in forces.items() if u.components[2] == 0 and sum(c != 0 for c in u.components) == 2}
    if not units or len(units) < len(forces):
        return {}
    if len(units) == 1:
        [(name, unit)] = units.items()
        x, y, _ = unit.components
        units[f"across {name}"] = Vector((-y, x, ZERO))
    return units


def _along_forces(body: FreeBody, step: Step) -> tuple[Step, Directions]:
    """The directions of the forces on a body in a plane, if its law is shorter along them, and words that say so."""
    units = _directions_of_forces(body)
    if not units:
        return step, {}
    along = listed(math(r.force) for r in body.bound)
    if len(body.bound) == 1:
        along = (*along, " and at a right angle to it")
    if in_named_components(body, units) is body:
        return step, {}
    label = f"newton-{body.name}-1"
    at = next((n for n, b in enumerate(step.body) if isinstance(b, Display) and b.equations[0].label == label), 0)
    lead = step.body[at - 1] if at else None
    if not isinstance(lead, Prose) or not _ends_with_components(lead):
        return step, {}
    *parts, end = lead.parts
    said = prose(*parts, ", along ", *along, ",", end, purpose=lead.purpose)
    if body.turning:
        said = prose("Newton's law along ", *along, " and the law of angular momentum about the mass centre are")
    return replace(step, body=(*step.body[: at - 1], said, *step.body[at:])), units


def _together(blocks: Sequence[Block]) -> list[Block]:
    """The number of missing equations and the known properties of the reactions, in one paragraph."""
    words = [b for b in blocks if isinstance(b, Prose)]
    return [paragraph(*words)] if words and len(words) == len(blocks) else list(blocks)


def in_forces(step: Step, newton: Newton) -> Step:
    """A step with the tensions of rods and strings instead of their multipliers."""
    rule = {r.multiplier: r.per_force * r.force for r in newton.reactions if r.named and r.force != r.multiplier}

    def line(e: Equation) -> Equation:
        sides = (s.xreplace(rule) if isinstance(s, sp.Expr) and s.has(*rule) else s for s in e.sides)
        return replace(e, sides=tuple(sides))

    if not rule:
        return step
    return step.map(line)


def _directions(reactions: tuple[Reaction, ...]) -> list[Block]:
    """Along which lines rods pull, in one sentence; otherwise a sentence for each constraint."""
    if not all(r.rod is not None and r.tension is not None and r.named for r in reactions):
        return [paragraph(*natures(reactions), prose("So"))]
    lines = series((_along(r), " by ", constraints_called([r.name])) for r in reactions)
    tensions = listed(math(r.force) for r in reactions)
    if len(reactions) == 1:
        [r] = reactions
        assert r.rod is not None
        noun, pulls = ("force", "acts inwards") if r.force.name in NORMAL_FORCES else ("tension", "pulls")
        return [prose(
            f"{capital(constraints_called([r.name]))} keeps {_along(r)} at the length ", math(r.rod.length),
            f", and its reaction acts along it. With the {noun} ", *tensions, f", positive where it {pulls},",
        )]  # fmt: skip
    return [prose("Each constraint keeps a length, ", *lines, ", and its reaction acts along it. With the tensions ",
                  *tensions, ", positive where they pull,")]  # fmt: skip


def _along(reaction: Reaction) -> str:
    """`OP`, or `the distance between the ball and the block`."""
    assert reaction.rod is not None
    first, second = reaction.rod.ends
    centre = reaction.rod.centre
    if not second and (centre is None or not centre.is_zero):
        return f"the distance of {the(first)} from a given point"
    other = second or "O"
    if is_letter(first) and is_letter(other):
        return f"{other}{first}" if not second else f"{first}{other}"
    return f"the distance between {the(other) if second else 'O'} and {the(first)}"


def _named(bodies: tuple[FreeBody, ...], of_field: str) -> tuple[Part, ...]:
    """`With the applied force F and the reaction R of the rod, `; forces without a name are in F here only."""
    applied = any(not b.applied.is_zero for b in bodies)
    one = len(bodies) == 1
    suffix = f"_{bodies[0].name}" if one else ""
    forces = plural(len(bodies), "the applied force ", "the applied forces ")
    force: tuple[Part, ...] = (forces, math(VectorSymbol(f"F{suffix}")))
    reaction = (plural(len(bodies), "the reaction ", "the reactions "), math(VectorSymbol(f"R{suffix}")))
    if any("" in b.loads for b in bodies):
        force = (*force, f", to which {of_field} is added here,")
    return ("With ", *((*force, " and ") if applied else ()), *reaction, ", ")


def missing_relations(solution: Solution, newton: Newton) -> Iterator[Block]:
    """Unknowns against equations while the directions of the reactions are not known."""
    before = newton.before
    if before is None or before.missing <= 0:
        return
    laws = sum(len(b.laws) for b in newton.bodies or ())
    freedom = solution.classification.degrees_of_freedom
    as_many = ", as many as there are degrees of freedom" if before.missing == freedom else ""
    missing = f"{before.missing} too few{as_many}"
    constraints = before.equations - laws
    bound = "the constraint" if constraints == 1 else f"the {constraints} constraints"
    its = plural(len(newton.bodies or ()), "its", "their")
    one = len(newton.reactions) == 1
    yield prose(
        f"With {bound}, {its} {counted(laws, 'component')} give {before.equations} equations for "
        f"{before.unknowns} unknowns: {missing}. The {'direction' if one else 'directions'} of the "
        f"{'reaction' if one else 'reactions'} must be known."
    )


def _reaction_line(body: FreeBody, units: Directions) -> Equation | None:
    """R = −(T/l) r where rods pull: along the vectors between their ends, or −T e where the file names the unit vector
    e of that direction; in components otherwise.
    """
    if not body.reactions:
        return None
    name = VectorSymbol(f"R_{body.name}")
    total = Vector.total((along * r.force for r, along in body.reactions), body.reactions[0][1].triad)
    is_along_unit = sum(c != 0 for c in total.components) == 1 and total.triad.directions is not None
    if not is_along_unit and all(r.rod is not None and r.tension is not None and r.named for r, _ in body.reactions):
        directed = ((r, unit_along(direction, units)) for r, direction in body.reactions)
        pulls = sp.Add(*(_pull(r, body.name) if unit is None else r.force * unit for r, unit in directed))
        return Equation((name, pulls), label=f"reaction-{body.name}", kind=EquationKind.REACTION)
    return Equation((name, total), label=f"reaction-{body.name}", kind=EquationKind.REACTION)


def _pull(reaction: Reaction, particle: str) -> sp.Expr:
    """The tension, times the vector from the particle to the other end, over the length."""
    rod = reaction.rod
    assert rod is not None
    first, second = rod.ends
    there = VectorSymbol(f"r_{first if particle == second else second}") if second else ZERO
    if not second and rod.centre is not None and not rod.centre.is_zero:
        there = rod.centre.as_sum()
    return reaction.force / rod.length * (there - VectorSymbol(f"r_{particle}"))


def explain_work(solution: Solution, newton: Newton) -> Step:
    """Virtual displacements, the work of the reactions in them, and that it vanishes."""
    configuration = solution.own.configuration
    slots = configuration.slots
    same = newton is solution.law.newton if solution.law is not None else True
    works = solution.works if same else works_of_reactions(newton, configuration, solution.own.elimination)
    rows = configuration.rows
    forms = [virtual_displacement(without_common_number(r), slots) for r in rows]
    total = sp.Add(*(w.reaction.force * with_common_factor(w.virtual) for w in works))
    lines = [
        Equation((f, ZERO), label=f"virtual-{r.name}", kind=EquationKind.VIRTUAL, about=r.name)
        for f, r in zip(forms, rows, strict=True)
    ]
    between = [_relative(w.reaction) for w in works]
    if len(works) == len(rows) and all(b is not None for b in between) and sum(map(_length, forms)) > LONGEST_FORMS:
        products = dict(zip((w.reaction.name for w in works), between, strict=True))
        lines = [replace(e, sides=(products[r.name] or ZERO, ZERO)) for e, r in zip(lines, rows, strict=True)]
        total = sp.Add(*(-w.reaction.force / w.reaction.rod.length * products[w.reaction.name]
                         for w in works if w.reaction.rod is not None))  # fmt: skip
    on = [p.name for p in configuration.points if any(w.reaction.on(p.name) is not None for w in works)]
    left = sp.Add(*(DotProduct(VectorSymbol(f"R_{n}"), VectorSymbol(f"delta(r_{n})")) for n in on))
    zero = listed(Ref(f"virtual-{r.name}") for r in rows)
    one = len(rows) == 1
    body: list[Block] = [
        prose(
            "Time does not appear in ", *listed(Ref(f"form-{r.name}") for r in rows),
            f": virtual displacements satisfy {plural(len(rows), 'it', 'them')} too,", purpose=Purpose.TIMELESS,
        ),
        display(*lines),
        prose("In them the ", plural(len(works), "reaction does no work:", "reactions together do no work:")),
        display(Equation((left, total, ZERO), label="virtual-work", condition=("by ", *zero) if one else ())),
        *_single(works, () if one else zero),
    ]  # fmt: skip
    return Step(
        Rule.WORKLESS,
        plural(len(works), "The reaction does no virtual work", "The reactions do no virtual work"),
        tuple(body),
    )


def _relative(reaction: Reaction) -> sp.Expr | None:
    """(r_A − r_B)·(δr_A − δr_B) of the ends of a rod, or r·δr about O; None of any other reaction."""
    rod = reaction.rod
    if rod is None or reaction.tension is None or not reaction.named or reaction.moments:
        return None
    if rod.centre is not None and not rod.centre.is_zero:
        return None
    ends = [name for name in rod.ends if name]
    along = sp.Add(*(VectorSymbol(f"r_{name}") * (-1) ** n for n, name in enumerate(ends)))
    moved = sp.Add(*(VectorSymbol(f"delta(r_{name})") * (-1) ** n for n, name in enumerate(ends)))
    return DotProduct(along, moved)


def _length(e: sp.Expr) -> int:
    return count_operations(e)


def _single(works: Sequence[WorkOfReaction], zero: tuple[Part, ...]) -> Iterator[Block]:
    """By what each term vanishes; that only the sum does where one reaction works on several particles."""
    several = [w for w in works if len(w.working) > 1]
    by: tuple[Part, ...] = ("Each term is zero, by ", *zero, ".") if zero else ()
    if not several:
        yield from ([prose(*by)] if by else [])
        return
    names = joined(map(the, dict.fromkeys(n for w in several for n in w.working)))
    called = constraints_called(w.reaction.name for w in several)
    does = plural(len(several), "does", "do")
    other = "the other" if len({n for w in several for n in w.working}) == 2 else "another"
    words = f"On {names} taken separately {called} {does} work: what one loses, {other} gains."
    if len({n for w in several for n in w.working}) > MOST_NAMED:
        words = "On each of the bodies alone they do work: what one loses, another gains."
    yield prose(*by, " " if by else "", words)


def explain_laws_of_bodies(solution: Solution, step: Step) -> Step:
    """Newton's law of bodies and of particles with friction: forces alike in one sentence, all sums in one display."""
    law, own = solution.law, solution.own
    if law is None or law.newton.bodies is None or own.dynamics is None or own.equilibrium is not None:
        return step
    newton = law.newton
    names = [b.name for b in newton.bodies or ()]
    labels = {f"{kind}-{name}" for name in names for kind in ("reaction", "couple")}
    sums = [e for b in step.body if isinstance(b, Display) for e in b.equations if e.label in labels]
    if len(names) < 2 or not sums:
        return step
    at = next(n for n, b in enumerate(step.body) if isinstance(b, Display) and b.equations[0].label in labels)
    last = max(n for n, b in enumerate(step.body) if isinstance(b, Display) and b.equations[0].label in labels)
    before = [b for b in step.body[: at - 1] if not has_purpose(b, Purpose.ACTING)]
    after = [b for b in step.body[last + 1 :] if not has_purpose(b, Purpose.ACTING)]
    moments = any(e.kind is EquationKind.COUPLE for e in sums)
    forces = any(e.kind is EquationKind.REACTION for e in sums)
    what = joined(["the reactions"] * forces + ["their moments about the mass centres"] * moments)
    sentences = [prose(*s) for s in _alike(newton.reactions)]
    if sentences:
        before = [b for b in before if not isinstance(b, Prose)] + [paragraph(*sentences)]
        if len(names) >= FEWEST_WITHOUT_SUMS:  # the laws have them, body by body
            return replace(step, body=(*before, *map(_by_kind, after)))
    return replace(step, body=(*before, prose(f"On each body {what} add up to"), display(*sums), *after))


def _by_kind(block: Block) -> Block:
    """The laws of motion of all mass centres before those of all rotations."""
    kinds = (EquationKind.NEWTON, EquationKind.TURNING)
    if not isinstance(block, Display) or {e.kind for e in block.equations} != {*kinds}:
        return block
    ordered = sorted(block.equations, key=lambda e: e.kind is EquationKind.TURNING)
    return replace(block, equations=tuple(ordered))


def _alike(reactions: Sequence[Reaction]) -> Iterator[tuple[Part, ...]]:
    """Named forces along the same unit vector in one sentence; empty unless all reactions are such forces."""
    groups: dict[tuple[sp.Expr, ...], list[Reaction]] = {}
    for r in reactions:
        direction = r.single.direction if r.single is not None and r.given is not None else None
        if r.single is None or direction is None or r.rod is not None or r.is_normal or not r.single.opposite:
            return
        groups.setdefault(direction.fixed().components, []).append(r)
    for members in groups.values():
        [first, *_] = members
        assert first.single is not None
        assert first.single.direction is not None
        on = series((math(r.force), f" on {the(r.single.on)}") for r in members if r.single is not None)
        opposite = joined(dict.fromkeys(the(r.single.opposite) for r in members if r.single is not None))
        called = constraints_called(r.name for r in members)
        one = len(members) == 1
        subject = f"The {plural(len(members), 'reaction', 'reactions')} of {called}"
        yield (
            f"{subject} {'is the force' if one else 'are the forces'} ",
            *on, " along ", math(first.single.direction),
            f"; the opposite {'force acts' if one else 'forces act'} on {opposite}.",
        )  # fmt: skip


def shares_shortly(solution: Solution, step: Step) -> Step:
    """The work of the reactions, without the shares of each body one by one where there are several."""
    several = [w for w in solution.works if len(w.working) > 1]
    step = _as_a_whole(solution, step)
    if len(several) < 2:
        return step
    shared = {w.reaction.name for w in several}
    body: list[Block] = []
    for block in step.body:
        if isinstance(block, Display) and block.is_of(EquationKind.SHARE) and block.equations[0].about in shared:
            body.pop()
        elif not has_purpose(block, Purpose.ONLY_SUM):
            body.append(block)
    return replace(step, body=(*body, *_single(several, ())))


def _as_a_whole(solution: Solution, step: Step) -> Step:
    """δW instead of R·δr and Γ·δπ of each of many bodies."""
    bodies = () if solution.law is None else solution.law.newton.bodies or ()
    if len(bodies) < FEWEST_WITHOUT_SUMS:
        return step
    name = variation(sp.Symbol(free_letter("W", "A", "w", taken={*solution.problem.scope.names()}), real=True))
    blocks = (
        replace(b, equations=tuple(replace(e, sides=(name, *e.sides[1:])) for e in b.equations))
        if isinstance(b, Display) and _is_work(b) and len(b.equations[0].sides) > 1
        else b
        for b in step.body
    )
    return replace(step, body=tuple(blocks))


def work_by_forms(solution: Solution, step: Step) -> Step:
    """The work of the reactions as multiples of the conditions on virtual displacements, where these are long.

    Each term is a multiplier times the left side of one of them: to write it out repeats them.
    """
    forms = {r.name: virtual_displacement(r, solution.own.configuration.slots) for r in solution.own.configuration.rows}
    at = next((n for n, b in enumerate(step.body) if isinstance(b, Display) and _is_work(b)), None)
    plain = all(w.reaction.name in forms and is_same(w.virtual, forms[w.reaction.name]) for w in solution.works)
    if at is None or not plain or len(solution.works) < 2 or at + 1 >= len(step.body):
        return step
    shown = step.body[at]
    assert isinstance(shown, Display)
    [e] = shown.equations
    total = e.sides[-1]
    if not isinstance(total, sp.Expr) or _length(total) <= SHORT_WORK:
        return step
    letter = free_letter("W", "A", "w", taken={*solution.problem.scope.names()})
    left = e.sides[0] if len(e.sides) > 1 else variation(sp.Symbol(letter, real=True))
    first, *others = solution.works
    terms: list[tuple[Part, ...]] = [
        (math(first.reaction.force), " times the left side of ", Ref(f"virtual-{first.reaction.name}"))
    ]
    terms += [(math(w.reaction.force), " times that of ", Ref(f"virtual-{w.reaction.name}")) for w in others]
    before = [*step.body[: at - 1]]
    symbols = left.free_symbols if isinstance(left, sp.Basic) else set()
    turned = sorted((s for s in symbols if str(s).startswith("delta(pi")), key=str)
    rotation = (" with the rotation ", math(*turned)) if len(turned) == 1 else ()
    words = prose("In a virtual displacement", *rotation, " the work of the reactions is the sum of ", *series(terms),
                  Phrase(":", Purpose.LEFT_SIDES))  # fmt: skip
    if before and isinstance(before[-1], Prose):
        words = paragraph(before.pop(), words)  # type: ignore[arg-type]
    line = display(replace(e, sides=(left, ZERO), condition=("the constraints are workless",)))
    return replace(step, body=(*before, words, line, *step.body[at + 2 :]))


def _is_work(block: Display) -> bool:
    return [e.label for e in block.equations] == ["virtual-work"]


def contact_once(step: Step) -> Step:
    """Conditions of contact, without repeating a force that has just been given."""
    boxed = [e for b in step.body if isinstance(b, Display) and b.boxed for e in b.equations]
    known = {e.sides[-1] for e in boxed if isinstance(e.sides[-1], sp.Expr)}
    body: list[Block] = []
    for block in step.body:
        before = body[-1] if body else None
        leads = isinstance(before, Prose) and index_of(Purpose.THAT_IS, before.parts[-1:]) is not None
        again = isinstance(block, Display) and not block.boxed and all(e.sides[0] in known for e in block.equations)
        if leads and again and isinstance(before, Prose):
            body[-1] = replace(before, parts=(*before.parts[:-1], "."))
        else:
            body.append(block)
    return replace(step, body=tuple(body))


# -- a path that the coordinates describe ------------------------------------------------------------------------------
#
# Where r(q) satisfies a constraint by itself, no constraint stands for its force. If the file names a unit vector n
# with n·∂r/∂q = 0, the reaction of a smooth curve or surface is along n, and R·n = m r''·n − F·n is all of it.


def without_idle(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps without the work of a constraint that exerts no force, where the path is kept by another."""
    if reaction_along_normal(solution) is None:
        yield from steps
        return
    names = constraints_called(c.row.name for c in solution.classification.constraints)
    for step in steps:
        if step.rule is Rule.PRINCIPLE and isinstance(step.body[0], Prose):
            idle = f"{capital(names)} only says what a coordinate means, and no force maintains it. "
            kept, where = the(solution.own.configuration.points[0].name), _where_it_moves(solution)
            words = prose(
                f"{idle if solution.classification.constraints else ''}The force that keeps {kept} on its {where} is "
                f"normal to the {where}: it does no virtual work, and drops out of Newton's law multiplied by the "
                "virtual displacement:"
            )
            yield replace(step, body=(words, *step.body[1:]))
        elif step.rule not in (Rule.REACTIONS, Rule.WORKLESS):
            yield step


def _where_it_moves(solution: Solution) -> str:
    """What a particle moves on that has a normal to all of its displacements."""
    return "path" if solution.classification.degrees_of_freedom == 1 else "surface"


def reaction_along_normal(solution: Solution) -> Step | None:
    """R·n of the only particle; None without a unit vector n that is normal to all of its displacements."""
    reaction = path_reaction(solution)
    if reaction is None:
        return None
    [point] = solution.own.configuration.points
    n, moved = VectorSymbol(reaction.normal), VectorSymbol(f"r_{point.name}''")
    is_free = sum((f.vector.fixed() for f in solution.own.configuration.loads), Vector.zero()).is_zero
    applied = sp.S.Zero if is_free else DotProduct(VectorSymbol(f"F_{point.name}"), n)
    sides = (DotProduct(VectorSymbol(f"R_{point.name}"), n), point.mass * DotProduct(moved, n) - applied,
             with_common_factor(reaction.value))  # fmt: skip
    line = display(Equation(sides, label=f"normal-{point.name}"), boxed=True, detail=Detail.BRIEF)
    kept = f"{the(point.name)} on its {_where_it_moves(solution)}"
    words = prose("The force ", math(VectorSymbol(f"R_{point.name}")), f" that keeps {kept} is along its normal ",
                  math(n), ". By Newton's law it is")  # fmt: skip
    return Step(Rule.SOLVED_REACTIONS, "The reaction", (words, line))
