"""Inequalities in numbers, against the same worked out in floating point."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.core.units import NO_DIMENSION, unit_of
from lagrange.values.bounds import bound_with, ends_of_one
from lagrange.values.quantities import Quantity, Values

W, mu, P = sp.symbols("W mu P", positive=True)
alpha, theta = sp.symbols("alpha theta", real=True)
NEWTON = unit_of("N")
assert NEWTON is not None
NUMBERS = {W: sp.Integer(100), mu: sp.Rational(3, 10), alpha: sp.pi / 9}
VALUES = Values(NUMBERS, frozenset(NUMBERS), {W: NEWTON.dimension, mu: NO_DIMENSION, alpha: NO_DIMENSION})
UP = math.radians(20) + math.atan(0.3)
DOWN = math.radians(20) - math.atan(0.3)


@pytest.mark.parametrize(
    ("left", "right", "wanted", "relation", "number", "unit"),
    [
        (W * (sp.tan(alpha) - mu) / (1 + mu * sp.tan(alpha)), P, P, "≥", 100 * math.tan(DOWN), "N"),
        ((1 - mu * sp.tan(alpha)) * P, W * (sp.tan(alpha) + mu), P, "≤", 100 * math.tan(UP), "N"),
        (sp.S.One, mu * (mu + 2 * sp.tan(theta)), sp.tan(theta), "≥", (1 - 0.09) / 0.6, ""),
        (mu, sp.cos(theta), sp.cos(theta), "≥", 0.3, ""),
        (W, 50 * sp.exp(2 * P), P, "≥", math.log(2) / 2, ""),
        (W * sp.exp(-mu * P), sp.Integer(20), P, "≥", math.log(5) / 0.3, ""),
    ],
)
def test_what_is_left_is_bounded(
    left: sp.Expr, right: sp.Expr, wanted: sp.Expr, relation: str, number: float, unit: str
) -> None:
    found = bound_with(left, right, VALUES)
    assert found is not None
    assert (found.left, found.relation, found.bound.unit) == (wanted, relation, unit)
    assert found.bound.number == pytest.approx(number)


def test_the_angle_itself_is_bounded_in_the_sense_of_its_function() -> None:
    rising, falling = (bound_with(mu, f(theta), VALUES) for f in (sp.tan, sp.cos))
    assert rising is not None
    assert falling is not None
    assert rising.angle is not None
    assert falling.angle is not None
    assert (rising.angle.relation, float(rising.angle.value)) == ("≥", pytest.approx(math.atan(0.3)))
    assert (falling.angle.relation, float(falling.angle.value)) == ("≤", pytest.approx(math.acos(0.3)))


def test_what_is_not_linear_is_bounded_by_the_roots_of_a_polynomial() -> None:
    acute = bound_with(W / (W * sp.tan(theta)), 2 * mu, VALUES)  # tan θ ≥ 1/0.6
    assert acute is not None
    assert acute.angle is not None
    assert (acute.relation, acute.angle.relation) == ("≥", "≥")
    assert float(acute.angle.value) == pytest.approx(math.atan(1 / 0.6))
    speed = bound_with(P**2 * sp.cos(alpha), W * sp.sin(alpha), VALUES)
    assert speed is not None
    assert (speed.left, speed.relation) == (P, "≤")
    assert speed.bound.number == pytest.approx(math.sqrt(100 * math.tan(math.radians(20))))
    outside = bound_with(W * P**2, P**3 + P, VALUES)  # of two roots
    assert outside is not None
    assert isinstance(outside.left, Quantity)


def test_an_acute_angle_is_bounded_on_both_sides_where_both_say_something() -> None:
    normal = P * sp.sin(theta) + W * sp.cos(theta)
    across = sp.Abs(P * sp.cos(theta) - W * sp.sin(theta)) / normal
    pushed = Values({**NUMBERS, P: sp.Integer(60)}, frozenset({*NUMBERS, P}), VALUES.units)
    both = bound_with(across, mu, pushed)
    assert both is not None
    assert both.angle is not None
    assert both.angle.low is not None
    ends = [math.atan(0.6) + side * math.atan(0.3) for side in (-1, 1)]
    assert [float(both.angle.low), float(both.angle.value)] == pytest.approx(ends)
    lightly = Values({**NUMBERS, P: sp.Integer(20)}, frozenset({*NUMBERS, P}), VALUES.units)
    above = bound_with(across, mu, lightly)  # at rest on level ground, too
    assert above is not None
    assert above.angle is not None
    assert (above.low, above.angle.low) == (None, None)
    assert float(above.angle.value) == pytest.approx(math.atan(0.2) + math.atan(0.3))


def test_an_inequality_in_which_nothing_is_left_holds_or_not() -> None:
    holds = [bound_with(sp.tan(alpha), factor * mu, VALUES) for factor in (1, 2)]
    assert [b is not None and b.holds for b in holds] == [False, True]


def test_an_inequality_in_two_quantities_keeps_its_sides() -> None:
    found = bound_with(mu * P, W * sp.cos(theta), VALUES)
    assert found is not None
    assert isinstance(found.left, Quantity)
    assert (found.relation, found.bound.formula) == ("≤", 100 * sp.cos(theta))
    assert bound_with(P, 2 * P * sp.cos(theta), VALUES) is None  # no value occurs


def test_a_magnitude_bounds_on_both_sides() -> None:
    found = bound_with(sp.Abs(P - W * sp.sin(alpha)) / (W * sp.cos(alpha)), mu, VALUES)
    assert found is not None
    assert found.low is not None
    tilt = math.radians(20)
    limits = [100 * (math.sin(tilt) + side * 0.3 * math.cos(tilt)) for side in (-1, 1)]
    assert [found.low.number, found.bound.number] == pytest.approx(limits)
    assert (found.relation, found.bound.unit) == ("≤", "N")
    assert bound_with(mu, sp.Abs(P - W), VALUES).low is None  # type: ignore[union-attr]


def test_a_positive_denominator_is_multiplied_out() -> None:
    found = bound_with((W - P) / (W + P), mu, VALUES)
    assert found is not None
    assert (found.left, found.relation) == (P, "≥")
    assert found.bound.number == pytest.approx(100 * 0.7 / 1.3)
    unsure = bound_with((W + P) / (W - P), mu, VALUES)
    assert unsure is not None
    assert isinstance(unsure.left, Quantity)


# -- Inequalities that are not linear in their quantity: the ends, put back into the inequality ------------------------


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
