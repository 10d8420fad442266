"""The equations of motion as a page derives them: kinematics in one display, coordinates and equations in one step.

Pages that end with quasi-velocities, without the long equations in the file's coordinates.

D'Alembert's principle is stated in vectors and written out once, in the quasi-velocities. Multipliers of constraints
that are not single forces say little: for a single body the whole reaction is R = m r'' − F, with the acceleration
known. Energies and reactions are written in the quasi-velocities where that is shorter: what the constraints make zero
is gone then, and (M + 2m) (y'' cos θ − x'' sin θ) is (M + 2m) v ω.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import DotProduct, Slots, TimeDerivative, VectorSymbol, prime, variation
from lagrange.core.vectors import FIXED, Vector
from lagrange.document.derivation import (
    Block,
    Display,
    Emphasis,
    Equation,
    EquationKind,
    Math,
    Mathematics,
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
    prose,
)
from lagrange.explain.displacements import of_points, pivot_conditions, solved_displacements
from lagrange.explain.limits import LONGEST_DISPLACEMENT, LONGEST_MULTIPLIER, LONGEST_SUM
from lagrange.explain.motion import accelerations_of
from lagrange.explain.page.system import are_short
from lagrange.explain.words import plural, suffix_of, the, title_in
from lagrange.mechanics.constraints.displacements import Elimination, virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import DalembertMotion, EquationsOfMotion, excluding
from lagrange.mechanics.path_reaction import reaction_along
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import with_common_factor
from lagrange.mechanics.rewriting.quasi_velocities import rates_by_speeds, substituted
from lagrange.mechanics.rewriting.readable_forms import has_plain_accelerations
from lagrange.problem.model import Problem

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm


def displacements_shortly(step: Step) -> Step:
    """The displacements without those of points that are merely δx i + δy j."""
    body = list(step.body)
    for n, block in enumerate(body):
        if n and isinstance(block, Display) and all(_is_plain(e) for e in block.equations):
            body[n - 1 : n + 1] = []
            break
    return replace(step, body=tuple(body)) if body else step


def without_lecture(step: Step) -> Step:
    """Lagrange's equations with no more than the first sentence of why T is not reduced before it is differentiated."""
    return replace(step, body=tuple(map(_without_reasons, step.body)))


def _without_reasons(block: Block) -> Block:
    if not has_purpose(block, Purpose.NOT_SUBSTITUTED):
        return block
    end = index_of(Purpose.REASON, block.parts)
    return block if end is None else prose(*block.parts[: end + 1])


def displacements_of_geometric(configuration: Configuration, elimination: Elimination) -> Step:
    """Where constraints are free of time, virtual displacements satisfy them as possible ones do."""
    slots, rows = configuration.slots, configuration.rows
    lines = (
        Equation(
            (virtual_displacement(r, slots), sp.S.Zero),
            label=f"virtual-{r.name}",
            kind=EquationKind.VIRTUAL,
            about=r.name,
        )
        for r in rows
    )
    body = (
        prose("Time does not appear in ", *listed(Ref(f"form-{r.name}") for r in rows),
              f": virtual displacements satisfy {plural(len(rows), 'it', 'them')} too,", purpose=Purpose.TIMELESS),
        display(*lines),
        *solved_displacements(elimination, configuration),
        *of_points(configuration, elimination, at_once=True),
    )  # fmt: skip
    return Step(Rule.DISPLACEMENTS, "Virtual displacements", body)


def _is_plain(equation: Equation) -> bool:
    value = equation.sides[-1]
    named = equation.kind is EquationKind.DELTA
    return named and isinstance(value, Vector) and all(c == 0 or c.is_Function for c in value.components)


def with_kinematics(step: Step, motion: DalembertMotion) -> Step:
    """Newton's law after the accelerations that occur in it, unless they are linear in ẍ, ÿ, ..."""
    kinematics = accelerations_of(motion)
    lines = [e for b in kinematics if isinstance(b, Display) for e in b.equations]
    if not lines or all(_is_linear(e, motion.configuration.slots) for e in lines):
        return step
    return replace(step, body=(*kinematics, *step.body))


def principle_shortly(step: Step, coordinates: frozenset[object], *, known: bool) -> Step:
    """The principle without accelerations that are merely ẍ i + ÿ j, or `known` from Newton's law."""
    body = list(step.body)
    for n, block in enumerate(body):
        if not n or not isinstance(block, Display):
            continue
        kinematic = block.is_of(EquationKind.ACCELERATION, EquationKind.MOMENTUM_RATE)
        if (known and kinematic) or all(_is_evident(e, coordinates) for e in block.equations):
            body[n - 1 : n + 1] = []
            at = next(k for k, b in enumerate(body) if has_purpose(b, Purpose.WRITTEN_OUT))
            before, after = body[at - 1], body[at + 1]
            if isinstance(before, Display) and isinstance(after, Display):
                body[at - 1 : at + 2] = [display(*before.equations, *after.equations)]
            break
    return replace(step, body=tuple(body))


def _is_evident(equation: Equation, accelerations: frozenset[object]) -> bool:
    value = equation.sides[-1]
    named = equation.kind is EquationKind.ACCELERATION
    return named and isinstance(value, Vector) and all(c == 0 or c in accelerations for c in value.components)


def _is_linear(equation: Equation, slots: Slots) -> bool:
    """Whether an acceleration has accelerations of coordinates with constant coefficients as components."""
    value = equation.sides[-1]
    if not isinstance(value, Vector) or value.triad != FIXED:
        return False
    return has_plain_accelerations(value, slots)


def with_displacements(step: Step, motion: DalembertMotion) -> Step:
    """The equations in the file's coordinates, after the dependent displacements, where no step before has them."""
    rows, slots = motion.configuration.rows, motion.configuration.slots
    solved = motion.elimination.solved(slots)
    if not rows or not solved:
        return step
    if any(count_operations(value) > LONGEST_DISPLACEMENT for value in solved.values()):
        return replace(step, body=(*solved_displacements(motion.elimination, motion.configuration), *step.body))
    pivots = pivot_conditions(motion.elimination)
    where: tuple[Part, ...] = (Phrase(" where ", Purpose.WHERE), *pivots) if pivots else ()
    by = ("By ", *listed(Ref(f"virtual-{r.name}") for r in rows))
    follows = step.body[1] if len(step.body) > 1 else None
    is_whole = isinstance(follows, Display) and follows.equations[0].kind is EquationKind.REDUCED
    after: tuple[Part, ...] = ("and ", Ref("written-out"), " becomes") if is_whole else ("remain.",)
    if len(solved) == 1 and is_whole:
        [(d, e)] = solved.items()
        return replace(step, body=(prose(*by, ", ", math(d, e), *where, ", ", *after), *step.body[1:]))
    lines = display(*(Equation((d, e)) for d, e in solved.items()))
    rest = (prose(*after), *step.body[1:]) if is_whole else step.body
    return replace(step, body=(prose(*by, *(",", *where, ",") if where else ","), lines, *rest))


def without_long_sum(step: Step, motion: DalembertMotion) -> Step:
    """The equations without a long sum over all displacements before them, whose brackets they are."""
    body = list(step.body)
    for n, block in enumerate(body):
        if not isinstance(block, Display) or block.equations[0].kind is not EquationKind.REDUCED:
            continue
        if count_operations(motion.reduced) > LONGEST_SUM:
            coordinates = motion.configuration.slots.coordinates
            solved = listed(math(variation(coordinates[d])) for d in motion.elimination.dependent)
            suffix = suffix_of(motion.configuration.name)
            body[n - 1 : n + 1] = [prose("Substitute for ", *solved, " in ", Ref(f"written-out{suffix}"), ".")]
        break
    return replace(step, body=tuple(body))


def with_conditions(step: Step, motion: EquationsOfMotion) -> Step:
    """The boxed equations with what must not vanish for them to determine the motion."""
    excluded = excluding(motion)
    if not excluded:
        return step
    return replace(step, body=tuple(_conditional(b, excluded, motion) for b in step.body))


def _conditional(block: Block, excluded: Sequence[sp.Expr], motion: EquationsOfMotion) -> Block:
    """A boxed display of equations of motion, each condition at its equation; after the last those of several."""
    if not isinstance(block, Display) or not block.boxed:
        return block
    places = [
        n for n, e in enumerate(block.equations) if e.kind in (EquationKind.MOTION, EquationKind.MOTION_IN_SPEEDS)
    ]
    if not places:
        return block
    at: dict[int, list[sp.Expr]] = {}
    for e in excluded:
        owners = [] if e in motion.elimination.pivots or len(places) != len(motion.final) else [
            n for n, equation in zip(places, motion.final, strict=True) if e in equation.factor.nonzero]  # fmt: skip
        at.setdefault(owners[0] if len(owners) == 1 else places[-1], []).append(e)
    equations = list(block.equations)
    for n, those in at.items():
        where = (Phrase("where ", Purpose.WHERE), *listed(math(e, sp.S.Zero, relation="≠") for e in those))
        equations[n] = replace(equations[n], condition=where)
    return replace(block, equations=tuple(equations))


def in_one_step(coordinates: Step, equations: Step) -> tuple[Step, Step]:
    """Generalized coordinates and the equations in them under one title."""
    choice = title_in("", coordinates.choice)
    first, second = (step.title.removesuffix(choice) for step in (coordinates, equations))
    title = f"{first} and {second[:1].lower()}{second[1:]}{choice}"
    body = tuple(
        replace(b, equations=paired(b.equations)) if isinstance(b, Display) and are_short(b.equations) else b
        for b in coordinates.body
    )
    return replace(coordinates, title=title, body=body), replace(
        equations, title="", body=tuple(_merged(equations.body))
    )


def _merged(body: Sequence[Block]) -> list[Block]:
    """The accelerations and virtual displacements of points in one display."""
    places = [n for n, b in enumerate(body) if isinstance(b, Display) and _is_kinematic(b)]
    if len(places) != 2 or places[1] != places[0] + 2:
        return [*body]
    first, second = (body[n] for n in places)
    assert isinstance(first, Display)
    assert isinstance(second, Display)
    lines = (*first.equations, *second.equations)
    whose = plural(len(first.equations), "The acceleration and the virtual displacement are", "The accelerations and "
                   "the virtual displacements are")  # fmt: skip
    return [*body[: places[0] - 1], prose(whose), display(*lines), *body[places[1] + 1 :]]


def _is_kinematic(block: Display) -> bool:
    return block.is_of(EquationKind.ACCELERATION, EquationKind.DELTA)


def without_multipliers(step: Step) -> Step:
    """The equations without those with multipliers, where Newton's law has given the same."""
    body = list(step.body)
    at = next((n for n, b in enumerate(body) if has_purpose(b, Purpose.MULTIPLIERS)), None)
    return step if at is None else replace(step, body=tuple(body[:at] + body[at + 2 :]))


def without_detour(solution: Solution, steps: Sequence[Step], is_detour: Callable[[Step], bool]) -> list[Step]:
    """The steps in the file's coordinates without what only the equations of motion there would need.

    These are folded, and take the principle written out with them; the dependent displacements are not needed.
    """
    own = solution.own
    if own.dynamics is None or not any(is_detour(step) for step in steps):
        return [*steps]
    unused: list[Block] = []
    if own.configuration.rows:
        unused = [*solved_displacements(own.elimination, own.configuration),
                  *of_points(own.configuration, own.elimination, at_once=True)]  # fmt: skip
    moved: list[Block] = []
    kept: list[Step] = []
    for step in steps:
        if step.choice:
            kept.append(step)
        elif step.rule is Rule.DISPLACEMENTS:
            body = tuple(b for b in step.body if b not in unused)
            kept += [replace(step, body=body)] if body else []
        elif step.rule is Rule.PRINCIPLE:
            body, moved = _without_coordinates(step.body)
            kept.append(replace(step, body=body))
        elif is_detour(step):
            kept.append(replace(step, body=(*moved, *step.body)))
            moved = []
        else:
            kept.append(step)
    return kept


def _without_coordinates(body: Sequence[Block]) -> tuple[tuple[Block, ...], list[Block]]:
    """The principle in vectors, and the rest of its step."""
    at = next((n for n, b in enumerate(body) if isinstance(b, Display)), None)
    if at is None:
        return tuple(body), []
    shown = body[at]
    assert isinstance(shown, Display)
    vectors = tuple(e for e in shown.equations if e.label == "principle")
    others = tuple(e for e in shown.equations if e.label != "principle")
    if not vectors:
        return tuple(body), []
    rest: list[Block] = [prose("Written out, the principle reads"), replace(shown, equations=others)] if others else []
    return (*body[:at], replace(shown, equations=vectors)), [*rest, *body[at + 1 :]]


# Quasi velocities


def ends_with_speeds(solution: Solution) -> bool:
    """Whether the equations of motion in quasi-velocities are those of the page."""
    own = solution.own
    written = own.dynamics.written if own.dynamics is not None else None
    equations = own.in_speeds.equations if own.in_speeds is not None else None
    return equations is not None and isinstance(written, DalembertMotion) and not solution.choices


def in_speeds_only(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps without the principle written out in the file's coordinates, and what else is not needed then."""
    for step in steps:
        if step.rule is Rule.PRINCIPLE:
            yield replace(step, body=step.body[:2])
        elif step.rule is Rule.DISPLACEMENTS:
            unused = solved_displacements(solution.own.elimination, solution.own.configuration)
            yield replace(step, body=tuple(b for b in step.body if b not in unused))
        elif step.rule is Rule.SOLVED_REACTIONS and _are_long(solution):
            continue
        elif step.rule is Rule.QUASI_VELOCITIES:
            yield replace(step, body=tuple(_without_rates(solution, b) for b in step.body))
        else:
            yield step


_AFTER_MOTION = (Rule.RESULT, Rule.SOLVED_REACTIONS, Rule.CONSERVED, Rule.MEANING)


def short_in_speeds(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with energies and reactions in the quasi-velocities and their rates, where that is shorter."""
    form = solution.own.in_speeds
    rule = {} if form is None or not ends_with_speeds(solution) else rates_by_speeds(solution.problem.slots, form)

    known: set[str] = set()  # of the head, which comes before the quasi-velocities are defined
    plain: dict[sp.Expr, sp.Expr] = {}  # and has a velocity itself, where a quasi-velocity is one

    def side(value: Mathematics) -> Mathematics:
        if not isinstance(value, sp.Expr) or not value.has(*rule) or count_operations(value) > LONGEST_MULTIPLIER:
            return value
        if isinstance(value, TimeDerivative):
            return TimeDerivative(side(value.args[0]))
        shorter = substituted(value, rule).xreplace(plain)
        new = {s.name.rstrip("'") for s in shorter.free_symbols - value.free_symbols}
        return shorter if count_operations(shorter) < count_operations(value) and not new - known else value

    def block(b: Block) -> Block:
        if isinstance(b, Display):
            return replace(b, equations=tuple(replace(e, sides=tuple(map(side, e.sides))) for e in b.equations))
        if isinstance(b, Prose):
            parts = (replace(p, sides=tuple(map(side, p.sides))) if isinstance(p, Math) else p for p in b.parts)
            return replace(b, parts=tuple(parts))
        return b

    speeds = set() if form is None else {u.name for u in form.velocities.symbols}
    for step in steps:
        known |= _names(step) if step.rule is Rule.RESULT else speeds
        plain = _plain(form) if step.rule is Rule.RESULT and form is not None else {}
        after = rule and step.rule in _AFTER_MOTION and not step.folded
        yield replace(step, body=tuple(map(block, step.body))) if after else step


def _plain(form: QuasiVelocityForm) -> dict[sp.Expr, sp.Expr]:
    """The quasi-velocities that are the velocity of a coordinate, with it, and their rates: ω = θ'."""
    pairs = {u: v for u, v in form.velocities.definitions.items() if isinstance(v, sp.Symbol)}
    return {**pairs, **{prime(u): prime(v) for u, v in pairs.items()}}


def _names(step: Step) -> set[str]:
    """The letters in the equations of a step, of u' that of u."""
    sides = [s for b in step.body if isinstance(b, Display) for e in b.equations for s in e.sides]
    return {s.name.rstrip("'") for side in sides if isinstance(side, sp.Expr) for s in side.free_symbols}


def _are_long(solution: Solution) -> bool:
    """Whether the multipliers are no single forces, and long: then the page has no room for them."""
    dynamics, law = solution.own.dynamics, solution.law
    if dynamics is None or dynamics.reactions is None or law is None:
        return False
    nameless = all(r.single is None and r.given is None for r in law.newton.reactions)
    values = [v for v in dynamics.reactions.multipliers.values() if v is not None]
    return (
        nameless
        and reaction_as_a_whole(solution) is None
        and any(count_operations(v) > LONGEST_MULTIPLIER for v in values)
    )


def _without_rates(solution: Solution, block: Block) -> Block:
    """The boxed equations without the kinematic ones, which precede them."""
    form = solution.own.in_speeds
    if not isinstance(block, Display) or not block.boxed or form is None:
        return block
    kinematic = {*form.velocities.kinematic.items()}
    lines = [e for e in block.equations if e.sides not in kinematic]
    if len(kinematic) < 3 or len(lines) == len(block.equations):
        return block
    lines[-1] = replace(lines[-1], condition=("with the kinematic equations",))  # no reference: a brief page has none
    return replace(block, equations=tuple(lines))


def reaction_as_a_whole(solution: Solution) -> Step | None:
    """R = m r'' − F of the only body; None if the multipliers say more, or another force is not in F."""
    own, law = solution.own, solution.law
    configuration = own.configuration
    if law is None or own.dynamics is None or len(configuration.points) != 1 or not configuration.rotations:
        return None
    if solution.long_reactions is not None or configuration.generalized:
        return None
    if configuration.links or configuration.potential != 0 or law.all_frictions or solution.choices:
        return None
    if any(r.single is not None for r in law.newton.reactions) or solution.problem.unknowns:
        return None
    reactions = own.dynamics.reactions
    if reactions is not None and any(
        r.given and reactions.multipliers.get(r.name) is not None for r in law.newton.reactions
    ):
        return None  # what the file has a name for is shown
    [point] = configuration.points
    if configuration.is_pinned(point) or any(f.elsewhere for f in configuration.loads):
        return None
    force = sum((f.vector for f in configuration.loads), Vector.zero())
    reaction, moved = VectorSymbol(f"R_{point.name}"), point.mass * VectorSymbol(f"r_{point.name}''")
    shown = moved - (VectorSymbol(f"F_{point.name}") if not force.is_zero else 0)
    sides = (reaction, shown) if force.is_zero else (reaction, shown, moved - force.as_sum())
    in_speeds = own.in_speeds.equations if own.in_speeds is not None else None
    known: tuple[Part, ...] = ()
    if in_speeds is not None and point.name in in_speeds.accelerations:
        known = ("with ", Ref(f"changed-in-speeds-r_{point.name}''"))
    words = f"By Newton's law the total reaction on {the(point.name)} is"
    line = Equation(sides, label=f"total-reaction-{point.name}", condition=known)
    body: list[Block] = [prose(words), display(line, boxed=True)]
    body += _across(solution, reaction)
    return Step(Rule.SOLVED_REACTIONS, "The reaction", tuple(body))


def _across(solution: Solution, reaction: VectorSymbol) -> Iterator[Block]:
    """The vertical component, if there is gravity."""
    gravity = solution.problem.gravity
    along = [n for n, c in enumerate(gravity.fixed().components) if c != 0] if gravity is not None else []
    if len(along) != 1:
        return
    [n] = along
    unit = Vector.zero().triad.units[n]
    x, y, z = (sp.Integer(k == n) for k in range(3))
    value = reaction_along(Vector((x, y, z)), solution.own.configuration)
    yield prose("Its vertical component is")
    yield display(Equation((DotProduct(reaction, unit), with_common_factor(value)), label="vertical-reaction"))


# -- by quadratures -----------------------------------------------------------------------------------------------


def by_quadrature(problem: Problem, form: QuasiVelocityForm | None) -> Iterator[Block]:
    """`Motion: v̇ contains the time only, so v = v₀ + ..., and from ẋ = v cos Ωt`, with the coordinates."""
    if form is None:
        return
    from lagrange.mechanics.integrated_speed import integrated_speed

    motion = integrated_speed(form, problem.scope.names())
    if motion is None:
        return
    lines = [Equation((s, value), label=f"quadrature-{s.name}") for s, value in motion.values.items()]
    whole = plural(len(lines), "a constant ", "constants ")
    yield prose(Emphasis("Motion"), ": ", math(prime(motion.speed)), f" contains the time only. With {whole}",
                *listed(map(math, motion.constants)), ", integration gives")  # fmt: skip
    yield display(*lines)
