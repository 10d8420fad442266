"""One numerical value of the equations of motion, to be verified on a pocket calculator.

Parameters, positions and velocities get simple numbers; the equations, linear in the accelerations, give those as
numbers. Where constraints bind the coordinates, the dependent ones and their velocities follow from the constraints, so
that the state is a possible one. The parameters get small numbers that differ from one another, because equal ones
would hide interchanged letters. What the file declares positive (the slip in its sense, the force of a contact, the
length of a spring on a line) must be so at the state; positions and velocities are reversed until it is.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations, count, islice, product
from random import Random
from typing import TYPE_CHECKING, Any

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.algebra.exact.expression_graph import Graph
from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.real_points import RealPoint, Reals
from lagrange.algebra.exact.zero_test import InadmissibleError, ZeroDivisorError
from lagrange.core.records import record
from lagrange.core.symbols import Bounded, Sign, Unspecified, counting, symbols_in, t
from lagrange.mechanics.constraints.coordinates import solved_for_one
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import System, affine_rows
from lagrange.mechanics.dynamics.limits import (
    ANGLES_TO_TRY,
    DIGITS,
    LARGEST_DENOMINATOR,
    LARGEST_VELOCITY,
    MOST_DEPENDENT_SETS,
    MOST_ITERATIONS,
    RECOGNISED_DIGITS,
    SPOT_TRIALS,
    ZERO_DIGITS,
)

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.motion import Motion
    from lagrange.problem.model import Problem

TOLERANCE = sp.Float(10) ** -ZERO_DIGITS
"""Smaller numbers are zero."""


@record
class SpotValue:
    """Numbers in, accelerations out (to six figures)."""

    values: Mapping[sp.Symbol, sp.Expr]
    accelerations: Mapping[sp.Symbol, sp.Expr]


def spot_of_motion(motion: Motion, problem: Problem) -> SpotValue | None:
    """A spot value of the equations of motion, with the values of parameters that the file gives.

    If possible with those of its figure too; a linkage may need others than the position that is tried.
    """
    system = System(motion.equations.configuration, motion.equations.expressions)
    given = problem.given_values
    wanted = (*motion.slips, *motion.sliding, *motion.shown.positive)
    drawn = _as_drawn(problem)
    value = spot_value(system, given | drawn, wanted, motion.contacts)
    return spot_value(system, given, wanted, motion.contacts) if value is None and drawn else value


def _as_drawn(problem: Problem) -> dict[sp.Symbol, sp.Expr]:
    """The numbers with which the file draws the system: with these a rocket lifts off."""
    numbers = ((p, problem.figure.at.get(p.symbol.name)) for p in problem.parameters if p.value is None)
    return {p.symbol: value for p, value in numbers if value is not None and value.is_number}


def spot_value(
    system: System,
    given: Mapping[sp.Symbol, sp.Expr],
    positive: Sequence[sp.Expr] = (),
    preferred: Sequence[sp.Expr] = (),
) -> SpotValue | None:
    """A spot value of a system; None if none was found.

    given      the values of parameters in the file, and those of its figure
    positive   functions of position and velocity that the file declares positive
    preferred  others that are positive if possible
    """
    if any(e.has(Unspecified) for e in system.equations):
        return None
    wanted = (*positive, *preferred)
    signs = REVERSED if wanted else REVERSED[:1]
    first: SpotValue | None = None
    for trial, (position, velocity) in product(range(SPOT_TRIALS), signs):
        try:
            value, met = _at(system, given, trial, (position, velocity), wanted)
        except (ValueError, ZeroDivisionError, TypeError, InadmissibleError, ZeroDivisorError):
            continue
        if all(met):
            return value
        if all(met[: len(positive)]):
            first = first or value
    return first


REVERSED = tuple(product((1, -1), (1, -1)))
"""Signs of the positions and velocities that are chosen freely."""


def _at(
    system: System,
    given: Mapping[sp.Symbol, sp.Expr],
    trial: int,
    signs: tuple[int, int],
    wanted: Sequence[sp.Expr],
) -> tuple[SpotValue, list[bool]]:
    """A spot value, and which of the given functions are positive there. Raises ValueError if there is none."""
    configuration = system.configuration
    slots = configuration.slots
    used = set[sp.Symbol]().union(*map(symbols_in, _all_expressions(system)))
    values: dict[sp.Basic, sp.Expr] = {}
    moving = {*slots.coordinates, *slots.velocities, *slots.accelerations}
    fixed = sorted(used - moving, key=lambda s: counting(s.name))
    roots, others = ([s for s in fixed if isinstance(s, Sign) is sign] for sign in (True, False))
    numbers = count(1 + trial)
    angles = _angles(system.equations)
    turn = reversed if trial % 2 == 0 else iter  # √(l² − c²) may want the later letter to be the larger one
    parameters = {s: given.get(s) or _parameter_value(s, numbers, angles.get(s)) for s in turn(others)}
    values |= dict.fromkeys(roots, sp.S.One)
    values |= {s: parameters[s] for s in others}
    unused = set().union(*(e.free_symbols for e in wanted)) - used - moving
    values |= {s: given.get(s) or _parameter_value(s, numbers, angles.get(s)) for s in sorted(unused, key=str)}
    positions = _positions(configuration, values, trial, signs[0], angles)
    if positions is None:
        raise ValueError("no positions")
    values |= positions
    values |= _velocities(configuration, values, trial, signs[1])
    if any(abs(values[v]) > LARGEST_VELOCITY for v in slots.velocities):
        raise ValueError("no velocities: a pivot is zero up to rounding")
    accelerations = _solved(system, values)
    if accelerations is None:
        raise ValueError("no accelerations")
    met = [bool(e.xreplace(values).evalf(DIGITS) > TOLERANCE) for e in wanted]
    shown = {s: v for s, v in values.items() if s in used or s in slots.coordinates}
    return SpotValue({s: _rounded(v) for s, v in shown.items()}, accelerations), met


def _positions(
    configuration: Configuration,
    values: Mapping[sp.Basic, sp.Expr],
    trial: int,
    sign: int,
    angles: Mapping[sp.Expr, bool],
) -> dict[sp.Basic, sp.Expr] | None:
    """Simple numbers for the free coordinates, and the others from the finite constraints."""
    slots = configuration.slots
    chosen = {
        q: sign * (_angle(n) if angles.get(q) and trial == 0 else sp.Rational(n + 1, n + 2 + trial))
        for n, q in enumerate(slots.coordinates)
    }
    finite = configuration.finite_constraints
    if not finite:
        return dict(chosen)
    equations = [f.xreplace(dict(values)) for f in finite]
    return _in_turn(equations, chosen) or _by_newton(equations, chosen)


def _in_turn(equations: Sequence[sp.Expr], start: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Basic, sp.Expr] | None:
    """Each equation solved for a coordinate that no earlier one contains, linear ones first; None if that fails."""
    steps: list[tuple[sp.Symbol, sp.Expr, int]] = []
    waiting, seen = list(equations), set[sp.Basic]()
    while waiting:
        step = _next_step(waiting, start, seen)
        if step is None:
            return None
        steps.append(step)
        waiting.remove(step[1])
        seen |= step[1].free_symbols
    dependent = {q for q, _, _ in steps}
    values: dict[sp.Basic, sp.Expr] = {q: v for q, v in start.items() if q not in dependent}
    for q, f, degree in steps:
        solved = solved_for_one(f.xreplace(values), [q], degree, 1)
        if solved is None:
            return None
        value = solved[1].xreplace(dict.fromkeys(solved[2], sp.S.One))
        if not value.is_Rational:
            value = value.evalf(RECOGNISED_DIGITS + DIGITS)
        if not value.is_real:
            return None
        values[q] = value
    return values


def _next_step(
    waiting: Sequence[sp.Expr], coordinates: Iterable[sp.Symbol], seen: Collection[sp.Basic]
) -> tuple[sp.Symbol, sp.Expr, int] | None:
    for degree in (1, 2):
        for f in waiting:
            for q in coordinates:
                if q in f.free_symbols and q not in seen and solved_for_one(f, [q], degree, 1):
                    return q, f, degree
    return None


def _by_newton(equations: Sequence[sp.Expr], start: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Basic, sp.Expr] | None:
    """A solution that differs from the start in as many coordinates as there are equations."""
    for dependent in islice(combinations(reversed(start), len(equations)), MOST_DEPENDENT_SETS):
        place = {q: sp.Float(v, DIGITS) for q, v in start.items()}
        jacobian = sp.Matrix([[f.diff(q) for q in dependent] for f in equations])
        for _ in range(MOST_ITERATIONS):
            residual = sp.Matrix([f.xreplace(place).evalf(DIGITS) for f in equations])
            if all(r.is_Float or r == 0 for r in residual) and max(map(abs, residual)) < TOLERANCE:
                return {q: place[q] if q in dependent else start[q] for q in start}
            slope = jacobian.xreplace(place).evalf(DIGITS)
            if not all(x.is_number and x.is_real for x in (*slope, *residual)) or abs(slope.det()) < TOLERANCE:
                break
            step = slope.LUsolve(residual)
            place |= {q: place[q] - d for q, d in zip(dependent, step, strict=True)}
    return None


def _all_expressions(system: System) -> Iterator[sp.Expr]:
    yield from (*system.equations, *system.accelerated_constraints)
    for row in system.configuration.rows:
        yield from (*row.coefficients, row.drift, row.finite or sp.S.Zero)


def _parameter_value(symbol: sp.Symbol, numbers: Iterator[int], in_degrees: bool | None) -> sp.Expr:
    """The next number; the last name has the smallest, because a + b cos ωt is a length where a > b.

    An angle is less than a right one: the normal force on an incline is m g cos α.

    in_degrees  of an angle, whether it is a whole number of degrees; None: it is none
    """
    if symbol.name == "g":
        return sp.Integer(10)
    if symbol == t:
        return sp.S.One
    number = sp.Integer(next(numbers))
    value = number if in_degrees is None else _angle(int(number) - 1) if in_degrees else 1 / (1 + number)
    if isinstance(symbol, Bounded) and not symbol.low < value < symbol.high:
        middle = (symbol.low + symbol.high) / 2
        eighths = sp.Rational(sp.floor(8 * middle), 8)
        return eighths if symbol.low < eighths < symbol.high else middle
    return value


def _angle(n: int) -> sp.Expr:
    """The nth angle to choose."""
    return sp.pi * sp.Rational(ANGLES_TO_TRY[n % len(ANGLES_TO_TRY)], 180)


def _angles(expressions: Iterable[sp.Expr]) -> dict[sp.Expr, bool]:
    """The symbols that are terms in the argument of a sine or cosine: α, but not the ω in ω t.

    And whether they occur nowhere else: the angle of a torsion spring enters its moment in radians.
    """
    expressions = [*expressions]
    plain = (e.replace(lambda f: isinstance(f, TrigonometricFunction), lambda *_: sp.S.One) for e in expressions)
    elsewhere = {s for e in plain for s in e.free_symbols}
    functions = (f for e in expressions for f in e.atoms(TrigonometricFunction))
    terms = (term for f in functions for term in sp.Add.make_args(f.args[0]))
    symbols = (symbol for term in terms for _, symbol in [term.as_coeff_Mul()] if symbol.is_Symbol)
    return {s: s not in elsewhere for s in symbols}


def _velocities(
    configuration: Configuration, values: Mapping[sp.Basic, sp.Expr], trial: int, sign: int
) -> dict[sp.Basic, sp.Expr]:
    """Velocities 1, 2, ... for the free ones, and the others from the constraints."""
    velocities = configuration.slots.velocities
    if not configuration.constrained.is_pfaffian:
        return _velocities_by_newton(configuration, values, trial, sign)
    point = _point(values)
    rows = [point.values((*row.coefficients, row.drift)) for row in configuration.rows]
    reduced, pivots = row_reduced(point.arithmetic, rows)
    if len(velocities) in pivots:
        raise ValueError("no velocities")
    free = [k for k in range(len(velocities)) if k not in pivots]
    chosen = {k: sign * (n + trial) for n, k in enumerate(free, start=1)}
    result: dict[sp.Basic, sp.Expr] = {velocities[k]: sp.Integer(n) for k, n in chosen.items()}
    for k, row in zip(pivots, reduced, strict=True):
        result[velocities[k]] = _recognised(-row[-1] - sum(row[i] * n for i, n in chosen.items()))
    return result


def _velocities_by_newton(
    configuration: Configuration, values: Mapping[sp.Basic, sp.Expr], trial: int, sign: int
) -> dict[sp.Basic, sp.Expr]:
    """Velocities that satisfy constraints that are not linear in them."""
    slots = configuration.slots
    rows = [r.velocity_form(slots).xreplace(values) for r in configuration.rows]
    start = {v: sign * sp.Rational(3, 5) * (n + trial) for n, v in enumerate(slots.velocities, start=1)}
    velocities = _by_newton(rows, start)
    if velocities is None:
        raise ValueError("no velocities")
    return velocities


def _solved(system: System, values: Mapping[sp.Basic, sp.Expr]) -> Mapping[sp.Symbol, sp.Expr] | None:
    accelerations = system.configuration.slots.accelerations
    point = _point(values)
    rows = affine_rows(point, [*system.equations, *system.accelerated_constraints], accelerations)
    if len(rows) != len(accelerations):
        return None
    reduced, pivots = row_reduced(point.arithmetic, rows)
    if pivots != [*range(len(accelerations))]:
        return None
    numbers = [_recognised(-row[-1]) for row in reduced]
    return {
        a: x if x.is_Integer else _rounded(sp.Float(x, DIGITS)) for a, x in zip(accelerations, numbers, strict=True)
    }


def _point(values: Mapping[sp.Basic, sp.Expr]) -> RealPoint:
    """The point with these values."""
    point = RealPoint(Graph(), Reals(Random(0)))
    point.move({s: point.reals.float(v) if v.is_Float else point.value(v) for s, v in values.items()})
    return point


def _recognised(number: Any) -> sp.Expr:
    """A number of eighty digits; as a fraction, if it equals one with a small denominator to sixty digits."""
    value = sp.Float(number, DIGITS)
    scale = 10**RECOGNISED_DIGITS
    fraction = Fraction(int(number * scale), scale).limit_denominator(LARGEST_DENOMINATOR)
    difference = abs(number * fraction.denominator - fraction.numerator)
    return sp.Rational(fraction) if difference * scale < 1 else value


def _rounded(value: sp.Expr) -> sp.Expr:
    """Rational numbers and fractions of π unchanged, others to six figures; the rounding error of a zero is 0."""
    if value.is_Rational or (value / sp.pi).is_Rational:
        return value
    number = value.evalf(DIGITS)
    return sp.S.Zero if abs(number) < TOLERANCE else sp.Float(number, 6)
