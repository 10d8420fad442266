"""Dry friction where nothing slips: whether a slip begins, and in which sense.

The equations of motion have the friction of a slip, μ|R| against its sense s. At v = 0 they hold for a sense if the
slip then begins in it: s dv/dt > 0, the friction being the largest that is possible at rest, with the static
coefficient if there is one. If that is so for neither sense, friction holds the system.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import product

import sympy as sp

from lagrange.core.symbols import partial, t
from lagrange.pictures.floats import NoValueError, value
from lagrange.programs.contacts import coefficients_at_rest
from lagrange.programs.integrator import State
from lagrange.programs.limits import MOST_AT_REST, NARROW
from lagrange.programs.numerical_system import NumericalSystem

Signs = Mapping[sp.Expr, int]


def at_rest(system: NumericalSystem) -> NumericalSystem:
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


def beginning(system: NumericalSystem, resting: Sequence[sp.Expr], time: float, state: State) -> Signs | None:
    """The senses in which slips begin, for all that are zero in a state; None if friction holds one of them."""
    if len(resting) > MOST_AT_REST:
        return None
    still = at_rest(system)
    for senses in product((1, -1), repeat=len(resting)):
        tried = {**system.signs, **dict(zip(resting, senses, strict=True))}
        moving = still.with_signs(tried)
        try:
            if all(growth(moving, e, time, state) * s > NARROW for e, s in zip(resting, senses, strict=True)):
                return tried
        except (ArithmeticError, ValueError):
            return None
    return None
