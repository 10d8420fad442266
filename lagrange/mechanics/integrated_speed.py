"""The motion where the rate of the only quasi-velocity contains the time only: two integrals over time.

u' = f(t) gives u = C_1 + ∫ f dt, and each coordinate whose velocity then contains the time only follows by a second
integral. Only trigonometric polynomials in t are integrated, and each result is differentiated as a check.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp
from sympy.simplify.fu import TR8

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import free_letter, prime, t
from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm
from lagrange.mechanics.limits import LONGEST_INTEGRATED


@record
class IntegratedSpeed:
    """The motion by integrals over time.

    speed      the quasi-velocity u
    values     u, and the coordinates that could be integrated, as functions of time
    constants  of integration, one for each of the values
    """

    speed: sp.Symbol
    values: Mapping[sp.Symbol, sp.Expr]
    constants: tuple[sp.Symbol, ...]


def integrated_speed(form: QuasiVelocityForm, names: Iterable[str]) -> IntegratedSpeed | None:
    """The motion, with constants that are none of the names; None unless u' = f(t) for a single quasi-velocity u."""
    if form.equations is None or form.velocities.completing:
        return None
    if len(form.velocities.definitions) != 1 or len(form.equations.expressions) != 1:
        return None
    slots = form.configuration.slots
    letter = free_letter("C", "K", "c", taken={*names})
    constants = [sp.Symbol(f"{letter}_{n + 1}", real=True) for n in range(len(slots.coordinates) + 1)]
    [u], [equation] = form.velocities.definitions, form.equations.expressions
    factor = equation.diff(prime(u))
    if factor == 0:
        return None
    speed = integral_over_time(-(equation - factor * prime(u)) / factor, constants[0])
    if speed is None:
        return None
    values = {u: speed}
    for q, v in zip(slots.coordinates, slots.velocities, strict=True):
        rate = form.velocities.kinematic.get(v)
        value = None if rate is None else integral_over_time(rate.xreplace({u: speed}), constants[len(values)])
        values |= {q: value} if value is not None else {}
    return IntegratedSpeed(u, values, tuple(constants[: len(values)]))


def integral_over_time(rate: sp.Expr, constant: sp.Symbol) -> sp.Expr | None:
    """constant + ∫ rate dt; None if the rate is no trigonometric polynomial in t."""
    rate = sp.expand(rate)
    moving = {s for s in rate.free_symbols if s != t and not s.is_positive and not s.is_real}
    if count_operations(rate) > LONGEST_INTEGRATED or moving or any(s.name.endswith("'") for s in rate.free_symbols):
        return None
    terms = []
    parts = [term.as_independent(t, as_Add=False) for term in sp.Add.make_args(rate)]
    products = sp.expand(sp.Add(*(factor * TR8(f) for factor, f in parts)))
    for term in sp.Add.make_args(products):
        factor, f = term.as_independent(t, as_Add=False)
        slope = f.args[0].diff(t) if isinstance(f, sp.sin | sp.cos) else sp.S.Zero
        if f == 1:
            terms.append(factor * t)
        elif slope != 0 and not slope.has(t):
            terms.append(factor * (-sp.cos(f.args[0]) if isinstance(f, sp.sin) else sp.sin(f.args[0])) / slope)
        else:
            return None
    value = sp.Add(constant, *terms)
    return value if is_zero(value.diff(t) - rate) is True else None
