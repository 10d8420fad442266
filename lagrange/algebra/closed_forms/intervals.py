"""Intervals of floating-point numbers, rounded outwards: what an expression lies between on a box.

Every operation is widened by one unit in the last place, a sine or cosine by more than the error of the library, so
that the true value is never outside. An interval without 0 proves that an expression does not vanish on the box.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TypeAlias

import sympy as sp

from lagrange.algebra.closed_forms.limits import CIRCULAR_ERROR

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
        low = high = 0.0
        for a in e.args:
            x, y = enclosure(a, box)
            low, high = outward(low + x, high + y)
        return low, high
    if e.is_Mul:
        total = (1.0, 1.0)
        for a in e.args:
            total = _product(total, enclosure(a, box))
        return total
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


def _product(a: Interval, b: Interval) -> Interval:
    ends = [0.0 if x == 0 or y == 0 else x * y for x in a for y in b]
    return outward(min(ends), max(ends))


def _power(x: Interval, n: int) -> Interval:
    try:
        ends = x[0] ** n, x[1] ** n
    except OverflowError:
        return EVERYTHING if n % 2 else (0.0, math.inf)
    low, high = outward(outward(*sorted(ends))[0], outward(*sorted(ends))[1])
    if n % 2:
        return low, high
    return (0.0 if x[0] <= 0 <= x[1] else max(0.0, low)), high
