"""The meaning of the result, in a few paragraphs, each under a keyword: energy, rest, small motion, limits, units."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import CONSTANT, CrossProduct, UnitVector, Unspecified, VectorSymbol, base, prime
from lagrange.document.derivation import (
    Block,
    Display,
    Emphasis,
    Equation,
    EquationKind,
    Part,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    index_of,
    listed,
    math,
    prose,
    series,
)
from lagrange.explain.beside_answers import explain_closing, explain_driven_momenta
from lagrange.explain.consequences import explain_consequences
from lagrange.explain.energy.conservation import explain_conserved, proof_of
from lagrange.explain.limits import LONGER_SOLVED, LONGEST_CONSERVED_LINE, MOST_MULTIPLIERS
from lagrange.explain.motion import label_from_principle
from lagrange.explain.page.conclusions.course import explain_released, explain_sense, explain_swinging
from lagrange.explain.page.conclusions.limiting import explain_limit, explain_massless
from lagrange.explain.page.motion import by_quadrature
from lagrange.explain.page.names import with_named_denominators
from lagrange.explain.statement import raised
from lagrange.explain.words import plural, suffix_of
from lagrange.mechanics.circular_motion import Turning
from lagrange.mechanics.consequences.course import swinging_rate
from lagrange.mechanics.dynamics.conservation import Conserved, ConservedQuantity, Integral, quantity_of
from lagrange.mechanics.meaning import ResultMeaning
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.rewriting.factors import in_factors
from lagrange.mechanics.rewriting.held_coordinates import held_values, in_remaining_velocities, where_held
from lagrange.mechanics.rewriting.integrals import EnergyExcess, energy_excess, is_multiple_of, without_constants
from lagrange.mechanics.rewriting.quasi_velocities import Course, StatedEquations, one_way
from lagrange.mechanics.rewriting.readable_forms import are_same_equations
from lagrange.problem.model import Problem

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.linearization import Linearization


def explain_meaning(
    meaning: ResultMeaning,
    conserved: Step | None,
    stated: StatedEquations = (),
    labels: Collection[str | None] | None = None,
    problem: Problem | None = None,
    *,
    finite: bool = False,
    plain: StatedEquations = (),
) -> Step | None:
    """The step; None if there is nothing to say.

    conserved  the step of the full derivation on the conserved quantities
    stated     the equations of motion in another form, known to be right
    labels     of the equations on the page; None: all of them
    problem    for its initial state
    plain      the stated equations without names for quantities
    finite     whether the constraints are finite relations: of momenta that these bind nothing is said
    """
    choice = meaning.view.name
    form = meaning.view.in_speeds
    speeds = form is not None and form.equations is not None
    body: list[Block] = [
        *_in_short(meaning, stated, plain or stated),
        *_freed(meaning, stated),
        *_with_held(meaning, stated),
    ]
    body += _conserved(conserved, meaning.view.conserved, labels, stated, unbound=speeds or finite)
    body += explain_driven_momenta(meaning.view)
    body += explain_closing(meaning.view)
    body += _accelerations(meaning)
    body += explain_swinging(swinging_rate(stated, meaning.view))
    body += _one_way(meaning)
    body += by_quadrature(problem, form) if problem is not None else ()
    body += _turning(meaning)
    if meaning.consequences is not None:
        body += explain_consequences(meaning.consequences, meaning.view)
    body += _at_rest(meaning.small)
    body += map(explain_limit, meaning.limits)
    body += explain_massless(meaning.massless)
    body += explain_sense(meaning.sense)
    body += _contact(meaning)
    body += explain_released(meaning.released)
    body += _units(meaning)
    body += _caution(meaning)
    return Step(Rule.MEANING, "What it says", tuple(body), choice) if body else None


def operations_of_equations(stated: StatedEquations) -> int:
    """How many operations it takes to write equations with everything on one side."""
    return sum(count_operations(left - right) for left, *_, right in stated)


def are_solved(view: InCoordinates, stated: StatedEquations, operations: int) -> bool:
    """Whether each stated equation gives one acceleration, and all of them are given, in hardly more operations.

    Then they need no exception, where equations of motion with the constraint beside them need one: x' ≠ 0.
    """
    accelerations = {*view.configuration.slots.accelerations}
    given = [
        ({*left.free_symbols} & accelerations, {*right.free_symbols} & accelerations) for left, *_, right in stated
    ]
    whole = {a for left, _ in given for a in left} == accelerations and len(given) == len(accelerations)
    alone = all(len(left) == 1 and not right for left, right in given)
    return whole and alone and operations_of_equations(stated) <= LONGER_SOLVED * operations


def _at_rest(small: Linearization | None) -> Iterator[Block]:
    if small is None:
        return
    from lagrange.explain.page.conclusions.positions import explain_rest

    yield from explain_rest(small)


def _in_short(meaning: ResultMeaning, stated: StatedEquations, plain: StatedEquations) -> Iterator[Block]:
    """The equations in the form of the answers, where that is the shorter one."""
    motion, form = meaning.view.motion, meaning.view.in_speeds
    if motion is None or not stated or are_same_equations(stated, [e.expression for e in motion.final]):
        return
    if form is not None and form.equations is not None:
        defined = form.velocities.defined
        stated_by_rates = tuple((defined(a), defined(b), *more) for a, b, *more in stated)
        if are_same_equations(stated_by_rates, [defined(e) for e in form.equations.expressions]):
            return
    if all(len(sides) == 2 and meaning.constant.get(sides[0]) == sides[1] for sides in stated):
        return  # they are among the accelerations
    rates = (row.velocity_form(motion.configuration.slots) for row in motion.completing)
    operations = sum(count_operations(e) for e in (*(e.expression for e in motion.final), *rates))
    if operations_of_equations(stated) < operations or (
        motion.completing and are_solved(meaning.view, stated, operations)
    ):
        from lagrange.explain.page.conclusions.combined import explain_combined
        from lagrange.mechanics.rewriting.combinations import combinations

        how = explain_combined(combinations(plain, meaning.view), motion)
        yield prose(Emphasis("In short"), ",", *how, purpose=Purpose.IN_SHORT)
        yield display(*(Equation(sides) for sides in stated), boxed=True)


def _freed(meaning: ResultMeaning, stated: StatedEquations) -> Iterator[Block]:
    """The equations without coordinates of rolling: `Without ψ: ψ'' = −[(R − r)/r] φ'' leaves ...`"""
    freed = meaning.freed
    if freed is None or meaning.constant:
        return
    if stated and are_same_equations(stated, [e.expression for e in freed.equations]):
        return
    accelerations = [math(v, e) for v, e in freed.rates.items() if v not in freed.velocities]
    names = listed(math(base(v)) for v in freed.velocities)
    leaves = plural(len(accelerations), " leaves", " leave")
    yield prose(Emphasis("Without "), *names, Emphasis(":"), " by the constraints, ", *listed(accelerations), leaves)
    yield display(*(Equation((e.expression, sp.S.Zero)) for e in freed.equations), boxed=True)


def _with_held(meaning: ResultMeaning, stated: StatedEquations) -> Iterator[Block]:
    """The equations with constants substituted: `With r = R: R θ'' − g sin θ = 0.`"""
    motion, held = meaning.view.motion, held_values(meaning.view.configuration)
    if motion is None or meaning.constant or not held:
        return
    before = [e.expression for e in motion.final]
    after = [where_held(e, held) for e in before]
    changed = [e for e, old in zip(after, before, strict=True) if e != old and e != 0]
    if changed and not (stated and are_same_equations(stated, after)):
        used = {base(s) for e in before for s in e.free_symbols if s in held}
        values = [math(q, held[q]) for q in sorted(used, key=str)]
        yield prose(Emphasis("With "), *listed(values), ": ", *listed(math(e, sp.S.Zero) for e in changed), ".")


_CALLED = {
    ConservedQuantity.MOMENTUM: "Momentum",
    ConservedQuantity.ANGULAR_MOMENTUM: "Angular momentum",
    ConservedQuantity.ENERGY: "Energy",
    ConservedQuantity.JACOBI: "Jacobi's integral",
}


def _conserved(
    step: Step | None,
    conserved: Conserved | None,
    labels: Collection[str | None] | None,
    stated: StatedEquations = (),
    *,
    unbound: bool,
) -> Iterator[Block]:
    """The conserved quantities, short ones each in a sentence with its proof; otherwise as in the full derivation."""
    if step is None or conserved is None:
        return
    kept = tuple(i for i in conserved.integrals if not _balances_loads(i, conserved))
    several = len(kept) > 1
    telling = tuple(i for i in kept if not _is_seen(i, conserved, stated))
    kept = tuple(without_constants(i, conserved.motion.configuration) for i in telling or kept)
    unbound = unbound or several
    taken = {q for i in kept for q in i.displacement or {}}  # with others they have a momentum that is conserved
    bound = {} if unbound else {q: p for q, p in conserved.bound.items() if q not in taken}
    if kept != conserved.integrals or len(bound) < len(conserved.bound):
        conserved = replace(conserved, integrals=kept, bound=bound)
        made = explain_conserved(conserved, step.choice)
        if made is None:
            return
        step = made
    proofs = [proof_of(conserved, i) for i in conserved.integrals]
    equations = {label_from_principle(conserved.motion, e) for e in conserved.motion.equations}
    proven = labels is None or not conserved.integrals or equations <= {*labels}
    if not proven:  # the equations of motion are folded, or written otherwise
        step = explain_conserved(conserved, step.choice, (), proofs=False) or step
    plain = conserved.energy is None and not conserved.bound and not conserved.undecided
    short = [(i, p) for i, p in zip(conserved.integrals, proofs, strict=True) if _is_short(i)]
    long = tuple(i for i in conserved.integrals if not _is_short(i))
    if not (plain and all(proofs)):
        short, long = [], conserved.integrals
    yield from _in_sentences(short, conserved, proven)
    if short and long:
        step = explain_conserved(replace(conserved, integrals=long), step.choice, (), proofs=proven) or step
    if not short or long:
        step = _without_constant_coordinates(step, conserved)
        step = replace(step, body=tuple(_in_remaining(b, conserved) for b in step.body))
        jacobi = any(i.quantity is ConservedQuantity.JACOBI for i in long)
        yield from _without_accelerations(step.body, energy_excess(conserved) if jacobi else None, step.choice)


def _is_short(integral: Integral) -> bool:
    return count_operations(integral.expression) <= LONGEST_CONSERVED_LINE


def _in_sentences(
    integrals: Iterable[tuple[Integral, Sequence[Part]]], conserved: Conserved, proven: bool
) -> Iterator[Block]:
    """Each integral in a sentence, with its proof where the page has the equations."""
    for integral, proof in integrals:
        if sum(m != 0 for m in integral.multipliers) > MOST_MULTIPLIERS:
            proof = ("a combination of the equations of motion",)
        called = quantity_of(integral, conserved.motion.configuration)
        name = Emphasis(_CALLED[called])
        quantity = math(in_remaining_velocities(integral.expression, conserved.motion), CONSTANT)
        purpose = (
            Purpose.CONSERVED if called in (ConservedQuantity.ENERGY, ConservedQuantity.JACOBI) else Purpose.MOMENTUM
        )
        yield prose(name, ": ", *((*proof, " integrates to ") if proven else ()), quantity, ".", purpose=purpose)


def _is_seen(integral: Integral, conserved: Conserved, stated: StatedEquations) -> bool:
    """Whether it is a spin whose acceleration is zero by one of the equations of motion; a momentum is worth a line.

    With the constraints it may be a multiple of a velocity of which the equations at the head of the page say so.
    """
    steady = [
        prime(base(left))
        for left, *_, right in stated
        if right == 0 and left.is_Symbol and left == prime(base(left), 2)
    ]
    if any(is_multiple_of(integral.expression, v, conserved.motion.configuration) for v in steady):
        return True
    if quantity_of(integral, conserved.motion.configuration) is ConservedQuantity.MOMENTUM:
        return False
    final = {e.expression for e in conserved.motion.equations}
    moving = integral.expression.free_symbols & {*conserved.motion.configuration.slots.velocities}
    return len(moving) == 1 and integral.expression.is_Mul and {prime(base(*moving), 2)} <= final


def _balances_loads(integral: Integral, conserved: Conserved) -> bool:
    """Whether it follows from a displacement in which given moments cancel: M_1 δφ + M_2 δψ = 0.

    That is no symmetry of the system, and holds only while the ratio of the moments stays the same.
    """
    configuration = conserved.motion.configuration
    given = [m.vector for m in configuration.torques] + [f.vector for f in configuration.loads if f.name != "weight"]
    moving = {*configuration.slots.coordinates, *configuration.slots.velocities}
    symbols = {s for v in given for c in v.components for s in c.free_symbols} - moving
    return any(x.free_symbols & symbols for x in (integral.displacement or {}).values())


def _without_constant_coordinates(step: Step, conserved: Conserved) -> Step:
    """The step without the velocities that a constraint keeps zero: no ż² where z is constant."""
    configuration = conserved.motion.configuration
    zero = {
        v: sp.S.Zero
        for row in configuration.rows
        for v, a in zip(configuration.slots.velocities, row.coefficients, strict=True)
        if a != 0 and row.drift == 0 and sum(b != 0 for b in row.coefficients) == 1
    }
    if not zero:
        return step
    return step.map(lambda e: _at(zero, e))


def _in_remaining(block: Block, conserved: Conserved) -> Block:
    """The integrals of a display without velocities that are eliminated from the equations of motion."""
    if not isinstance(block, Display):
        return block
    lines = (
        replace(e, sides=(in_remaining_velocities(e.sides[0], conserved.motion), *e.sides[1:]))
        if e.kind is EquationKind.CONSERVED and isinstance(e.sides[0], sp.Expr)
        else e
        for e in block.equations
    )
    return replace(block, equations=tuple(lines))


def _at(zero: dict[sp.Symbol, sp.Expr], equation: Equation) -> Equation:
    return replace(equation, sides=tuple(_simpler(zero, s) if isinstance(s, sp.Expr) else s for s in equation.sides))


def _simpler(zero: dict[sp.Symbol, sp.Expr], e: sp.Expr) -> sp.Expr:
    """The arguments of functions that are not specified stay as they are."""
    if not e.has(Unspecified):
        return e.xreplace(zero)
    bases = ((a, {f.as_base_exp()[0] for f in sp.Mul.make_args(a)}) for a in sp.Add.make_args(e))
    return sp.Add(*(a for a, factors in bases if not factors & {*zero}))


def _without_accelerations(body: Sequence[Block], beside: EnergyExcess | None, choice: str) -> Iterator[Block]:
    """The conserved quantities; for an energy that is not, no balance with accelerations on its right side.

    beside  what it has in addition to Jacobi's integral, which then says more than a balance
    """
    blocks = list(body)
    for n, block in enumerate(blocks):
        last = block.equations[-1] if isinstance(block, Display) else None
        if last is None or last.kind is not EquationKind.ENERGY_RATE:
            continue
        rate = last.sides[-1]
        if isinstance(rate, sp.Expr) and isinstance(block, Display):  # −μ N (x' + R θ'), the power of friction
            short = replace(last, sides=(*last.sides[:-1], in_factors(rate)))
            blocks[n] = replace(block, equations=(*block.equations[:-1], short))
        before = blocks[n - 1]
        assert isinstance(before, Prose)
        if beside is not None:
            blocks[n - 1 : n + 1] = [_energy_beside(beside, choice)]
            break
        if isinstance(rate, sp.Expr) and any(s.name.endswith("''") for s in rate.free_symbols):
            along = index_of(Purpose.ALONG, before.parts)
            blocks[n - 1 : n + 1] = [replace(before, parts=before.parts[:along])]
            break
    return iter(blocks)


def _energy_beside(e: EnergyExcess, choice: str) -> Prose:
    """`The energy is not conserved: it is (16) plus m Ω² r², and changes at the rate 2m Ω² r r'.`"""
    integral = Ref(f"conserved{suffix_of(choice)}-{e.number}")
    rate: tuple[Part, ...] = () if e.rate is None else (", and changes at the rate ", math(e.rate))
    return prose("The energy is not conserved: it is the left side of ", integral, " plus ", math(e.excess), *rate, ".")


def _accelerations(meaning: ResultMeaning) -> Iterator[Block]:
    """The accelerations, where they are constant."""
    if not meaning.constant:
        return
    whole = len(meaning.constant) == len(meaning.view.configuration.slots.accelerations)
    if whole and not any(meaning.constant.values()):
        yield prose(Emphasis("Accelerations"), ": none; every coordinate changes uniformly.")
        return
    step = Step(Rule.MEANING, "", (display(*(Equation(pair) for pair in meaning.constant.items()), boxed=True),))
    names = {s.name for e in meaning.constant.values() for s in e.free_symbols}
    which = ", all of them constant:" if whole else " that are constant:"
    if whole and len(meaning.constant) == 1:
        yield prose(Emphasis("Acceleration"), ", which is constant:", purpose=Purpose.CONSTANT_RATES)
    else:
        yield prose(Emphasis("Accelerations"), which, purpose=Purpose.CONSTANT_RATES)
    yield from with_named_denominators(step, names).body


_COURSES = {
    Course.GROWS: ("never negative", " only grows"),
    Course.FALLS: ("never positive", " only falls"),
    Course.ONE_SENSE: ("always of the same sign", " moves in one sense"),
}


def _one_way(meaning: ResultMeaning) -> Iterator[Block]:
    """The quasi-velocities whose rate has one sign: `u' = a ω², which is never negative: u only grows`."""
    form = meaning.view.in_speeds
    if form is None:
        return
    for way in one_way(form, meaning.view.configuration.slots, LONGEST_CONSERVED_LINE):
        sign, course = _COURSES[way.course]
        only: tuple[Part, ...] = ()
        if way.still is not None:
            only = (", or is constant while ", math(way.still, sp.S.Zero))
        changes = (math(prime(way.speed), way.rate), f", which is {sign}: ", math(way.speed), course)
        yield prose(Emphasis("One way"), ": ", *changes, *only, ".")


def _turning(meaning: ResultMeaning) -> Iterator[Block]:
    """`Circles: ...: the velocity turns at the rate c`, or the axes in which an oscillation keeps its plane."""
    turning = meaning.turning
    if turning is None:
        return
    pair = (turning.first, turning.second)
    if turning.stiffness is None:
        laws = listed(math(prime(q, 2), a) for q, a in zip(pair, turning.accelerations, strict=True))
        velocity = (math(prime(turning.first)), " and ", math(prime(turning.second)))
        yield prose(
            *(Emphasis("Circles"), ": ", *laws, ". The velocity with the components ", *velocity),
            *(" turns at the constant rate ", math(turning.rate), " and keeps its size, so the motion is uniform, "),
            "on a circle", *_as_a_product(meaning, turning), ".",
        )  # fmt: skip
        return
    order: tuple[Part, ...] = () if turning.small is None else (", to first order in ", math(turning.small))
    letters = [sp.Symbol(name, real=True) for name in _unused(meaning, ("xi", "eta", "X", "Y", "u", "v"))]
    laws = listed(math(prime(q, 2) + turning.stiffness * q, sp.S.Zero) for q in letters)
    yield prose(
        *(Emphasis("Turning"), ": for axes that turn at the rate ", math(turning.rate), " the velocities drop out"),
        *(*order, ": there ", *laws, ". "),
        *_if_bounded(turning),
        "An oscillation along one of these axes stays along it, and turns with it.",
    )


def _if_bounded(turning: Turning) -> tuple[Part, ...]:
    """`They oscillate, and x and y stay bounded, if B² q² > 2 m² w².`"""
    if turning.bounded is None:
        return ()
    pair = (math(turning.first), " and ", math(turning.second))
    condition = math(*turning.bounded, relation=">")
    return ("They oscillate, and ", *pair, " stay bounded, if ", condition, "; otherwise ", *pair, " in general grow. ")


def _as_a_product(meaning: ResultMeaning, turning: Turning) -> tuple[Part, ...]:
    """`; in vectors, v̇ = c k × v`, if the two coordinates are those of a point along two of the fixed unit vectors."""
    pair = (turning.first, turning.second)
    if meaning.view.configuration.slots.prescribed or not _unused(meaning, ("v",)):
        return ()
    for point in meaning.view.configuration.points:
        x, y, z = point.position.components
        for axis, (a, b) in zip("kij", ((x, y), (y, z), (z, x)), strict=True):
            for sign, plane in ((1, (a, b)), (-1, (b, a))):
                if plane == pair:
                    v, normal = VectorSymbol("v"), UnitVector(axis)
                    return ("; in vectors, ", math(VectorSymbol("v'"), sign * turning.rate * CrossProduct(normal, v)))
    return ()


def _unused(meaning: ResultMeaning, names: Sequence[str]) -> list[str]:
    """Two names for coordinates that the problem does not use."""
    motion = meaning.view.motion
    taken = set() if motion is None else {s.name for e in motion.final for s in e.expression.free_symbols}
    return [name for name in names if name not in taken][:2]


def _contact(meaning: ResultMeaning) -> Iterator[Block]:
    """`Contact: N > 0 while θ'² < (g/R) cos θ.`"""
    for end in meaning.ends:
        lasts = math(end.velocity**2, end.square, relation=end.relation)
        yield prose(Emphasis("Contact"), ": ", math(end.force, sp.S.Zero, relation=">"), " while ", lasts, ".")


def _units(meaning: ResultMeaning) -> Iterator[Block]:
    if meaning.terms is None:
        return
    first, other, unit = meaning.terms
    motion = meaning.view.motion
    several = motion is not None and len(motion.final) > 1
    shown: tuple[Part, ...] = (math(other), f" is in {raised(unit)}, as ", math(first), " is.")
    if several:
        shown = (
            f"in the equations of motion every term is in {raised(unit)}, ",
            math(other),
            " like ",
            math(first),
            ".",
        )
    yield prose(Emphasis("Units"), ": ", *shown, purpose=Purpose.UNITS)


def _caution(meaning: ResultMeaning) -> Iterator[Block]:
    """The slip of taking a reaction at rest for the reaction."""
    if not meaning.parts:
        return
    clauses = series(
        (math(p.force), " is not ", math(p.at_rest), ": the motion adds ", math(p.added)) for p in meaning.parts[:1]
    )
    yield prose(Emphasis("Caution"), ": ", *clauses, ".")
