"""Squares of lengths on plane curves, compared at points of the curves."""

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.on_a_curve import where_zero

x, y, z = sp.symbols("x y z", real=True)
a = sp.Symbol("a", positive=True)
r2 = x**2 + y**2


@pytest.mark.parametrize(
    ("curve", "short"),
    [
        (r2**2 - a**2 * (x**2 - y**2), 4 * a**4 * r2),  # lemniscate
        (r2**2 - a**2 * x**2, None),  # two circles that touch: 4a⁴ x², whose root is |x|
        (r2 - a**2, 4 * a**2),
        (r2 + z**2 - a**2, 4 * a**2),
        (x**2 - 2 * a * y, None),  # nothing leaves the root
        (x**2 / a**2 + y**2 / (4 * a**2) - 1, None),
        (y - sp.sin(x), None),
    ],
)
def test_the_square_of_a_gradient(curve: sp.Expr, short: sp.Expr | None) -> None:
    square = sp.Add(*(curve.diff(v) ** 2 for v in (x, y, z)))
    found = where_zero(square, curve, (x, y, z))
    assert sp.expand(found - (square if short is None else short)) == 0
    if short is not None:
        assert sp.rem(sp.expand(square - found), sp.expand(curve), x) == 0
