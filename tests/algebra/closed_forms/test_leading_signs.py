"""Signs before and in products: the value stays, and no minus sign is left that a sum can take."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.leading_signs import without_leading_minus

a, b, c = sp.symbols("a b c", positive=True)


@pytest.mark.parametrize("e", [-2 * a / (a * b - 1), -c * (a * b - 1), -(a - b) / c, -a / (b - c) ** 3])
def test_a_sum_takes_the_sign(e: sp.Expr) -> None:
    written = without_leading_minus(e)
    assert sp.simplify(written - e) == 0
    assert all(f != -1 for f in written.args)


@pytest.mark.parametrize("e", [-a * b, -a / (b + c), a / (b - c), -a / (b - c) ** 2])
def test_what_no_sum_can_take_stays(e: sp.Expr) -> None:
    assert without_leading_minus(e) == e
