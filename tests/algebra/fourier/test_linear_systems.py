"""Linear equations solved in the ring, as long as that stays small."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.fourier.linear_systems import solved_linear


def test_linear_equations() -> None:
    a, b = sp.symbols("a b", real=True)
    assert solved_linear([[a, b], [b, -a]], [sp.S.One, sp.S.Zero], Surface()) == [a / (a**2 + b**2), b / (a**2 + b**2)]
    assert solved_linear([[sp.S.One, a, sp.S.Zero], [sp.S.Zero, sp.S.Zero, b]], [b, b], Surface()) == [None, None, 1]
