"""Antiderivatives, differentiated again; what is hostile ends soon."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.forms.antiderivatives import antiderivative, multiplied_out
from lagrange.algebra.forms.limits import LARGEST_INTEGRAND
from lagrange.core.effort import allowed
from tests.support.exterior import real_point

x, y, z, r, theta, phi = sp.symbols("x y z r theta phi", real=True)
a, b, R, length, omega, g, m = sp.symbols("a b R l omega g m", positive=True)
k, a1, a2, at = sp.symbols("k a_1 a_2 a_t", real=True)
sin, cos, exp, log, sqrt = sp.sin, sp.cos, sp.exp, sp.log, sp.sqrt
TABLE = [
    x**3 * y,
    (a * x + b) ** -2,
    x * cos(omega * x + y),
    x**2 * sin(x) ** 2,
    sin(2 * x) * cos(3 * x) * sin(x + y),
    sin(x) ** 3 * cos(x) ** 2,
    exp(-k * x) * cos(omega * x) * x,
    x * sp.sinh(x),
    1 / (x * (x + 1)),
    1 / (x**2 - a**2),
    1 / (x**2 + a**2),
    (2 * x + 1) / (x**2 + x + 1),
    1 / (x**2 + x + 1),
    (x**2 + 1) / (x**2 + 4),
    x / (1 + x) ** 3,
    x**3 / (x**4 + 1),
    sqrt(a**2 - x**2),
    sqrt(x**2 + y**2),
    1 / sqrt(a**2 + x**2),
    y**2 / (x**2 + y**2) ** sp.Rational(3, 2),
    x * sqrt(2 * x + 1),
    sp.tan(x),
    sp.tan(x) ** 2,
    1 / cos(x),
    1 / cos(x) ** 2,
    cos(x) / sin(x) ** 2,
    sp.sec(x) * sp.tan(x),
    sin(x) / (1 + cos(x)),
    1 / (1 + cos(a * x)),
    1 / (1 - cos(x + y)),
    1 / (1 + sin(x + y)),
    1 / (1 - sin(a * x)),
    log(x) * x,
    sp.atan(x) * x,
    log(cos(x)) * sin(x),
    cos(a * x) * cos(b * x),
    sp.sign(x) + sp.Abs(x),
    x**a,
]


@pytest.mark.parametrize("e", TABLE, ids=str)
def test_the_derivative_of_an_antiderivative(e):
    found = antiderivative(e, x)
    assert found is not None
    point = real_point((), (), list(e.free_symbols | {a}), 3)
    difference = (sp.diff(found, x) - e).xreplace(point).doit()
    assert abs(sp.N(difference, 40)) < sp.Float(10) ** -30


def test_real_on_both_sides_of_zero():
    assert antiderivative(1 / x, x).subs(x, -2) == log(2)
    assert antiderivative(1 / a, a) == log(a)
    assert antiderivative(sin(x) / (1 + cos(x)), x) == -log(1 + cos(x))
    assert antiderivative(cos(x) / sin(x), x) == log(sp.Abs(sin(x)))


HOSTILE = [
    (x + y + z + r + theta + 1) ** 20,
    ((x + sin(x) + y) ** 12) * (x + cos(y) + z) ** 8,
    sin(sin(sin(sin(x)))),
    exp(exp(exp(x) + x) + x),
    (x**2 + 1) ** 20 / (x**3 + x * y + z) ** 3,
    sp.prod([log(x + n) for n in range(1, 8)]),
    sp.prod([1 / (x + n * y) for n in range(1, 9)]),
    sum(sin(n * x + y) ** n * x**n for n in range(1, 12)),
]


@pytest.mark.parametrize("e", HOSTILE, ids=lambda e: str(e)[:30])
def test_hostile_coefficients_stay_small(e):
    """Nothing is expanded beyond the limits: what comes out is at most some thousand operations, or nothing."""
    found = antiderivative(e, x)
    assert found is None or sp.count_ops(found) < 30 * LARGEST_INTEGRAND
    assert sp.count_ops(multiplied_out(e)) < 200 * LARGEST_INTEGRAND


@pytest.mark.parametrize("function", [sp.tan, sp.tanh, sp.sinh])
def test_functions_within_one_another_are_not_doubled(function):
    """tanh u = sinh u/cosh u twenty deep has its innermost argument a million times."""
    e = x
    for _ in range(20):
        e = function(e)
    with allowed(2_000):
        assert antiderivative(e, x) is None
    alone = antiderivative(function(2 * x), x)
    assert abs((alone.diff(x) - function(2 * x)).subs(x, 0.3).evalf()) < 1e-12


def test_waves_beside_hyperbolic_functions_stay_real():
    e = sp.sinh(a * x) ** 2 * sp.cosh(b * x) * sin(theta)
    found = antiderivative(e, x)
    assert found is not None
    assert not found.has(sp.I)
    values = {a: 0.7, b: 1.3, theta: 0.4, x: 0.3}
    assert abs((found.diff(x) - e).subs(values).evalf()) < 1e-12
