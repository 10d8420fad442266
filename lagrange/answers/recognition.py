"""What an equation is that is no equation of motion and yet has to do with one.

Not linear in the accelerations: at the accelerations u* that the motion has, and in a direction v from there,

    e(u* + s v) = s² e(u* + v)  for all s:  a square, if the quadratic form has rank 1, else a sum of squares;

e(u*) = 0 alone: it holds for the motion, and perhaps for others. Without accelerations: a first integral F = const has
a time derivative that follows from the equations, dF/dt = Σ c_k E_k. It is the energy where c_k is q_k' times what does
not depend on velocities, and a momentum where F is linear in the velocities. A constant that the answer has a name for
and the equations have not is solved for first: φ' = L/(m r²) is m r² φ' = L. All of this is seen at random states,
exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import Enum, auto
from typing import Any

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, InadmissibleError, NoPointError, Point, UnsupportedError
from lagrange.core.symbols import CONSTANT, Sign, t
from lagrange.mechanics.dynamics.comparison import Standing, System, affine_rows, compare, state, symbols_of

_HIGHEST = 20  # a higher power of an equation is not recognised
_STATES = 2


class Kind(Enum):
    """What an equation is."""

    SQUARE = auto()  # of a right equation
    SUM_OF_SQUARES = auto()
    POWER = auto()  # of a right equation, or a product of several
    HOLDS = auto()  # for the motion, and perhaps for others
    NOT_LINEAR = auto()
    ENERGY = auto()
    MOMENTUM = auto()
    INTEGRAL = auto()  # another first integral
    OF_PARAMETERS = auto()  # it says nothing of the state
    IMPOSSIBLE = auto()  # 1 = 0
    NO_ACCELERATION = auto()  # and not true of every motion
    OTHER = auto()


def recognised(equation: sp.Expr, system: System, *, linear: bool) -> Kind:
    """What an equation is that does not follow from a system; `linear` in the accelerations and multipliers."""
    slots = system.configuration.slots
    unknowns = {*slots.accelerations, *system.multipliers}
    used = equation.free_symbols
    if not linear:
        return _at_states(lambda p: _not_linear(p, equation, system), (equation,), system) or Kind.NOT_LINEAR
    if used & unknowns:
        return Kind.OTHER
    if not used - {CONSTANT}:
        return Kind.IMPOSSIBLE
    if not used & {*slots.coordinates, *slots.velocities, t, CONSTANT}:
        return Kind.OF_PARAMETERS
    if used & {*slots.velocities}:
        for integral in (equation, *_solved_for_constants(equation, system)):
            kind = _integral(integral, system)
            if kind is not None:
                return kind
    return Kind.NO_ACCELERATION


def _at_states(evaluate: Callable[[Point], Kind], expressions: Sequence[sp.Expr], system: System) -> Kind | None:
    """What is said at random states, if all say the same."""
    symbols = symbols_of((*expressions, *system.equations, *system.accelerated_constraints))
    configuration = system.configuration
    try:
        found = configuration.states.sampled(lambda p: evaluate(state(p, configuration, symbols)), _STATES)
    except (NoPointError, UnsupportedError, DivisionByZeroError):
        return None
    return found[0] if len(set(found)) == 1 else None


def _not_linear(moving: Point, equation: sp.Expr, system: System) -> Kind:
    unknowns = (*system.multipliers, *system.configuration.slots.accelerations)
    rows = affine_rows(moving, (*system.accelerated_constraints, *system.equations), unknowns)
    reduce, vanishes = moving.arithmetic.reduce, moving.arithmetic.vanishes
    there = moving.solution([r[:-1] for r in rows], [reduce(-r[-1]) for r in rows], [moving.random() for _ in unknowns])
    if there is None:
        raise InadmissibleError

    def at(direction: Sequence[Any], s: int) -> Any:
        u = [reduce(a + s * v) for a, v in zip(there, direction, strict=True)]
        return moving.with_values(dict(zip(unknowns, u, strict=True))).value(equation)

    def equal(a: Any, b: Any) -> bool:
        return bool(vanishes(reduce(a - b)))

    v, w = ([moving.random() for _ in unknowns] for _ in range(2))
    if not vanishes(at(v, 0)):
        return Kind.NOT_LINEAR
    once = at(v, 1)
    for k in range(2, _HIGHEST + 1):
        if equal(at(v, 2), 2**k * once) and equal(at(v, 3), 3**k * once):
            if k > 2:
                return Kind.POWER
            mixed = reduce(at([reduce(a + b) for a, b in zip(v, w, strict=True)], 1) - once - at(w, 1))
            return Kind.SQUARE if equal(mixed * mixed, 4 * once * at(w, 1)) else Kind.SUM_OF_SQUARES
    return Kind.HOLDS


def _solved_for_constants(equation: sp.Expr, system: System) -> list[sp.Expr]:
    """F, where an equation says that F(q, q') is a constant that the system does not have."""
    slots = system.configuration.slots
    theirs = {*symbols_of(system.equations), *slots.coordinates, *slots.velocities, *slots.prescribed, t}
    found = []
    equation = _squared(equation, equation.free_symbols - theirs)
    for c in sorted(equation.free_symbols - theirs, key=str):
        slope = equation.diff(c)
        if slope != 0 and c not in slope.free_symbols and not isinstance(c, Sign):
            found.append(sp.Mul(sp.Add(equation, sp.Mul(-1, slope, c)), sp.Pow(slope, -1)).xreplace({c: sp.S.Zero}))
    return found


def _squared(equation: sp.Expr, constants: set[sp.Symbol]) -> sp.Expr:
    """a² − b² for a + b, where b alone has a constant, under a square root: θ' = √(2 (E + g/l cos θ))."""
    rooted = [e for e in sp.Add.make_args(equation) if e.free_symbols & constants]
    if len(rooted) != 1 or not any(p.exp == sp.S.Half and p.free_symbols & constants for p in rooted[0].atoms(sp.Pow)):
        return equation
    return sp.Add(sp.Pow(sp.Add(equation, -rooted[0]), 2), -(rooted[0] ** 2))


def _integral(function: sp.Expr, system: System) -> Kind | None:
    """Which first integral a function is; None where it is none, or that is undecided."""
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
    return _at_states(lambda p: _kind(p, function, rate, system), (function, rate), system) or Kind.INTEGRAL


def _kind(moving: Point, function: sp.Expr, rate: sp.Expr, system: System) -> Kind:
    """Energy, momentum or another, at one position."""
    velocities = system.configuration.slots.velocities
    if moving.affine([function], velocities) is not None:
        return Kind.MOMENTUM
    again = state(moving, system.configuration, ())
    first, second = (_over_velocities(p, rate, system) for p in (moving, again))
    return Kind.ENERGY if first is not None and first == second else Kind.INTEGRAL


def _over_velocities(moving: Point, rate: sp.Expr, system: System) -> list[Any] | None:
    """c_k/q_k' of dF/dt = Σ c_k E_k, one for each coordinate that moves."""
    unknowns = (*system.multipliers, *system.configuration.slots.accelerations)
    velocities = system.configuration.slots.velocities
    *known, row = affine_rows(moving, (*system.equations, *system.accelerated_constraints, rate), unknowns)
    c = moving.solution([list(column) for column in zip(*known, strict=True)], row)
    if c is None or len(system.equations) != len(velocities):
        return None
    arithmetic = moving.arithmetic
    pairs = zip(c, moving.values(velocities), strict=False)
    return [arithmetic.reduce(x * arithmetic.inverse(v)) for x, v in pairs if not arithmetic.vanishes(v)]
