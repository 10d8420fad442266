"""Values of expressions in ordinary floating point: to tell soon that two of them differ.

Nothing is decided by them alone: what seems to agree is decided exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import sympy as sp

_FUNCTIONS: dict[type, Callable[[float], float]] = {
    sp.sin: math.sin,
    sp.cos: math.cos,
    sp.tan: math.tan,
    sp.cot: lambda x: 1 / math.tan(x),
    sp.asin: math.asin,
    sp.acos: math.acos,
    sp.atan: math.atan,
    sp.exp: math.exp,
    sp.log: math.log,
    sp.Abs: abs,
}


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
    return _FUNCTIONS[type(e)](*values)
