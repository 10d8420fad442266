"""Answers in numbers: the first time after t = 0 at which the condition of a question holds.

Where all parameters have values and the initial state is given, q'' = a(q, q', t) is integrated step by step, and the
zero of the condition is located in the step in which its sign changes (scipy's `solve_ivp` with events, in the extra
`sim`). A condition that only touches zero is not seen. The search ends after the longest of the horizons. Of several
exact answers it finds that which comes first, where nothing else has decided that.

From rest in an unstable equilibrium nothing moves in such an integration. There the first integrals give the condition
as a function of one coordinate alone, whose zero nearest to the start is found by bisection; without the extra.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from importlib.util import find_spec
from typing import Any

import sympy as sp

from lagrange.core.symbols import prime, t
from lagrange.mechanics.questions.limits import (
    CLOSE,
    HORIZONS,
    LARGEST_DRIFT,
    MOST_EVALUATIONS,
    SMALLEST_TIME,
    STEPS_OF_HALF_TURN,
)
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


def first_from_equilibrium(
    setting: Setting,
    condition: sp.Expr,
    quantity: sp.Expr,
    along: Callable[[sp.Symbol, sp.Expr], Sequence[AnswerBranch]],
) -> float | None:
    """The same for a motion from an unstable equilibrium, in which nothing moves in an integration over time.

    along  an expression as a function of one coordinate alone, by the first integrals
    """
    start, slots = dict(setting.initial), setting.place.configuration.slots
    at_rest = all(start[v] == 0 for v in slots.velocities)
    if not at_rest or any(sp.expand(e.xreplace(start)) != 0 for e in setting.known.accelerations.values()):
        return None
    for q in slots.coordinates:
        square = setting.square_of(q)
        values = [v for b in along(q, condition) for v in b.values] if square is not None else []
        functions = [e.xreplace(dict(setting.values)) for e in (*values, square) if e is not None]
        place = nearest_place(q, start[q], functions[0], functions[1]) if len(values) == 1 else None
        if place is not None:
            return place if quantity == q else _value_at(along(q, quantity), q, place, setting.values)
    return None


def nearest_place(q: sp.Symbol, start: sp.Expr, condition: sp.Expr, square: sp.Expr) -> float | None:
    """The place nearest to an unstable equilibrium, to either side, where a condition is zero; `square` is q'^2.

    None where the two sides differ, or where none is found within half a turn. Both are functions of q alone.
    """
    try:
        origin = float(start)
        functions = _functions([condition, square], (q,))
        there = [_place_along(functions, origin, side) for side in (1, -1)]
    except (_UnknownError, TypeError, ValueError, ZeroDivisionError, OverflowError):
        return None
    above, below = there
    return above if above is not None and below is not None and abs(above + below - 2 * origin) < CLOSE else None


def _value_at(
    branches: Sequence[AnswerBranch], q: sp.Symbol, place: float, values: Mapping[sp.Symbol, sp.Expr]
) -> float | None:
    """The value of a function of q at a place, of two the one with which q grows."""

    def number(e: sp.Expr) -> float:
        found = sp.N(e.xreplace(dict(values)).xreplace({q: sp.Float(place, 17)}), 15)
        return float(sp.re(found)) if abs(sp.im(found)) < CLOSE else math.nan

    growing = [b for b in branches if any(number(s.get(prime(q), sp.S.Zero)) > 0 for s in b.states)]
    found = {number(v) for b in (growing if len(branches) > 1 else branches) for v in b.values}
    return found.pop() if len(found) == 1 else None


def _place_along(functions: Callable[[Sequence[float]], list[float]], origin: float, side: int) -> float | None:
    """The first zero of the first function on one side, the second function, a square, being positive before it."""
    step = side * math.pi / STEPS_OF_HALF_TURN
    before, here = origin, origin
    for _ in range(STEPS_OF_HALF_TURN):
        before, here = here, here + step
        value, square = functions([here])[:2]
        if square <= 0:
            return None
        if value * functions([before])[0] <= 0:
            return _bisected(lambda x: functions([x])[0], before, here)
    return None


def _bisected(function: Callable[[float], float], low: float, high: float) -> float:
    sign = function(low)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) * sign > 0 else (low, middle)
    return (low + high) / 2


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
