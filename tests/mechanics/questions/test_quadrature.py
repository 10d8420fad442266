"""The time between two places as an integral, by hand."""

from __future__ import annotations

import math

import mpmath
import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.symbols import Bounded
from lagrange.mechanics.questions.quadrature import in_sine, not_elementary, time_between, time_between_speeds, toward

g, l = sp.symbols("g l", positive=True)
theta = sp.Symbol("theta", real=True)
start = Bounded("theta_0", sp.S.Zero, sp.pi)


def test_on_a_cycloid_the_time_does_not_depend_on_the_start() -> None:
    speed = -sp.sqrt(g * (sp.cos(theta) - sp.cos(start)) / (l * (1 + sp.cos(theta))))
    taken = time_between(theta, speed, start, sp.S.Zero, -1)
    assert taken is not None
    assert is_zero(taken - sp.pi * sp.sqrt(l / g)) is True
    half = time_between(theta, speed, start, sp.pi / 3, -1)  # t = 2 √(l/g) acos(sin(θ/2)/sin(θ_0/2))
    assert half is not None
    expected = 2 * math.acos(math.sin(math.pi / 6) / math.sin(1))
    assert float(half.xreplace({g: sp.S.One, l: sp.S.One, start: sp.Integer(2)})) == pytest.approx(expected)


def test_between_two_speeds_the_acceleration_is_integrated() -> None:
    v, f, c = sp.Symbol("x'", real=True), *sp.symbols("f c", positive=True)
    first, last = sp.symbols("v_0 v_1", positive=True)
    taken = time_between_speeds(v, -(f + c * v**2), first, last)
    assert taken is not None
    values = {f: 2.0, c: 0.5, first: 3.0, last: 1.0}
    expected = mpmath.quad(lambda x: 1 / (2.0 + 0.5 * x * x), [1, 3])
    assert float(taken.xreplace({s: sp.Float(x) for s, x in values.items()})) == pytest.approx(float(expected))
    backwards = time_between_speeds(v, f - c * v**3, -first, -last)  # v < 0 where the acceleration is positive
    assert backwards is None or float(backwards.xreplace({s: sp.Float(x) for s, x in values.items()})) > 0
    assert time_between_speeds(v, -c * v**3, first, -last) is None  # through rest


x = sp.Symbol("x", real=True)
u, v, a = sp.symbols("U v a", positive=True)
VALUES = {u: sp.Rational(3, 2), v: sp.Rational(6, 5), a: sp.Rational(7, 10)}
WELL = v**2 - u * sp.tan(a * x) ** 2


@pytest.mark.parametrize("end", [sp.atan(v / sp.sqrt(u)) / a, sp.pi / (8 * a)])
def test_the_time_is_that_of_numerical_integration(end: sp.Expr) -> None:
    time = time_between(x, sp.sqrt(WELL), sp.S.Zero, end, 1)
    assert time is not None
    most, way = (float(s.evalf(subs=VALUES)) for s in (sp.atan(v / sp.sqrt(u)) / a, end))
    square = lambda y: 1.44 - 1.5 * mpmath.tan(mpmath.mpf("0.7") * y) ** 2  # noqa: E731
    number = mpmath.quad(lambda s: 2 * s / mpmath.sqrt(abs(square(most - s**2))), [(most - way) ** 0.5, most**0.5])
    assert abs(float(time.xreplace(VALUES)) - number) < 1e-6


def test_a_sine_is_no_variable_beyond_a_right_angle() -> None:
    assert in_sine(x, WELL, sp.S.Zero, sp.pi / a) is None
    assert in_sine(x, v**2 - u * sp.cos(a * x), sp.S.Zero, sp.pi / (8 * a)) is None


def test_a_time_that_is_not_elementary_is_a_number_times_letters_or_an_integral() -> None:
    """V = A x⁴ (Landau and Lifshitz, § 11): the quarter period from x = a is ∫_0^1 du/√(1 − u⁴) times √(m/2A)/a."""
    strength, m = sp.symbols("A m", positive=True)
    speed = -sp.sqrt(2 * strength * (a**4 - x**4) / m)
    number, _ = not_elementary((x, speed, a, sp.S.Zero), -1, {})
    assert number is not None
    lemniscate = sp.gamma(sp.Rational(1, 4)) ** 2 / (4 * sp.sqrt(2 * sp.pi))
    assert float((number * a * sp.sqrt(2 * strength / m)) / lemniscate) == pytest.approx(1, rel=1e-5)
    swing = -sp.sqrt(2 * g * (sp.cos(theta) - sp.cos(start)) / l)
    number, whole = not_elementary((theta, swing, start, sp.S.Zero), -1, {})
    assert number is None
    assert whole.limits == ((theta, 0, start),)
    assert is_zero(whole.function.doit() + 1 / swing) is True


def test_the_velocity_taken_leads_to_the_end() -> None:
    """A string that winds up on a drum: θ' = v/(L − a θ), which has a pole where the string ends (Greenwood)."""
    length, speed = sp.symbols("L v_0", positive=True)
    winding = speed / (length - a * theta)
    assert toward([-winding, winding], theta, (sp.S.Zero, sp.S.One), 1) == winding
    assert toward([winding, -winding], theta, (sp.S.Zero, -sp.S.One), -1) == -winding
    assert toward([winding], theta, (sp.S.Zero, sp.S.One), None) is None


def test_from_rest_the_velocity_has_the_sense_of_the_way() -> None:
    inward = -sp.sqrt(l**2 - theta**2) / theta  # towards a centre, from θ = l
    assert toward([-inward, inward], theta, (l, sp.S.Zero), -1) == inward
