"""Answers in numbers: the first time after t = 0 at which the condition of a question holds.

Where all parameters have values and the initial state is given, q'' = a(q, q', t) is integrated step by step, and the
zero of the condition is located in the step in which its sign changes (scipy's `solve_ivp` with events, in the extra
`sim`). A condition that only touches zero is not seen. The search ends after the longest of the horizons. Of several
exact answers it finds that which comes first, where nothing else has decided that.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from importlib.util import find_spec
from typing import Any

import sympy as sp

from lagrange.core.symbols import t
from lagrange.mechanics.questions.limits import CLOSE, HORIZONS, LARGEST_DRIFT, MOST_EVALUATIONS, SMALLEST_TIME
from lagrange.mechanics.questions.results import AnswerBranch
from lagrange.mechanics.questions.setting import Setting

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


def first_of_motion(setting: Setting, condition: sp.Expr, quantity: sp.Expr) -> float | None:
    """The quantity at the first time at which the condition is zero, with the values of the file; None: not found."""
    configuration, values = setting.place.configuration, setting.values
    return first_value(
        {a: e.xreplace(values) for a, e in setting.known.accelerations.items()},
        {s: e.xreplace(values) for s, e in setting.initial.items()},
        configuration.slots.coordinates,
        configuration.slots.velocities,
        condition.xreplace(values),
        quantity.xreplace(values),
        [f.xreplace(values) for f in configuration.finite_constraints],
    )


def those_with(
    branches: Sequence[AnswerBranch], number: float | None, values: Mapping[sp.Symbol, sp.Expr]
) -> tuple[list[AnswerBranch], list[AnswerBranch]]:
    """The branches that have a value found in numbers, and the others; all where none has it."""

    def has(b: AnswerBranch) -> bool:
        found = [sp.N(v.xreplace(dict(values))) for v in b.values]
        return number is not None and any(
            v.is_real and abs(float(v) - number) <= CLOSE * max(1.0, abs(number)) for v in found
        )

    kept = [b for b in branches if has(b)]
    return (kept, [b for b in branches if b not in kept]) if kept else ([*branches], [])


def first_value(
    accelerations: Mapping[sp.Symbol, sp.Expr],
    initial: Mapping[sp.Symbol, sp.Expr],
    coordinates: Sequence[sp.Symbol],
    velocities: Sequence[sp.Symbol],
    condition: sp.Expr,
    quantity: sp.Expr,
    constraints: Sequence[sp.Expr] = (),
) -> float | None:
    """The quantity at the first time t > 0 at which the condition is zero; None if none was found.

    All expressions have numbers instead of parameters. In dependent coordinates the finite constraints must still hold
    where the search ends, up to `LARGEST_DRIFT`.
    """
    from scipy.integrate import solve_ivp

    order = (*coordinates, *velocities, t)
    try:
        rates = _functions([*accelerations.values()], order)
        event, value = _functions([condition], order), _functions([quantity], order)
        kept = _functions([*constraints], order)
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
        return [*state[n:], *rates((*state, time))]

    def crossing(time: float, state: Sequence[float]) -> float:
        return event((*state, time))[0]

    try:
        slowness = _slowness(start, rates((*start, 0.0)))
        for horizon in (slowness * h for h in HORIZONS):
            step = horizon / 50
            run = solve_ivp(
                rate, (0.0, horizon), start, "DOP853", events=crossing, rtol=1e-10, atol=1e-12, max_step=step
            )
            first = _first(run, horizon)
            if first is not None:
                here = (*first[1], first[0])
                return value(here)[0] if all(abs(f) < LARGEST_DRIFT for f in kept(here)) else None
            if not run.success:
                return None
    except (_TooLongError, ValueError, ZeroDivisionError, OverflowError):
        return None
    return None


def _slowness(start: Sequence[float], accelerations: Sequence[float]) -> float:
    """A power of ten by which a motion is slower than one in the units of the file, as an orbit is; 1 for others.

    A coordinate q is taken to change in the time |q/q'|, or √|q/q''| from rest; an angle, by 1 where it is 0.
    """
    n = len(accelerations)
    spans = []
    for q, v, a in zip(start[:n], start[n:], accelerations, strict=True):
        size = abs(q) or 1.0
        spans += [size / abs(v)] if v else [math.sqrt(size / abs(a))] if a else []
    shortest = min(spans, default=1.0)
    return 10.0 ** math.floor(math.log10(shortest)) if shortest > 1 else 1.0


def _first(run: Any, horizon: float) -> tuple[float, Sequence[float]] | None:
    """The first event after the start, with its state."""
    for time, state in zip(run.t_events[0], run.y_events[0], strict=True):
        if time > SMALLEST_TIME * horizon:
            return float(time), [float(x) for x in state]
    return None


class _Program:
    """Expressions as functions of the state, in steps: what they share is evaluated once."""

    def __init__(self, order: Sequence[sp.Symbol]) -> None:
        self.places: dict[sp.Expr, int] = {s: n for n, s in enumerate(order)}
        self.start: list[float] = [0.0] * len(order)
        self.steps: list[tuple[int, Callable[[list[float]], float]]] = []

    def place(self, e: sp.Expr) -> int:
        """The index of the value of an expression. Raises _UnknownError."""
        if e not in self.places:
            step = None if e.is_number else self._step(e)
            self.places[e] = len(self.start)
            self.start.append(_number(e) if step is None else 0.0)
            if step is not None:
                self.steps.append((self.places[e], step))
        return self.places[e]

    def _step(self, e: sp.Expr) -> Callable[[list[float]], float]:
        if e.is_Symbol:
            raise _UnknownError
        parts = [self.place(a) for a in e.args if isinstance(a, sp.Expr)]
        first, last = parts[0], parts[-1]
        if e.is_Add:
            return (lambda v: v[first] + v[last]) if len(parts) == 2 else lambda v: math.fsum([v[k] for k in parts])
        if e.is_Mul:
            return (lambda v: v[first] * v[last]) if len(parts) == 2 else lambda v: math.prod([v[k] for k in parts])
        if e.is_Pow:
            if e.exp.is_Integer:
                whole = int(e.exp)
                return lambda v: float(v[first] ** whole)
            return lambda v: math.pow(v[first], v[last])
        known = _FUNCTIONS.get(type(e))
        if known is None:
            raise _UnknownError
        return (lambda v: known(v[first])) if len(parts) == 1 else lambda v: known(*[v[k] for k in parts])

    def __call__(self, state: Sequence[float]) -> list[float]:
        """The values of all expressions, each at its place."""
        values = self.start.copy()
        values[: len(state)] = state
        for place, step in self.steps:
            values[place] = step(values)
        return values


def _number(e: sp.Expr) -> float:
    value = sp.N(e, 17)
    if not value.is_Float and not value.is_Rational:
        raise _UnknownError
    return float(value)


def _functions(expressions: Sequence[sp.Expr], order: Sequence[sp.Symbol]) -> Callable[[Sequence[float]], list[float]]:
    """Expressions together as functions of the state. Raises _UnknownError."""
    program = _Program(order)
    places = [program.place(e) for e in expressions]

    def evaluated(state: Sequence[float]) -> list[float]:
        values = program(state)
        return [values[k] for k in places]

    return evaluated
