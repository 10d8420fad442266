"""Finite forms of exact forms, and the table of antiderivatives, against numerical and symbolic differentiation."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.forms.exact_forms import differentiated, potential, potential_of
from lagrange.core.symbols import Slots, Unspecified, prime, t
from tests.support.exterior import concrete, real_point

x, y, z, r, theta, phi = sp.symbols("x y z r theta phi", real=True)
x1, y1, x2, y2 = sp.symbols("x1 y1 x2 y2", real=True)
a, b, R, length, omega, g, m = sp.symbols("a b R l omega g m", positive=True)
k, a1, a2, at = sp.symbols("k a_1 a_2 a_t", real=True)
u = sp.Symbol("u", real=True)
sin, cos, exp, log, sqrt = sp.sin, sp.cos, sp.exp, sp.log, sp.sqrt
f = Unspecified.of("f", "XYZ", x, y, z)
moving = Unspecified.of("f", "XYZ", x - R * t, y, z)
carried = Unspecified.of("f", "XYZ", x - u, y, z)

EVERYTHING = (x, y, z, r, theta, phi, x1, y1, x2, y2, t)
SLOTS = Slots(EVERYTHING[:-1], (u,))


def differential(e: sp.Expr) -> list[sp.Expr]:
    return [differentiated(e, v, SLOTS) for v in EVERYTHING]


def form(**coefficients: object) -> list[sp.Expr]:
    return [sp.sympify(coefficients.get(v.name, 0)) for v in EVERYTHING]


WRITTEN = [
    ("circle", form(x=2 * x, y=2 * y), x**2 + y**2),
    ("halves are cleared", form(x=x, y=y), x**2 + y**2),
    ("rod", form(x1=x1 - x2, x2=x2 - x1, y1=y1 - y2, y2=y2 - y1), (x1 - x2) ** 2 + (y1 - y2) ** 2),
    ("rod, doubled", form(x1=2 * x1 - 2 * x2, x2=2 * x2 - 2 * x1), (x1 - x2) ** 2),
    ("product", form(x=2 * x * y + z, y=x**2, z=x), x**2 * y + x * z),
    ("driven", form(x=sin(omega * t), t=omega * x * cos(omega * t)), x * sin(omega * t)),
    ("cosine", form(theta=-sin(theta)), cos(theta)),
    ("weight", form(theta=m * g * length * sin(theta)), cos(theta)),
    ("rolling", form(x=1, theta=-R), x - R * theta),
    ("Ex. 7", form(x1=a1, x2=a2, t=at), a1 * x1 + a2 * x2 + at * t),
    ("angle", form(x=-y / (x**2 + y**2), y=x / (x**2 + y**2)), sp.atan2(y, x)),
    ("angle, the other way", form(x=y / (x**2 + y**2), y=-x / (x**2 + y**2)), sp.atan2(x, y)),
    ("angle over a length", form(x=a / (x**2 + a**2)), sp.atan(x / a)),
    ("distance", form(x=x / sqrt(x**2 + y**2), y=y / sqrt(x**2 + y**2)), sqrt(x**2 + y**2)),
    ("logarithm", form(x=1 / x), log(sp.Abs(x))),
    ("logarithm of a length", form(x=x / (x**2 + a**2)), log(x**2 + a**2)),
    ("arc sine", form(x=1 / sqrt(a**2 - x**2), y=1), y + sp.asin(x / a)),
    ("undefined function", form(x=f.partial(0), y=f.partial(1), z=f.partial(2)), f),
    ("undefined function that moves", differential(moving), moving),
    ("undefined function, carried", differential(carried), carried),
    ("x f", form(x=f + x * f.partial(0), y=x * f.partial(1), z=x * f.partial(2)), x * f),
    ("prescribed", form(x=1, t=-prime(u)), x - u),
    (
        "prescribed product",
        form(x=sin(u), y=prime(u), t=x * cos(u) * prime(u) + y * prime(u, 2)),
        x * sin(u) + y * prime(u),
    ),
]


@pytest.mark.parametrize(("coefficients", "expected"), [w[1:] for w in WRITTEN], ids=[w[0] for w in WRITTEN])
def test_as_a_person_writes_it(coefficients, expected):
    assert potential(coefficients, EVERYTHING, SLOTS) == expected


FUNCTIONS = [
    x * sin(theta) * cos(phi) + length * cos(theta - phi),
    (x1 - x2) * cos(theta) + (y1 - y2) * sin(theta),
    (a + b * cos(omega * t)) * cos(theta) - y,
    sqrt((x1 - x2) ** 2 + (y1 - y2) ** 2) + z * t,
    exp(-k * t) * (x * cos(omega * t) + y * sin(omega * t)),
    x**2 * y**3 * sin(omega * t) ** 2,
    x**2 / y + log(x**2 + y**2),
    x / (x + y),
    (x**2 + y**2 - length**2) ** 2,
    1 / sqrt(x**2 + y**2 + z**2),
    sin(x * y) + sp.tan(theta) * z,
    sp.atan(y / x) * x + sp.atan2(x, z),
    exp(x**2) * y + x * t**2,
    sp.cosh(x) * y + sp.sinh(z * t),
    sqrt(x) * y ** sp.Rational(1, 3),
    sin(x) ** 3 * cos(y) ** 2 * z,
    R * (theta + sin(theta)) * t - x * y * z,
    sp.Abs(x) * y,
    x**a * y,
    f**2 * z + x,
    sin(f) * y,
    Unspecified.of("h", "X", x * y) * z,
    u**2 * x + sin(u * y) + prime(u) * t,
    (x + y + z) ** 5 * theta,
    log(x) * log(y) * z,
    r**2 * theta - r * cos(phi) * t,
]


@pytest.mark.parametrize("e", FUNCTIONS, ids=str)
def test_the_differential_of_a_function_is_integrated(e):
    """The difference of e and what comes out has no variables: it is the same at five real points."""
    found = potential_of(differential(e), EVERYTHING, SLOTS)
    assert found is not None
    difference = concrete(found - e, (u,))
    parameters = real_point((), (), list(difference.free_symbols - {*EVERYTHING}), 1)
    values = [sp.N(difference.xreplace({**real_point((), (), EVERYTHING, n), **parameters}), 30) for n in range(5)]
    assert max(values) - min(values) < sp.Float(10) ** -20


@pytest.mark.parametrize("e", FUNCTIONS, ids=str)
def test_a_potential_is_a_primitive_times_a_constant(e):
    coefficients = differential(e)
    found = potential(coefficients, EVERYTHING, SLOTS)
    point = real_point((), (), list(set(EVERYTHING) | concrete(e, (u,)).free_symbols | {R, a, b, k}), 7)
    ratios = set()
    for v, c in zip(EVERYTHING, coefficients, strict=True):
        c = concrete(c, (u,))
        if c != 0:
            change = concrete(differentiated(found, v, SLOTS), (u,))
            ratios.add(round(float(sp.N((change / c).xreplace(point), 30)), 12))
    assert len(ratios) == 1
    assert ratios != {0.0}


NOT_FOUND = [
    ("not closed", form(x=y, y=-x)),
    ("not closed in time", form(x=sin(omega * t), y=-cos(omega * t))),
    ("closed up to a sign", form(x=f.partial(0), y=-f.partial(1))),
    ("not elementary", form(x=exp(-(x**2)))),
    ("not elementary in two", form(x=y * sin(x) / x, y=sp.S.One)),
    ("a prescribed motion's own integral", form(t=u)),
    ("of unknown sign under the root", form(x=1 / sqrt(k * x**2 + 1))),
    ("too large", form(x=sum(sin(n * x) ** 2 * x**n for n in range(1, 60)))),
    ("no derivative known", form(x=sp.Max(x, 1))),
]


@pytest.mark.parametrize("coefficients", [n[1] for n in NOT_FOUND], ids=[n[0] for n in NOT_FOUND])
def test_none_where_none_is_found(coefficients):
    assert potential(coefficients, EVERYTHING, SLOTS) is None


def test_zero_has_the_potential_zero():
    assert potential(form(), EVERYTHING, SLOTS) == 0


def test_scaling_and_order_of_variables_do_not_matter():
    e = x**2 * sin(theta) + y * t
    order = (theta, t, y, x)
    coefficients = [7 * m * differentiated(e, v, SLOTS) for v in order]
    assert sp.expand(potential(coefficients, order, SLOTS) - e) == 0
    assert sp.expand(potential_of(coefficients, order, SLOTS) - 7 * m * e) == 0
