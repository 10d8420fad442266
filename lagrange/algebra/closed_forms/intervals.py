"""Intervals of floating-point numbers, rounded outwards: what an expression lies between on a box.

Every operation is widened by one unit in the last place, a transcendental function by more than the error of the
library, so that the true value is never outside. An interval without 0 proves that an expression does not vanish on the
box. `enclosure` evaluates one expression, `IntervalProgram` several on many boxes, with their common parts once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeAlias

import sympy as sp

from lagrange.algebra.closed_forms.limits import CIRCULAR_ERROR, LARGEST_ANGLE, LIBRARY_ERROR

Interval: TypeAlias = tuple[float, float]

EVERYTHING: Interval = (-math.inf, math.inf)


class EmptyIntervalError(Exception):
    """A square root of negative numbers only."""


def outward(low: float, high: float) -> Interval:
    """The interval, one unit wider on both sides."""
    if math.isnan(low) or math.isnan(high):
        return EVERYTHING
    return math.nextafter(low, -math.inf), math.nextafter(high, math.inf)


def circle(start: float, end: float) -> tuple[Interval, Interval]:
    """Cosine and sine of the angles between two multiples of π/2, `start` and `end` in quarter turns."""
    return _cosine(start, end), _cosine(start - 1, end - 1)


def _cosine(start: float, end: float) -> Interval:
    values = [math.cos(x * math.pi / 2) for x in (start, end)]
    values += [(1.0, 0.0, -1.0, 0.0)[n % 4] for n in range(math.ceil(start), math.floor(end) + 1)]
    return max(-1.0, min(values) - CIRCULAR_ERROR), min(1.0, max(values) + CIRCULAR_ERROR)


def enclosure(e: sp.Expr, box: Mapping[sp.Symbol, Interval]) -> Interval:
    """An interval that contains every real value of an expression on a box. Raises EmptyIntervalError, ValueError."""
    if e.is_Symbol:
        return box[e]
    if e.is_Integer and abs(e) < 2**53:
        return float(e), float(e)
    if e.is_Rational:
        return outward(int(e.p) / int(e.q), int(e.p) / int(e.q))
    if e.is_Add:
        return _sum(*(enclosure(a, box) for a in e.args))
    if e.is_Mul:
        whole = (1.0, 1.0)
        for a in e.args:
            whole = product(whole, enclosure(a, box))
        return whole
    if e.is_Pow and e.exp.is_Rational and e.exp < 0:
        return _reciprocal(enclosure(e.base**-e.exp, box))
    if e.is_Pow and e.exp.is_Integer and e.exp > 0:
        return _power(enclosure(e.base, box), int(e.exp))
    if e.is_Pow and e.exp.is_Rational and e.exp.q == 2 and e.exp > 0:
        return _power(square_root(enclosure(e.base, box)), int(e.exp.p))
    if e.is_number and e.is_real:
        value = float(e.evalf(20))
        return outward(value, value)
    raise ValueError


def _reciprocal(x: Interval) -> Interval:
    if x[0] <= 0 <= x[1]:
        raise ValueError
    return outward(1 / x[1], 1 / x[0])


def square_root(x: Interval) -> Interval:
    """The root where it exists."""
    if x[1] < 0:
        raise EmptyIntervalError
    low, high = outward(math.sqrt(max(0.0, x[0])), math.sqrt(x[1]))
    return max(0.0, low), high


def product(a: Interval, b: Interval) -> Interval:
    """All products of their numbers."""
    ends = [0.0 if x == 0 or y == 0 else x * y for x in a for y in b]
    low, high = outward(min(ends), max(ends))
    if (a[0] >= 0 and b[0] >= 0) or (a[1] <= 0 and b[1] <= 0):
        low = max(low, 0.0)
    return low, high


def total(a: Interval, b: Interval) -> Interval:
    """All sums of their numbers. A sum that comes out as 0 is 0: x² + y² does not become negative, and has a root."""
    low, high = a[0] + b[0], a[1] + b[1]
    return math.nextafter(low, -math.inf) if low else 0.0, math.nextafter(high, math.inf) if high else 0.0


def scaled(number: float, a: Interval) -> Interval:
    """All products of a number with those of an interval."""
    low, high = (number * a[0], number * a[1]) if number >= 0 else (number * a[1], number * a[0])
    return math.nextafter(low, -math.inf), math.nextafter(high, math.inf)


def _power(x: Interval, n: int) -> Interval:
    try:
        ends = x[0] ** n, x[1] ** n
    except OverflowError:
        return EVERYTHING if n % 2 else (0.0, math.inf)
    low, high = outward(outward(*sorted(ends))[0], outward(*sorted(ends))[1])
    if n % 2:
        return low, high
    return (0.0 if x[0] <= 0 <= x[1] else max(0.0, low)), high


# -- Several expressions on many boxes ---------------------------------------------------------------------------------


class IntervalProgram:
    """Expressions as a list of operations on intervals, each common part once."""

    def __init__(self, expressions: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> None:
        self._places: dict[sp.Basic, int] = {u: n for n, u in enumerate(unknowns)}
        self._start: list[Interval | None] = [None] * len(unknowns)
        self._operations: list[tuple[int, Callable[..., Interval], list[int]]] = []
        self._results = [self._place(e) for e in expressions]

    def _place(self, e: sp.Basic) -> int:
        if e not in self._places:
            parts = [self._place(a) for a in (e.args[:1] if e.is_Pow else e.args)]
            self._places[e] = len(self._start)
            self._start.append(None if parts else _number(e))
            operation = _operation(e) if parts else None
            if operation is not None:
                self._operations.append((self._places[e], operation, parts))
        return self._places[e]

    def at(self, box: Sequence[Interval]) -> list[Interval | None]:
        """Enclosures of the expressions on a box; None for one that has no value, or no bounds, in a part of it."""
        values = [*box, *self._start[len(box) :]]
        for place, operation, parts in self._operations:
            arguments = [values[n] for n in parts]
            if None in arguments:
                continue
            try:
                low, high = operation(*arguments)
            except (ValueError, ZeroDivisionError, OverflowError, EmptyIntervalError):
                continue
            if -math.inf < low and high < math.inf:
                values[place] = low, high
        return [values[n] for n in self._results]


def _number(e: sp.Basic) -> Interval | None:
    try:
        if e.is_Rational:
            value = int(e.p) / int(e.q)
            return (value, value) if e.is_Integer and abs(value) < 2**53 else outward(value, value)
        value = float(e)
    except (TypeError, ValueError, OverflowError):
        return None
    return _widened(value, value)


def _operation(e: sp.Basic) -> Callable[..., Interval] | None:
    if e.is_Add:
        return _sum
    if e.is_Mul:
        return _whole_product
    if e.is_Pow:
        return _power_with(e.exp)
    return _FUNCTIONS.get(e.func) if len(e.args) == 1 else None


def _sum(*parts: Interval) -> Interval:
    whole = parts[0]
    for p in parts[1:]:
        whole = total(whole, p)
    return whole


def _whole_product(*parts: Interval) -> Interval:
    whole = parts[0]
    for p in parts[1:]:
        whole = product(whole, p)
    return whole


def _power_with(exponent: sp.Expr) -> Callable[[Interval], Interval] | None:
    """The power with a rational exponent, a multiple of 1/2; a root only where the whole interval has one."""
    if not exponent.is_Rational or exponent.q > 2:
        return None
    number, of_root, inverse = abs(int(exponent.p)), exponent.q == 2, bool(exponent < 0)

    def power(x: Interval) -> Interval:
        if of_root:
            if x[0] < 0:
                raise EmptyIntervalError
            x = square_root(x)
        result = x if number == 1 else _power(x, number)
        return _reciprocal(result) if inverse else result

    return power


def _widened(low: float, high: float) -> Interval:
    """By more than the error of a function of the library."""
    return outward(low - LIBRARY_ERROR * abs(low), high + LIBRARY_ERROR * abs(high))


def _cosine_of(x: Interval) -> Interval:
    return _wave(math.cos, x, 0.0)


def _sine_of(x: Interval) -> Interval:
    return _wave(math.sin, x, 0.5)


def _wave(function: Callable[[float], float], x: Interval, first: float) -> Interval:
    """A sine or cosine, which has a maximum at `first` times π, and at every even number of times π from there."""
    low, high = x
    if max(-low, high) > LARGEST_ANGLE:
        return -1.0, 1.0
    ends = function(low), function(high)
    least, most = _widened(min(ends), max(ends))
    # An extreme that rounding puts just outside is counted: the interval only becomes wider.
    start, end = low / math.pi - first - CIRCULAR_ERROR * (1 + abs(low)), high / math.pi - first
    end += CIRCULAR_ERROR * (1 + abs(high))
    extremes = range(math.ceil(start), min(math.floor(end), math.ceil(start) + 1) + 1)
    least = -1.0 if any(n % 2 for n in extremes) else max(least, -1.0)
    most = 1.0 if any(n % 2 == 0 for n in extremes) else min(most, 1.0)
    return least, most


def _tangent(x: Interval) -> Interval:
    return product(_sine_of(x), _reciprocal(_cosine_of(x)))


def _cotangent(x: Interval) -> Interval:
    return product(_cosine_of(x), _reciprocal(_sine_of(x)))


def _exponential(x: Interval) -> Interval:
    return _widened(math.exp(x[0]), math.exp(x[1]))


def _logarithm(x: Interval) -> Interval:
    return _widened(math.log(x[0]), math.log(x[1]))


def _modulus(x: Interval) -> Interval:
    low, high = x
    return (low, high) if low >= 0 else (-high, -low) if high <= 0 else (0.0, max(-low, high))


def _sign(x: Interval) -> Interval:
    """The slope of a modulus: [-1, 1] across the kink."""
    return (1.0, 1.0) if x[0] > 0 else (-1.0, -1.0) if x[1] < 0 else (-1.0, 1.0)


def _impulse(x: Interval) -> Interval:
    if x[0] <= 0 <= x[1]:
        raise ValueError
    return 0.0, 0.0


_FUNCTIONS: Mapping[Any, Callable[[Interval], Interval]] = {
    sp.sin: _sine_of, sp.cos: _cosine_of, sp.tan: _tangent, sp.cot: _cotangent, sp.exp: _exponential,
    sp.log: _logarithm, sp.Abs: _modulus, sp.sign: _sign, sp.DiracDelta: _impulse,
}  # fmt: skip
