"""Determinants by expansion."""

from __future__ import annotations

import sympy as sp

from lagrange.core.determinants import expanded_determinant


def test_the_value_is_that_of_sympy_and_nothing_is_multiplied_out() -> None:
    a, b, c, d = sp.symbols("a:d")
    rows = [[a + b, c, 0], [d, a - b, 1], [1, 0, (a + b) / c]]
    found = expanded_determinant(rows)
    assert sp.simplify(found - sp.Matrix(rows).det()) == 0
    assert expanded_determinant([[(a + b) ** 2, 0], [0, c + d]]) == (a + b) ** 2 * (c + d)
    assert expanded_determinant([]) == 1
    assert expanded_determinant([[0, 0], [a, b]]) == 0
