"""Signs before and in products: the value stays, and no minus sign is left that a sum can take."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.leading_signs import with_whole_contents, without_leading_minus

a, b, c = sp.symbols("a b c", positive=True)


@pytest.mark.parametrize("e", [-2 * a / (a * b - 1), -c * (a * b - 1), -(a - b) / c, -a / (b - c) ** 3])
def test_a_sum_takes_the_sign(e: sp.Expr) -> None:
    written = without_leading_minus(e)
    assert sp.simplify(written - e) == 0
    assert all(f != -1 for f in written.args)


@pytest.mark.parametrize("e", [-a * b, -a / (b + c), a / (b - c), -a / (b - c) ** 2])
def test_what_no_sum_can_take_stays(e: sp.Expr) -> None:
    assert without_leading_minus(e) == e


def test_common_numbers_stand_before_a_product() -> None:
    """4 a (1 − M/m) for 2 a (2 − 2 M/m), and 2 b/(3 + c) for 6 b·2/(18 + 6 c)."""
    assert str(with_whole_contents(2 * a * (2 - 2 * b / c))) == "4*a*(-b/c + 1)"
    assert with_whole_contents(12 * b / (18 + 6 * c)) == 2 * b / (3 + c)
    assert with_whole_contents(2 * a + 2) == 2 * a + 2
