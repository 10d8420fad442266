"""Inequalities that are not linear in their quantity: the ends, put back into the inequality."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.values.bounds_of_one import ends_of_one

u = sp.Symbol("u", positive=True)
theta = sp.Symbol("theta", positive=True)


@pytest.mark.parametrize(
    ("e", "low", "high"),
    [
        (3 * u**2 - 12, 2, None),
        (12 - 3 * u**2, None, 2),
        ((u - 1) * (3 - u), 1, 3),
        (4 - 1 / u, sp.Rational(1, 4), None),
        (u**2 + 1, None, None),
    ],
)
def test_a_polynomial_has_its_simple_positive_roots_as_ends(e: sp.Expr, low: object, high: object) -> None:
    ends = ends_of_one(e, u)
    assert ends is not None
    assert ends.wanted == u
    for end, expected in ((ends.low, low), (ends.high, high)):
        assert (end is None) is (expected is None)
        assert end is None or float(end) == pytest.approx(float(expected))  # type: ignore[arg-type]


def test_sine_and_cosine_of_an_acute_angle_leave_the_tangent() -> None:
    ends = ends_of_one(3 * sp.sin(theta) - 2 * sp.cos(theta), theta)
    assert ends is not None
    assert ends.wanted == sp.tan(theta)
    assert ends.high is None
    assert ends.low is not None
    assert math.isclose(float(ends.low), 2 / 3)


@pytest.mark.parametrize("e", [(u - 1) ** 2 * (u - 3), (u - 1) * (u - 3), sp.exp(u) - 2, u - sp.Symbol("c")])
def test_what_is_no_single_statement_is_left(e: sp.Expr) -> None:
    """A root where the sign does not change, an outside of two roots, no polynomial, another unknown."""
    assert ends_of_one(e, u) is None
