"""Values of expressions in ordinary floating point: to tell soon that two of them differ.

Nothing is decided by them alone: what seems to agree is decided exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import sympy as sp

from lagrange.core.floats import FUNCTIONS


def approximate(e: sp.Expr, point: Mapping[sp.Symbol, float]) -> float:
    """The value of an expression; nan if it has none there, or has a function that is not known here."""
    try:
        return _value(e, point)
    except (ArithmeticError, ValueError, KeyError, TypeError):
        return math.nan


def _value(e: sp.Expr, point: Mapping[sp.Symbol, float]) -> float:
    if e.is_Symbol:
        return point[e]
    if e.is_Number or not e.args:
        return float(e)
    values = [_value(a, point) for a in e.args]
    if e.is_Add:
        return math.fsum(values)
    if e.is_Mul:
        return math.prod(values)
    if e.is_Pow:
        result = values[0] ** values[1]
        return result if isinstance(result, float | int) else math.nan
    return FUNCTIONS[type(e)](*values)


def root_near(function: Callable[[float], float], start: float) -> float | None:
    """A zero of a function, by the secant rule; None if none is found."""
    a, b = start, start + 0.1
    fa, fb = function(a), function(b)
    for _ in range(_STEPS):
        if fb == fa or not math.isfinite(fb):
            return None
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        fb = function(b)
        if abs(b - a) <= 1e-13 * (1 + abs(b)):
            return b
    return None


_STEPS = 60
