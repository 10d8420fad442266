"""Times in the field of a centre, against the same integral by quadrature."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.questions.quadrature import number_between, time_between

r = sp.Symbol("r", real=True)
a, K = sp.symbols("a K", positive=True)
VALUES = {a: sp.Rational(7, 5), K: sp.Rational(3, 2)}


@pytest.mark.parametrize(
    ("square", "start", "end", "way"),
    [
        (2 * K * (1 / r - 1 / a), a, a / 2, -1),  # a fall from rest
        (2 * K * (1 / r - 1 / a), a, sp.S.Zero, -1),
        (K * (a - r) * (r - a / 3) / r**2, a / 3, a, 1),  # half an orbit, Kepler's equation
        (K * (a - r) * (r - a / 3) / r**2, a / 3, a / 2, 1),
        (K * (a - r) / (r + a), a, a / 4, -1),
    ],
)
def test_the_time_is_that_of_quadrature(square: sp.Expr, start: sp.Expr, end: sp.Expr, way: int) -> None:
    speed = way * sp.sqrt(square)
    found = time_between(r, speed, start, end, way)
    by_quadrature = number_between(r, speed, start, end, VALUES)
    assert found is not None
    assert by_quadrature is not None
    assert float(found.xreplace(VALUES)) == pytest.approx(float(by_quadrature), rel=1e-5)


def test_a_cubic_under_the_root_is_no_elementary_integral() -> None:
    assert time_between(r, -sp.sqrt(K * (a**3 - r**3)), a, sp.S.Zero, -1) is None
