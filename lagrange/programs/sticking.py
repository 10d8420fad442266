"""Dry friction where nothing slips: whether a slip begins, and in which sense.

The equations of motion have the friction of a slip, μ|R| against its sense s. At v = 0 they hold for a sense if the
slip then begins in it: s dv/dt > 0, the friction being the largest that is possible at rest, with the static
coefficient if there is one. If that is so for neither sense, friction holds the system.

In a plane the sense is a direction u, and the condition is dv/dt = a u with a > 0: the directions are gone through for
those in which dv/dt does not turn away from u.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import chain, pairwise, product
from typing import Any

import sympy as sp

from lagrange.core.symbols import partial, t
from lagrange.pictures.floats import NoValueError, value
from lagrange.programs.contacts import coefficients_at_rest
from lagrange.programs.integrator import State
from lagrange.programs.limits import DIRECTIONS, MOST_AT_REST, NARROW, SLOW
from lagrange.programs.numerical_system import NumericalSystem

SlipSigns = Mapping[sp.Expr, int]


def with_static_coefficients(system: NumericalSystem) -> NumericalSystem:
    """The same system with the static coefficients of friction."""
    changed = dict(system.values)
    for kinetic, static in coefficients_at_rest(system.states.problem).items():
        try:
            changed[kinetic] = max(changed[kinetic], value(static, system.values))
        except (KeyError, NoValueError):
            continue
    return system if changed == system.values else NumericalSystem(system.states, changed, system.signs)


def growth(system: NumericalSystem, e: sp.Expr, time: float, state: State) -> float:
    """The rate at which an expression of the state changes."""
    equations = system.states.equations
    symbols = (*equations.state, *(s for s in (t,) if e.has(s)))
    rates = [*system.rate(time, *state), *(1.0 for s in (t,) if e.has(s))]
    slopes = [system.function(partial(e, s))(time, *state) for s in symbols]
    return math.fsum(a * b for a, b in zip(slopes, rates, strict=True))


def beginning(system: NumericalSystem, resting: Sequence[sp.Expr], time: float, state: State) -> SlipSigns | None:
    """The senses in which slips begin, for all that are zero in a state; None if friction holds one of them."""
    if len(resting) > MOST_AT_REST:
        return None
    still = with_static_coefficients(system)
    for senses in product((1, -1), repeat=len(resting)):
        tried = {**system.signs, **dict(zip(resting, senses, strict=True))}
        moving = still.with_signs(tried)
        try:
            if all(growth(moving, e, time, state) * s > NARROW for e, s in zip(resting, senses, strict=True)):
                return tried
        except (ArithmeticError, ValueError):
            return None
    return None


def beginning_in_plane(
    system: NumericalSystem, slip: Sequence[sp.Expr], speed: float, time: float, state: State
) -> State | None:
    """The state in which a slip in a plane begins, with some speed; None if friction holds it.

    slip  the components of the velocity of slip, zero in the state
    """
    import numpy

    e = system.states.equations
    n, p = len(e.slots.coordinates), len(e.speeds)

    def table(expressions: Sequence[sp.Expr], columns: int) -> Any:
        return numpy.array(system.function_of(expressions)(time, *state), dtype=float).reshape(-1, columns)

    # Changes of speeds that constraints admit, and with which of them the slip takes which value.
    free = numpy.eye(p)
    if e.constraint_matrix:
        _, sizes, rows = numpy.linalg.svd(table([*chain.from_iterable(e.constraint_matrix)], p))
        free = rows[int((sizes > NARROW).sum()) :].T
    slopes = table([partial(c, s) for c in slip for s in e.speeds], p) @ free
    directions, sizes, _ = numpy.linalg.svd(slopes)
    plane = directions[:, : int((sizes[:2] > NARROW).sum())]
    lift = free @ numpy.linalg.pinv(slopes)

    def with_slip(velocity: Any) -> State:
        speeds = numpy.array(state[n:]) + lift @ (velocity - numpy.array(system.function_of(slip)(time, *state)))
        return (*state[:n], *speeds.tolist())

    still = with_static_coefficients(system)
    gradient = system.function_of([partial(c, s) for c in slip for s in (*e.state, t)])

    def acceleration(angle: float) -> tuple[float, float]:
        """Along the direction at an angle in the plane, and across it."""
        way = numpy.array([math.cos(angle), math.sin(angle)][: plane.shape[1]])
        slow = with_slip(SLOW * (plane @ way))
        rates = numpy.array([*still.rate(time, *slow), 1.0])
        rate = plane.T @ numpy.array(gradient(time, *slow)).reshape(len(slip), -1) @ rates
        return float(way @ rate), float(way[0] * rate[1] - way[1] * rate[0]) if len(way) > 1 else 0.0

    try:
        if plane.shape[1] < 2:
            angles = [0.0, math.pi][: 2 * plane.shape[1]]
        else:
            around = [2 * math.pi * k / DIRECTIONS for k in range(DIRECTIONS + 1)]
            across = [(a, acceleration(a)[1]) for a in around]
            angles = [_zero(acceleration, a, b) for (a, x), (b, y) in pairwise(across) if (x > 0) != (y > 0)]
        best = max(((acceleration(a)[0], a) for a in angles), default=(0.0, 0.0))
    except (ArithmeticError, ValueError):
        return None
    if best[0] <= NARROW:
        return None
    way = numpy.array([math.cos(best[1]), math.sin(best[1])][: plane.shape[1]])
    return with_slip(speed * (plane @ way))


def _zero(acceleration: Callable[[float], tuple[float, float]], low: float, high: float) -> float:
    """The angle between two at which the acceleration across the direction vanishes, by bisection."""
    positive = acceleration(low)[1] > 0
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if (acceleration(middle)[1] > 0) == positive else (low, middle)
    return (low + high) / 2
