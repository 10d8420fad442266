"""Roots in time, against numbers."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import t
from lagrange.mechanics.questions.times import fades, in_order, limit_in_time, times

w, a, b, c = sp.symbols("w a b c", positive=True)
NUMBERS = {w: 1.3, a: 0.4, b: 1.7, c: 0.9}

CASES = [
    (b * t - a * t**2, 1),
    (a * sp.cos(w * t), 1),
    (a * sp.sin(w * t), 1),
    (b * sp.cos(w * t) - a, 1),
    (b * sp.sin(w * t) + a, 1),
    (a * sp.cos(w * t) + b * sp.sin(w * t), 1),
    (a * (sp.cos(w * t) - 1) - b * sp.sin(w * t), 1),
    (sp.exp(-c * t) * sp.sin(w * t), 1),
    (b * sp.exp(-c * t) - a, 1),
    (sp.cosh(w * t) - 3, 1),
    (sp.log(sp.cosh(w * t)) / c - 2, 1),
    (sp.log(1 + a * t) - b, 1),
    ((a - c) * t**2 + b, 1),
    (a * t + b, 0),
    (b * sp.cosh(w * t), 0),
    (sp.exp(-a * t) * (3 * c * sp.sinh(w * t) - b * sp.cosh(w * t)), 1),
    (b * sp.exp(-a * t) - 2 * b * sp.exp(-w * t), 1),
    (sp.exp(-a * t) * (2 * sp.sinh(w * t) + 3 * sp.cosh(w * t)), 0),
]


@pytest.mark.parametrize(("function", "number"), CASES)
def test_the_first_root_is_the_first_one_in_numbers(function: sp.Expr, number: int) -> None:
    roots = times(function)
    assert roots is not None
    found = [float(r.value.subs(NUMBERS)) for r in in_order(roots)]
    assert len(found) == number
    at = sp.lambdify(t, function.subs(NUMBERS), "math")
    values = [at(0.001 + 0.01 * n) for n in range(1500)]
    changes = [0.001 + 0.01 * n for n in range(1499) if values[n] * values[n + 1] < 0]
    assert len(changes) >= number
    for root in found:
        assert root == pytest.approx(changes[0], abs=0.02)


@pytest.mark.parametrize(
    "function", [t - sp.cos(t), sp.cos(w * t) - sp.cos(a * t), a * sp.cos(w * t) + b * sp.sin(w * t) + c]
)
def test_what_has_no_closed_form_is_left_open(function: sp.Expr) -> None:
    assert times(function) is None


def test_a_sine_in_a_rate_stays_a_sine() -> None:
    """SymPy rewrites what is within sinh and cosh as well, sin(alpha) with the imaginary unit."""
    rate = sp.sqrt(a * sp.sin(b))
    [root] = times(sp.cosh(rate * t) - 3) or ()
    assert not root.value.has(sp.I)
    assert float(root.value.subs(NUMBERS)) == pytest.approx(float((sp.acosh(3) / rate).subs(NUMBERS)))
    assert limit_in_time(sp.tanh(w * t) * sp.sin(b)) == sp.sin(b)


def test_a_time_as_a_function_of_a_coordinate_is_not_negative() -> None:
    y = sp.Symbol("y", real=True)
    [root] = times(a * t**2 - y, positive=False) or ()
    assert root.value.xreplace({a: 2, y: 8}) == 2


def test_the_limit_of_decaying_exponentials() -> None:
    c, m, g, w = sp.symbols("c m g w", positive=True)
    assert limit_in_time(m * g / c * (1 - sp.exp(-c * t / m))) == m * g / c
    assert limit_in_time(sp.sqrt(m * g / c) * sp.tanh(c * t)) == sp.sqrt(m * g / c)
    assert limit_in_time(t * sp.exp(-c * t) * sp.cos(w * t) + g) == g
    for endless in (t + sp.exp(-c * t), sp.exp(c * t), sp.cos(w * t) + sp.exp(-c * t), sp.exp(-w * t + c * t)):
        assert limit_in_time(endless) is None
    assert fades(g * sp.exp(-c * t))
    assert not fades(g * sp.exp(-c * t) + m)


def test_exponentials_that_cancel_leave_no_root() -> None:
    """g - g tanh^2 is g/cosh^2, whose numerator is a constant."""
    assert times(b * sp.cosh(w * t) ** 2 - b * sp.sinh(w * t) ** 2) == []


def test_a_logarithm_of_two_negative_numbers() -> None:
    """A parachute that opens at the speed a slows the fall to b: both are above the final speed, 1."""
    swift = sp.sqrt(c) * a * sp.cosh(w * t) + sp.sinh(w * t)
    slow = b * (sp.sqrt(c) * sp.cosh(w * t) + a * c * sp.sinh(w * t))
    roots = times(swift - slow)
    assert roots is not None
    values = {a: 10, b: 2, c: 1, w: 1.3}
    [time] = [float(r.value.subs(values)) for r in roots]
    assert float((swift - slow).subs(values).subs(t, time)) == pytest.approx(0, abs=1e-12)
    for condition in roots[0].conditions:
        sides = [sp.sympify(e).subs(values) for e in (condition.lhs, condition.rhs)]
        assert all(e.is_real for e in sides)
        assert {"≠": sides[0] != sides[1], "≥": sides[0] >= sides[1], ">": sides[0] > sides[1]}[condition.relation]
