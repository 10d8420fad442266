"""The expression language, as the contract defines it: what a text means, where it is refused, and with which message.

Every expected value is built by hand from plain symbols. A refusal has a code and a column, and says what to do.

Inequalities: their limit, and the side that they permit.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import t
from lagrange.expressions.reader import is_inequality, limit_of, read_equation, read_scalar
from tests.support.expression_texts import (
    EQUATIONS,
    R,
    a,
    al,
    al_1,
    b,
    c,
    cos,
    ddu,
    delta_x,
    dt,
    dtheta,
    du,
    dx,
    dy,
    f,
    g,
    half,
    l,
    lambda_rod,
    m,
    phi,
    pi,
    same,
    scope,
    sin,
    sqrt,
    tan,
    theta,
    theta_1,
    u,
    x,
    x1,
    y,
)

v, w, om, om_1 = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'", "theta_1'"))


def symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, positive=True)


MEANINGS: dict[str, sp.Expr | int] = {
    # -- precedence: powers before signs before products, powers from the right
    "-x^2": -(x**2),
    "(-x)^2": x**2,
    "-x^-2": -(x**-2),
    "2^-2": sp.Rational(1, 4),
    "2^3^2": 512,
    "x^2^3": x**8,
    "x^-y": x ** (-y),
    "x**2": x**2,
    "x**-1": 1 / x,
    "x^(1/2)": x**half,
    "x^1/2": x / 2,
    "2x^2": 2 * x**2,
    "-2^2": -4,
    "2 x^2 y": 2 * x**2 * y,
    "x - y - m": x - y - m,
    "cos(60 deg)*x": x / 2,
    "x sin 30°": x / 2,
    "90 degrees": sp.pi / 2,
    "x/y/m": x / y / m,
    "x/y*m": x * m / y,
    "x - -y": x + y,
    "x + -y": x - y,
    "+x": x,
    "--x": x,
    "x*-y": -x * y,
    "x/-2": -x / 2,
    "x -y": x - y,
    "2 -x": 2 - x,
    "m*x + g*y^2/2": m * x + g * y**2 / 2,
    # -- numbers are exact
    "0.5": half,
    ".5": half,
    "5.": 5,
    "0.1 + 0.2": sp.Rational(3, 10),
    "2e3": 2000,
    "2E3": 2000,
    "1e-3": sp.Rational(1, 1000),
    "1.5e+2 x": 150 * x,
    "9.81": sp.Rational(981, 100),
    "007": 7,
    "1/3": sp.Rational(1, 3),
    # -- products without a sign
    "2 m g l": 2 * m * g * l,
    "m g sin(theta)": m * g * sin(theta),
    "2(x + y)": 2 * x + 2 * y,
    "(x + y)(x - y)": x**2 - y**2,
    "(x)(y)": x * y,
    "2x": 2 * x,
    "m(x'' + g)": m * a + m * g,
    "x(y + 1)": x * y + x,
    "m x''": m * a,
    "m x'y'": m * v * w,
    "x'^2": v**2,
    "x'(y)": v * y,
    "l theta'^2 sin(theta)": l * om**2 * sin(theta),
    "pi x": pi * x,
    "2pi": 2 * pi,
    "pi(x + y)": pi * x + pi * y,
    "t(t + 1)": t**2 + t,
    # -- fractions and products
    "1/2 m": m / 2,
    "1/2m": m / 2,
    "1/2 m x'^2": m * v**2 / 2,
    "g/l sin(theta)": g / l * sin(theta),
    "g/l*sin(theta)": g / l * sin(theta),
    "x/(2 m)": x / (2 * m),
    # -- derivatives with respect to time
    "x'": v,
    "x''": a,
    "x ''": a,
    "theta''": al,
    "theta''(t)": al,
    "theta'(t)": om,
    "theta(t)": theta,
    "x(t)^2": x**2,
    "u(t)": u,
    "u'(t)": du,
    "u''": ddu,
    "(x^2)'": 2 * x * v,
    "(x^2 u)'": 2 * x * v * u + x**2 * du,
    "(m x')'": m * a,
    "(x y)''": a * y + 2 * v * w + x * b,
    "(t^2)'": 2 * t,
    "theta_1''": al_1,
    "sin(theta)'": cos(theta) * om,
    # -- what is pasted from books and browsers
    "θ": theta,
    "θ'": om,
    "θ''": al,
    "θ̇": om,
    "θ̈": al,
    "ẍ": a,
    "ẋ": v,
    "ẏ²": w**2,
    "x″": a,
    "x′": v,
    "x’": v,
    "x′′": a,
    "x’’": a,
    "θ₁": theta_1,
    "θ̈₁": al_1,
    "θ_1''": al_1,
    "x₁": x1,
    "x − y": x - y,
    "m·g": m * g,
    "m⋅g": m * g,
    "m × g": m * g,
    "x²": x**2,
    "x²y³": x**2 * y**3,
    "x⁻²": x**-2,
    "x¹²": x**12,
    "sin²(θ)": sin(theta) ** 2,
    "sin²θ": sin(theta) ** 2,
    "√x": sqrt(x),
    "√2": sqrt(2),
    "√(x + y)": sqrt(x + y),
    "√(x)/y": sqrt(x) / y,
    "½ m": m / 2,
    "ϑ": theta,
    "φ": phi,
    "ϕ": phi,
    "π": pi,
    "𝑥": x,
    "ｓｉｎ(ｘ)": sin(x),
    "x\u00a0+\u2009y": x + y,
    # -- functions
    "sin(x)": sin(x),
    "cos(x) tan(x)": cos(x) * tan(x),
    "cot(x) + sec(x) + csc(x)": sp.cot(x) + sp.sec(x) + sp.csc(x),
    "asin(x) + acos(x) + atan(x)": sp.asin(x) + sp.acos(x) + sp.atan(x),
    "atan2(y, x)": sp.atan2(y, x),
    "sinh(x) + cosh(x) + tanh(x)": sp.sinh(x) + sp.cosh(x) + sp.tanh(x),
    "exp(x)": sp.exp(x),
    "log(x)": sp.log(x),
    "sqrt(m)": sqrt(m),
    "abs(x)": sp.Abs(x),
    "abs(m)": m,
    "sign(x)": sp.sign(x),
    "sqrt(x^2)": sp.Abs(x),
    "sin(pi/6)": half,
    "atan(1)": pi / 4,
    "sin^2(theta)": sin(theta) ** 2,
    "sin^2 theta": sin(theta) ** 2,
    "sin**2(theta)": sin(theta) ** 2,
    "sin(theta)^2": sin(theta) ** 2,
    "sin^2(theta) + cos^2(theta)": sin(theta) ** 2 + cos(theta) ** 2,
    "sin^2(x) y": sin(x) ** 2 * y,
    "sin theta": sin(theta),
    "sin theta cos theta": sin(theta) * cos(theta),
    "sin 2 theta": sin(2 * theta),
    "sin 2theta": sin(2 * theta),
    "sin 2 theta cos theta": sin(2 * theta) * cos(theta),
    "sin theta/2": sin(theta) / 2,
    "sin(theta/2)": sin(theta / 2),
    "sin theta + x": sin(theta) + x,
    "sin theta^2": sin(theta**2),
    "m g sin theta": m * g * sin(theta),
    "2 sin theta": 2 * sin(theta),
    "sin -x": -sin(x),
    "cos(theta) x": cos(theta) * x,
    "sin(theta) cos(theta)": sin(theta) * cos(theta),
    "sin (theta) x": sin(theta) * x,
    "sin theta'": sin(om),
    "sin theta x'": sin(theta) * v,
    "m l sin θ θ̈ + m l cos θ θ̇²": m * l * sin(theta) * al + m * l * cos(theta) * om**2,
    "sin 2 theta theta'": sin(2 * theta) * om,
    "sin m theta'": sin(m) * om,
    "cos m t x'": cos(m * t) * v,
    "exp -m t x": sp.exp(-m * t) * x,
    "x sin(theta)(y)": x * sin(theta) * y,
    "exp(-t) sin(2 t)": sp.exp(-t) * sin(2 * t),
    # -- partial and total derivatives
    "diff(x^2 y, x)": 2 * x * y,
    "diff(x^2 y, t)": 2 * x * v * y + x**2 * w,
    "diff(sin(theta), t)": cos(theta) * om,
    "diff(x', t)": a,
    "diff(m x'^2/2, x')": m * v,
    "diff(diff(m x'^2/2, x'), t)": m * a,
    "diff(m l, m)": l,
    "diff(u x, t)": du * x + u * v,
    "diff(t x, t)": x + t * v,
    "diff(x, y)": 0,
    # -- undefined functions
    "f(x, y)": f(x, y),
    "f(x - u, 0)": f(x - u, sp.S.Zero),
    "diff(f(x, y), x)": f(x, y).partial(0),
    "diff(f(x^2, y), x)": f(x**2, y).partial(0) * 2 * x,
    "diff(f(x, y), t)": f(x, y).partial(0) * v + f(x, y).partial(1) * w,
    "f(x, y)'": f(x, y).partial(0) * v + f(x, y).partial(1) * w,
    "diff(f(x, y), X)": f(x, y).partial(0),
    "diff(diff(f(x, y), X), Y)": f(x, y).partial(0).partial(1),
    "f(x, y)^2": f(x, y) ** 2,
    # -- differentials, virtual displacements, multipliers
    "sin(theta)*d(x) - cos(theta)*d(y)": sin(theta) * dx - cos(theta) * dy,
    "m d(x)": m * dx,
    "d(t)": dt,
    "delta(x)": delta_x,
    "m x'' delta(x)": m * a * delta_x,
    "2*x*lambda_rod": 2 * x * lambda_rod,
    "d(theta)": dtheta,
    # -- products of vectors
    "dot(i, j)": 0,
    "dot(x i + y j, x i + y j)": x**2 + y**2,
    "norm(x i + y j)": sqrt(x**2 + y**2),
    "norm(3 i + 4 j)": 5,
    "dot([x, y], [1, 2])": x + 2 * y,
    "dot(cross(i, j), k)": 1,
    "dot(r_P, r_P)": l**2 * sin(theta) ** 2 + l**2 * cos(theta) ** 2,
    "dot(r_P', n)": sp.S.Zero + l * om * cos(theta) * sin(theta) - l * om * sin(theta) * cos(theta),
}


@pytest.mark.parametrize("text", MEANINGS)
def test_meaning(text: str) -> None:
    assert same(read_scalar(Fragment.of(text), scope()), sp.sympify(MEANINGS[text]))


# -- equations ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("text", EQUATIONS)
def test_equation(text: str) -> None:
    read = read_equation(Fragment.of(text), scope())
    lhs, rhs = EQUATIONS[text]
    assert same(read.lhs, sp.sympify(lhs))
    assert same(read.rhs, sp.sympify(rhs))


# has another unit vector; otherwise the unit vector, with a note
k, i = symbol("k"), symbol("i")


# -- whatever is typed ---------------------------------------------------------------------------------------------------


NAMES = {s.name for s in (x, y, theta, phi, theta_1, x1, u, m, l, g, R, c, lambda_rod, t)} | {"k", "e"}
NAMES |= {f"{o}({n})" for o in ("d", "delta") for n in ("x", "y", "theta", "phi", "theta_1", "x1", "u", "t")}


# Relations


@pytest.mark.parametrize(
    ("text", "limit", "side"),
    [("x >= a", "x = a", 1), ("x <= a", "x = a", -1), ("x = a", "x = a", None), ("x ≥ a", "x = a", 1)],
)
def test_sides(text: str, limit: str, side: int | None) -> None:
    found, permitted = limit_of(Fragment.of(text), "constraint")
    assert (" ".join(found.text.split()), permitted) == (limit, side)
    assert is_inequality(Fragment.of(text)) is (side is not None)
