"""Answers in numbers: the first time after t = 0 at which the condition of a question holds.

Where all parameters have values and the initial state is given, q'' = a(q, q', t) is integrated step by step, and the
zero of the condition is located in the step in which its sign changes (scipy's `solve_ivp` with events, in the extra
`sim`). A condition that only touches zero is not seen. The search ends after the longest of the horizons.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from importlib.util import find_spec
from typing import Any

import sympy as sp

from lagrange.core.symbols import t
from lagrange.mechanics.questions.limits import HORIZONS, LARGEST_DRIFT, MOST_EVALUATIONS, SMALLEST_TIME

Function = Callable[[Sequence[float]], float]
EXTRA = "sim"

_FUNCTIONS: dict[type[sp.Basic], Callable[..., float]] = {
    sp.sin: math.sin, sp.cos: math.cos, sp.tan: math.tan, sp.exp: math.exp, sp.log: math.log,
    sp.asin: math.asin, sp.acos: math.acos, sp.atan: math.atan, sp.atan2: math.atan2,
    sp.sinh: math.sinh, sp.cosh: math.cosh, sp.tanh: math.tanh, sp.Abs: abs,
    sp.sign: lambda x: float(int(x > 0) - int(x < 0)),
    sp.cot: lambda x: 1 / math.tan(x), sp.sec: lambda x: 1 / math.cos(x), sp.csc: lambda x: 1 / math.sin(x),
}  # fmt: skip


class _UnknownError(Exception):
    """An expression that has no value in numbers."""


class _TooLongError(Exception):
    """Too many evaluations."""


def is_available() -> bool:
    """Whether the extra is installed."""
    return find_spec("scipy") is not None


def first_value(
    accelerations: Mapping[sp.Symbol, sp.Expr],
    initial: Mapping[sp.Symbol, sp.Expr],
    coordinates: Sequence[sp.Symbol],
    velocities: Sequence[sp.Symbol],
    condition: sp.Expr,
    quantity: sp.Expr,
    constraints: Sequence[sp.Expr] = (),
) -> float | None:
    """The quantity at the first time t > 0 at which the condition is zero; None where none was found.

    All expressions have numbers in place of parameters. In dependent coordinates the finite constraints must still hold
    where the search ends, up to `LARGEST_DRIFT`.
    """
    from scipy.integrate import solve_ivp

    order = (*coordinates, *velocities, t)
    try:
        rates = [_function(a, order) for a in accelerations.values()]
        event, value = _function(condition, order), _function(quantity, order)
        kept = [_function(f, order) for f in constraints]
        start = [float(initial[s]) for s in (*coordinates, *velocities)]
    except (_UnknownError, TypeError):
        return None
    n = len(coordinates)
    count = 0

    def rate(time: float, state: Sequence[float]) -> list[float]:
        nonlocal count
        count += 1
        if count > MOST_EVALUATIONS:
            raise _TooLongError
        here = (*state, time)
        return [*state[n:], *(a(here) for a in rates)]

    def crossing(time: float, state: Sequence[float]) -> float:
        return event((*state, time))

    try:
        for horizon in HORIZONS:
            run = solve_ivp(rate, (0.0, horizon), start, events=crossing, rtol=1e-10, atol=1e-12, max_step=horizon / 50)
            found = _first(run, horizon)
            if found is not None:
                here = (*found[1], found[0])
                return value(here) if all(abs(f(here)) < LARGEST_DRIFT for f in kept) else None
            if not run.success:
                return None
    except (_TooLongError, ValueError, ZeroDivisionError, OverflowError):
        return None
    return None


def _first(run: Any, horizon: float) -> tuple[float, Sequence[float]] | None:
    """The first event after the start, with its state."""
    for time, state in zip(run.t_events[0], run.y_events[0], strict=True):
        if time > SMALLEST_TIME * horizon:
            return float(time), [float(x) for x in state]
    return None


def _function(e: sp.Expr, order: Sequence[sp.Symbol]) -> Function:
    """An expression as a function of the state. Raises _UnknownError."""
    if e.is_Symbol:
        if e not in order:
            raise _UnknownError
        place = order.index(e)
        return lambda state: state[place]
    if e.is_number:
        value = sp.N(e, 17)
        if not value.is_Float and not value.is_Rational:
            raise _UnknownError
        number = float(value)
        return lambda _: number
    parts = [_function(a, order) for a in e.args if isinstance(a, sp.Expr)]
    if e.is_Add:
        return lambda state: math.fsum(p(state) for p in parts)
    if e.is_Mul:
        return lambda state: math.prod(p(state) for p in parts)
    if e.is_Pow:
        base, exponent = parts
        if e.exp.is_Integer:
            whole = int(e.exp)
            return lambda state: float(base(state) ** whole)
        return lambda state: math.pow(base(state), exponent(state))
    known = _FUNCTIONS.get(type(e))
    if known is None:
        raise _UnknownError
    return lambda state: known(*(p(state) for p in parts))
