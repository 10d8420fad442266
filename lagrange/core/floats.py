"""The elementary functions in ordinary floating point, for pictures and for a first look at whether two numbers differ.

No verdict depends on such a value.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from types import MappingProxyType

import sympy as sp

FUNCTIONS: Mapping[type[sp.Basic], Callable[..., float]] = MappingProxyType(
    {
        sp.sin: math.sin,
        sp.cos: math.cos,
        sp.tan: math.tan,
        sp.cot: lambda x: 1 / math.tan(x),
        sp.asin: math.asin,
        sp.acos: math.acos,
        sp.atan: math.atan,
        sp.atan2: math.atan2,
        sp.sinh: math.sinh,
        sp.cosh: math.cosh,
        sp.tanh: math.tanh,
        sp.exp: math.exp,
        sp.log: math.log,
        sp.Abs: abs,
        sp.sign: lambda x: math.copysign(1, x) if x else 0.0,
    }
)
"""The value of each function at the values of its arguments; ValueError or ArithmeticError if it has none."""
