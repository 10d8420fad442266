"""Motions q'' = A(t) + B(t) q', differentiated."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.linear_in_speed import of_rates_in_time
from lagrange.core.symbols import prime, t

x = sp.Symbol("x", real=True)
a, b, g, place, speed = sp.symbols("a b g x_0 v_0", positive=True)


@pytest.mark.parametrize(
    "acceleration",
    [
        a * t - g,
        a / (1 + b * t) - g,
        g - b * prime(x) * t**0 / (1 + b * t),
        (a - g * prime(x)) / (1 - b * t),  # a rocket with drag
    ],
)
def test_the_solution_satisfies_the_equation_and_begins_as_it_should(acceleration: sp.Expr) -> None:
    found = of_rates_in_time(x, acceleration, place, speed)
    assert found is not None
    way, rate = found
    numbers = {a: sp.Rational(3, 2), b: sp.Rational(1, 3), g: 2, place: 5, speed: 7}
    assert way.xreplace({t: sp.S.Zero}).subs(numbers).evalf() == pytest.approx(5)
    for at in (0.3, 1.7):
        values = {**numbers, t: at}
        assert float(way.diff(t).subs(values)) == pytest.approx(float(rate.subs(values)))
        assert float(rate.diff(t).subs(values)) == pytest.approx(float(acceleration.subs(prime(x), rate).subs(values)))


@pytest.mark.parametrize(
    "acceleration", [-x * t, -t * prime(x) ** 2, -g * prime(x), a * t - g * prime(x) / (1 - b * t)]
)
def test_other_equations_are_left(acceleration: sp.Expr) -> None:
    assert of_rates_in_time(x, acceleration, place, speed) is None
