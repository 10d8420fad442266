"""Recognising equations that are not equations of motion but are related to one: squares, first integrals, ...

Not linear in the accelerations: at the accelerations u* of the motion, and in a direction v from there,

    e(u* + s v) = s² e(u* + v)  for all s:  a square, if the quadratic form has rank 1, else a sum of squares;
    e(u*) = 0 alone:                        it holds for the motion, and perhaps for others.

Without accelerations: the time derivative of a first integral F = const follows from the equations, dF/dt = Σ c_k E_k.
F is the energy if the ratios c_k/q_k' do not depend on the velocities, and a momentum if it is linear in them. A
constant that only the answer has is solved for first: φ' = L/(m r²) becomes m r² φ' = L. Everything is tested exactly
at random states.

Statements that hold for the motion from the initial state of the file, and not for every motion.

A normal force as a function of the position alone, N = m g (3 cos θ − 2 cos α), follows with the energy that the motion
has from the start, E(q, q') = E(q_0, q'_0). This relation is linear in some parameter that occurs in no constraint,
mostly g or a stiffness: replaced by its value from the relation, in the statement and in the equations of motion, it
leaves position and velocity free, and both are compared as ever, exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.answers.limits import MAX_POWER, STATES
from lagrange.answers.verdicts import AnswerVerdict, Recognised, Verdict
from lagrange.core.diagnostics import ProblemError
from lagrange.core.symbols import CONSTANT, Sign, base, prime, t
from lagrange.mechanics.dynamics.comparison import Standing, System, affine_rows, compare, random_state, symbols_of

if TYPE_CHECKING:
    from lagrange.mechanics.results import InCoordinates, Solution


def recognised(equation: sp.Expr, system: System, *, linear: bool) -> Recognised:
    """The kind of an equation that does not follow from a system; `linear`: in the accelerations and multipliers."""
    slots = system.configuration.slots
    unknowns = {*slots.accelerations, *system.multipliers}
    used = equation.free_symbols
    if not linear:
        return _at_states(lambda p: _not_linear(p, equation, system), (equation,), system) or Recognised.NOT_LINEAR
    if used & unknowns:
        return Recognised.OTHER
    if not used - {CONSTANT}:
        return Recognised.IMPOSSIBLE
    if not used & {*slots.coordinates, *slots.velocities, t, CONSTANT}:
        return Recognised.OF_PARAMETERS
    if used & {*slots.velocities}:
        for integral in (equation, *_solved_for_constants(equation, system)):
            kind = _integral(integral, system)
            if kind is not None:
                return kind
    return Recognised.NO_ACCELERATION


def _at_states(
    evaluate: Callable[[Point], Recognised], expressions: Sequence[sp.Expr], system: System
) -> Recognised | None:
    """The kind found at random states, if all agree; None otherwise."""
    symbols = symbols_of((*expressions, *system.equations, *system.accelerated_constraints))
    configuration = system.configuration
    try:
        kinds = configuration.states.sampled(lambda p: evaluate(random_state(p, configuration, symbols)), STATES)
    except (NoPointError, UnsupportedError, DivisionByZeroError):
        return None
    return kinds[0] if len(set(kinds)) == 1 else None


def _not_linear(moving: Point, equation: sp.Expr, system: System) -> Recognised:
    """The kind of an equation that is not linear in the unknowns, at one state.

    A power k is recognised by e(u* + s v) = s^k e(u* + v) at s = 2 and 3. A quadratic form Q has rank 1 if and only if
    its bilinear form satisfies B(v, w)² = Q(v) Q(w), here with 2 B = Q(v + w) − Q(v) − Q(w) and random v, w.
    """
    unknowns = (*system.multipliers, *system.configuration.slots.accelerations)
    rows = affine_rows(moving, (*system.accelerated_constraints, *system.equations), unknowns)
    reduce, vanishes = moving.arithmetic.reduce, moving.arithmetic.vanishes
    right = [reduce(-r[-1]) for r in rows]
    motion = moving.solution([r[:-1] for r in rows], right, [moving.random() for _ in unknowns])
    if motion is None:
        raise InadmissibleError

    def at(direction: Sequence[Any], s: int) -> Any:
        u = [reduce(a + s * v) for a, v in zip(motion, direction, strict=True)]
        return moving.with_values(dict(zip(unknowns, u, strict=True))).value(equation)

    def equal(a: Any, b: Any) -> bool:
        return bool(vanishes(reduce(a - b)))

    v, w = ([moving.random() for _ in unknowns] for _ in range(2))
    if not vanishes(at(v, 0)):
        return Recognised.NOT_LINEAR
    once = at(v, 1)
    for k in range(2, MAX_POWER + 1):
        if equal(at(v, 2), 2**k * once) and equal(at(v, 3), 3**k * once):
            if k > 2:
                return Recognised.POWER
            mixed = reduce(at([reduce(a + b) for a, b in zip(v, w, strict=True)], 1) - once - at(w, 1))
            return Recognised.SQUARE if equal(mixed * mixed, 4 * once * at(w, 1)) else Recognised.SUM_OF_SQUARES
    return Recognised.HOLDS


def _solved_for_constants(equation: sp.Expr, system: System) -> list[sp.Expr]:
    """The functions F if an equation states that F(q, q') is a constant that the system does not have."""
    slots = system.configuration.slots
    known = {*symbols_of(system.equations), *slots.coordinates, *slots.velocities, *slots.prescribed, t}
    functions = []
    equation = _squared(equation, equation.free_symbols - known)
    for c in sorted(equation.free_symbols - known, key=str):
        slope = equation.diff(c)
        if slope != 0 and c not in slope.free_symbols and not isinstance(c, Sign):
            functions.append(sp.Mul(sp.Add(equation, sp.Mul(-1, slope, c)), sp.Pow(slope, -1)).xreplace({c: sp.S.Zero}))
    return functions


def _squared(equation: sp.Expr, constants: set[sp.Symbol]) -> sp.Expr:
    """a² − b² for a + b, if only b contains a constant, under a square root: θ' = √(2 (E + g/l cos θ))."""
    rooted = [e for e in sp.Add.make_args(equation) if e.free_symbols & constants]
    if len(rooted) != 1 or not any(p.exp == sp.S.Half and p.free_symbols & constants for p in rooted[0].atoms(sp.Pow)):
        return equation
    return sp.Add(sp.Pow(sp.Add(equation, -rooted[0]), 2), -(rooted[0] ** 2))


def _integral(function: sp.Expr, system: System) -> Recognised | None:
    """The kind of first integral that a function is; None if it is none, or that is undecided."""
    slots = system.configuration.slots
    rate = slots.time_derivative(function)
    if not rate.free_symbols & {*slots.accelerations}:
        return None
    try:
        compared = compare([rate], system)
    except DivisionByZeroError:
        return None
    if compared is None or compared.standings != (Standing.FOLLOWS,):
        return None
    return _at_states(lambda p: _kind(p, function, rate, system), (function, rate), system) or Recognised.INTEGRAL


def _kind(moving: Point, function: sp.Expr, rate: sp.Expr, system: System) -> Recognised:
    """Energy, momentum or another, at one position, with two random velocities."""
    velocities = system.configuration.slots.velocities
    if moving.affine([function], velocities) is not None:
        return Recognised.MOMENTUM
    again = random_state(moving, system.configuration, ())
    first, second = (_over_velocities(p, rate, system) for p in (moving, again))
    return Recognised.ENERGY if first is not None and first == second else Recognised.INTEGRAL


def _over_velocities(moving: Point, rate: sp.Expr, system: System) -> list[Any] | None:
    """The ratios c_k/q_k' in dF/dt = Σ c_k E_k, one for each coordinate that moves."""
    unknowns = (*system.multipliers, *system.configuration.slots.accelerations)
    velocities = system.configuration.slots.velocities
    *known, row = affine_rows(moving, (*system.equations, *system.accelerated_constraints, rate), unknowns)
    c = moving.solution([list(column) for column in zip(*known, strict=True)], row)
    if c is None or len(system.equations) != len(velocities):
        return None
    arithmetic = moving.arithmetic
    pairs = zip(c, moving.values(velocities), strict=False)
    return [arithmetic.reduce(x * arithmetic.inverse(v)) for x, v in pairs if not arithmetic.vanishes(v)]


# Initial integrals


FROM_THE_START = "it holds for the motion from the given initial state"


def relation_from_start(solution: Solution, view: InCoordinates) -> sp.Expr | None:
    """What vanishes in every state after the initial one: the energy less its first value. None: not known."""
    from lagrange.mechanics.questions.states import MotionView, initial_state

    if not solution.problem.initial or view.dynamics is None or view.conserved is None or solution.law is None:
        return None
    integral = next((i for i in view.conserved.integrals if i.constant is True and i.quantity.value == "energy"), None)
    if integral is None:
        return None
    place = MotionView(view.dynamics, view.conserved, solution.law)
    try:
        initial = initial_state(place, solution.problem, [v.configuration for v in solution.views])
    except ProblemError:
        return None
    value = integral.expression.xreplace({t: sp.S.Zero, **initial})
    return None if value.free_symbols & {*place.moving} else integral.expression - value


def holds_from_start(
    claims: Sequence[sp.Expr], written: Sequence[sp.Expr], relation: sp.Expr, system: System, forces: Collection[str]
) -> bool:
    """Whether claims in the coordinates of a system hold for the motion from the initial state.

    written   the same as the answer has them: about a reaction, or an energy, or with a parameter of the initial state
    relation  what vanishes in every state after the initial one
    forces    the names of reactions

    Other equations must hold in every state.
    """
    slots = system.configuration.slots
    known = (e.free_symbols for e in system.equations)
    of_start = relation.free_symbols.difference({t, *slots.coordinates, *slots.velocities}, *known)
    if any(e.free_symbols.isdisjoint(of_start) and not _may_depend_on_start(e, forces) for e in written):
        return False
    rule = _rule(relation, system)
    if not rule:
        return False
    on_the_way = replace(system, equations=tuple(e.xreplace(rule) for e in system.equations))
    try:
        result = compare([e.xreplace(rule) for e in claims], on_the_way)
    except DivisionByZeroError:
        return False
    bad = {Standing.CONTRADICTS, Standing.NOT_LINEAR}
    return result is not None and not bad & {*result.standings}


def _may_depend_on_start(e: sp.Expr, forces: Collection[str]) -> bool:
    if any(s.name in forces for s in e.free_symbols):
        return True
    rates = {s for s in e.free_symbols if base(s) != s}
    return bool(rates) and all(s == prime(base(s)) for s in rates)


def _rule(relation: sp.Expr, system: System) -> dict[sp.Symbol, sp.Expr]:
    """A parameter in which the relation is linear, and its value from it; empty if there is none."""
    slots, rows = system.configuration.slots, system.configuration.rows
    bound = {t, *slots.coordinates, *slots.velocities, *slots.accelerations, *system.multipliers}
    bound = bound.union(*(e.free_symbols for r in rows for e in (*r.coefficients, r.drift)))
    bound = bound.union(*(e.free_symbols for e in system.configuration.finite_constraints))
    in_motion = set().union(*(e.free_symbols for e in system.equations))
    for p in sorted((relation.free_symbols & in_motion) - bound, key=lambda s: (s.name != "g", s.name)):
        slope = sp.diff(relation, p)
        if p not in slope.free_symbols and slope != 0:
            return {p: -relation.xreplace({p: sp.S.Zero}) / slope}
    return {}


def integrals_apart(verdict: AnswerVerdict) -> AnswerVerdict:
    """The verdict on wrong equations of motion without that on first integrals beside them, which may be right."""
    wrong = [e for e in verdict.equations if e.verdict is Verdict.WRONG]
    integrals = [e for e in wrong if e.kind is not None and e.kind.is_first_integral]
    if not integrals or len(integrals) == len(wrong):
        return verdict
    judged = (replace(e, verdict=Verdict.TRIVIAL) if e in integrals else e for e in verdict.equations)
    return replace(verdict, equations=tuple(judged))
