"""Recognising equations that are not equations of motion but are related to one: squares, first integrals, ...

Not linear in the accelerations: at the accelerations u* of the motion, and in a direction v from there,

    e(u* + s v) = s² e(u* + v)  for all s:  a square, if the quadratic form has rank 1, else a sum of squares;
    e(u*) = 0 alone:                        it holds for the motion, and perhaps for others.

Without accelerations: the time derivative of a first integral F = const follows from the equations, dF/dt = Σ c_k E_k.
F is the energy if the ratios c_k/q_k' do not depend on the velocities, and a momentum if it is linear in them. A
constant that only the answer has is solved for first: φ' = L/(m r²) becomes m r² φ' = L. Everything is tested exactly
at random states.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import Enum, auto
from typing import Any

import sympy as sp

from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    InadmissibleError,
    NoPointError,
    Point,
    UnsupportedError,
)
from lagrange.answers.limits import MAX_POWER, STATES
from lagrange.core.symbols import CONSTANT, Sign, t
from lagrange.mechanics.dynamics.comparison import Standing, System, affine_rows, compare, random_state, symbols_of


class Recognised(Enum):
    """The kind of an equation that is not an equation of motion."""

    SQUARE = auto()  # of a right equation
    SUM_OF_SQUARES = auto()
    POWER = auto()  # of a right equation, or a product of several
    HOLDS = auto()  # for the motion, and perhaps for other motions
    NOT_LINEAR = auto()
    ENERGY = auto()
    MOMENTUM = auto()
    INTEGRAL = auto()  # another first integral
    OF_PARAMETERS = auto()  # the state does not occur in it
    IMPOSSIBLE = auto()  # 1 = 0
    NO_ACCELERATION = auto()  # and it does not hold for every motion
    OTHER = auto()


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
