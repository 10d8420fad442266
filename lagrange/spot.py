"""One numerical value of the equations of motion, to be checked on a pocket calculator.

Simple numbers go in for parameters, positions and velocities; the equations, which are linear in the accelerations,
give those as numbers. Where constraints bind the coordinates, the dependent ones and their velocities follow from them,
so that the state is possible.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, count

import sympy as sp

from lagrange.comparison import System
from lagrange.coordinates import solved_constraints
from lagrange.kinematics import Configuration, is_pfaffian
from lagrange.notation import Sign, Unspecified, t

DIGITS = 30
TRIALS = 8
ITERATIONS = 30
TOLERANCE = sp.Float(10) ** -20


@dataclass(frozen=True)
class Spot:
    """Numbers in, accelerations out (to six figures)."""

    values: Mapping[sp.Symbol, sp.Expr]
    accelerations: Mapping[sp.Symbol, sp.Expr]


def spot_value(system: System, given: Mapping[sp.Symbol, sp.Rational]) -> Spot | None:
    """A spot value of a system; `given` are the numbers that the file gives to parameters. None if none was found."""
    if any(e.has(Unspecified) for e in system.equations):
        return None
    for trial in range(TRIALS):
        try:
            found = _at(system, given, trial)
        except (ValueError, ZeroDivisionError, TypeError):
            found = None
        if found is not None:
            return found
    return None


def _at(system: System, given: Mapping[sp.Symbol, sp.Rational], trial: int) -> Spot | None:
    configuration = system.configuration
    slots = configuration.slots
    used = set().union(*(e.free_symbols for e in _all_expressions(system)))
    values: dict[sp.Basic, sp.Expr] = {}
    numbers = _numbers(trial)
    for s in sorted(used, key=lambda s: s.name):
        if isinstance(s, Sign):
            values[s] = sp.S.One
        elif s not in slots.coordinates and s not in slots.velocities and s not in slots.accelerations:
            values[s] = given.get(s) or _parameter_value(s, numbers)
    positions = _positions(configuration, values, trial)
    if positions is None:
        return None
    values |= positions
    values |= _velocities(configuration, values, trial)
    accelerations = _solved(system, values)
    if accelerations is None:
        return None
    shown = {s: v for s, v in values.items() if s in used or s in slots.coordinates}
    return Spot({s: _rounded(v) for s, v in shown.items()}, accelerations)


def _positions(
    configuration: Configuration, values: Mapping[sp.Basic, sp.Expr], trial: int
) -> dict[sp.Basic, sp.Expr] | None:
    """Simple numbers for the free coordinates, and what the finite constraints give for the others."""
    slots = configuration.slots
    chosen = {q: sp.Rational(n + 1, n + 2 + trial) for n, q in enumerate(slots.coordinates)}
    finite = configuration.finite_constraints
    if not finite:
        return dict(chosen)
    solution = solved_constraints(configuration.rows, list(slots.coordinates))
    if len(solution.expressed) == len(finite):
        free = {q: v for q, v in chosen.items() if q not in solution.expressed}
        branch = dict.fromkeys(solution.signs, sp.S.One)
        found = {q: e.xreplace({**values, **free, **branch}) for q, e in solution.expressed.items()}
        if all(v.is_real for v in found.values()):
            return free | found
    return _by_newton([f.xreplace(dict(values)) for f in finite], chosen)


def _by_newton(equations: Sequence[sp.Expr], start: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Basic, sp.Expr] | None:
    """A solution near the start in which only as many coordinates differ from it as there are equations."""
    for dependent in combinations(reversed(start), len(equations)):
        place = {q: sp.Float(v, DIGITS) for q, v in start.items()}
        jacobian = sp.Matrix([[f.diff(q) for q in dependent] for f in equations])
        for _ in range(ITERATIONS):
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


def _numbers(trial: int) -> Iterator[sp.Rational]:
    """1, 2, 3, ..., begun elsewhere at every trial."""
    return (sp.Integer(n) for n in count(1 + trial))


def _parameter_value(symbol: sp.Symbol, numbers: Iterator[sp.Rational]) -> sp.Expr:
    if symbol.name == "g":
        return sp.Integer(10)
    if symbol == t:
        return sp.S.One
    return next(numbers)


def _velocities(
    configuration: Configuration, values: Mapping[sp.Basic, sp.Expr], trial: int
) -> dict[sp.Basic, sp.Expr]:
    """Velocities 1, 2, ... for as many as are free, and those that the constraints give."""
    slots = configuration.slots
    if not configuration.rows:
        return {v: sp.Integer(n + trial) for n, v in enumerate(slots.velocities, start=1)}
    rows = [r.velocity_form(slots).xreplace(values) for r in configuration.rows]
    if not is_pfaffian(configuration.rows):
        start = {v: sp.Rational(3, 5) * (n + trial) for n, v in enumerate(slots.velocities, start=1)}
        found = _by_newton(rows, start)
        if found is None:
            raise ValueError("no velocities")
        return found
    solution = sp.solve(rows, list(slots.velocities), dict=True)
    if not solution:
        raise ValueError("no velocities")
    free = [v for v in slots.velocities if v not in solution[0]]
    chosen = {v: sp.Integer(n + trial) for n, v in enumerate(free, start=1)}
    return chosen | {v: e.xreplace(chosen) for v, e in solution[0].items()}


def _solved(system: System, values: Mapping[sp.Basic, sp.Expr]) -> Mapping[sp.Symbol, sp.Expr] | None:
    slots = system.configuration.slots
    rows = [*system.equations, *system.accelerated_constraints]
    at_rest = dict.fromkeys(slots.accelerations, sp.S.Zero)
    matrix = sp.Matrix([[_number(e.diff(a), values) for a in slots.accelerations] for e in rows])
    right = sp.Matrix([-_number(e.xreplace(at_rest), values) for e in rows])
    if matrix.rows != matrix.cols or abs(matrix.det()) < sp.Float(10) ** -12:
        return None
    found = matrix.LUsolve(right)
    return dict(zip(slots.accelerations, map(_rounded, found), strict=True))


def _number(expression: sp.Expr, values: Mapping[sp.Basic, sp.Expr]) -> sp.Float:
    number = expression.xreplace(values).evalf(DIGITS)
    if not number.is_Float and not number.is_Integer and not number.is_Rational:
        raise ValueError("not a number")
    return sp.Float(number, DIGITS)


def _rounded(value: sp.Expr) -> sp.Expr:
    """Simple numbers as they are, others to six figures; what is left of a zero by rounding is 0."""
    if value.is_Rational:
        return value
    number = value.evalf(DIGITS)
    return sp.S.Zero if abs(number) < TOLERANCE else sp.Float(number, 6)
