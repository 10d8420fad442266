"""What a text means: numbers, functions, vectors."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment
from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import (
    EquationRead,
    read_equation,
    read_scalar,
    read_vector,
)
from tests.support.expression_texts import (
    al,
    cos,
    f,
    l,
    m,
    same,
    scope,
    sin,
    sqrt,
    theta,
    vector,
    x,
    y,
)

v, w, om, om_1 = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'", "theta_1'"))


def symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, positive=True)


def test_equation_of_vectors() -> None:
    read = read_equation(Fragment.of("r_P' = [x, y] - cross(k, r_P)"), scope())
    assert same(read.lhs, vector(l * cos(theta) * om, l * sin(theta) * om, 0))
    assert same(read.rhs, vector(x - l * cos(theta), y - l * sin(theta), 0))
    assert read_equation(Fragment.of("r_P = 0"), scope()).rhs == Vector.zero()
    assert isinstance(read_equation(Fragment.of("0 = r_P"), scope()), EquationRead)


VECTORS: dict[str, Vector] = {
    "i": vector(1, 0, 0),
    "j": vector(0, 1, 0),
    "k": vector(0, 0, 1),
    "e_x": vector(1, 0, 0),
    "e_y + e_z": vector(0, 1, 1),
    "x*i + y*j": vector(x, y, 0),
    "x i + y j": vector(x, y, 0),
    "x i - 2 y k": vector(x, 0, -2 * y),
    "-i": vector(-1, 0, 0),
    "l (sin(theta) i - cos(theta) j)": vector(l * sin(theta), -l * cos(theta), 0),
    "l n": vector(l * sin(theta), -l * cos(theta), 0),
    "(x i + y j)/m": vector(x / m, y / m, 0),
    "[x, y]": vector(x, y, 0),
    "[x, y, 1]": vector(x, y, 1),
    "[x, atan2(y, x)]": vector(x, sp.atan2(y, x), 0),
    "[sin theta, f(x, y)]": vector(sin(theta), f(x, y), 0),
    "2 [x, y] + i": vector(2 * x + 1, 2 * y, 0),
    "cross(i, j)": vector(0, 0, 1),
    "cross(x i, y k)": vector(0, -x * y, 0),
    "r_P'": vector(l * cos(theta) * om, l * sin(theta) * om, 0),
    "r_P''": vector(l * (cos(theta) * al - sin(theta) * om**2), l * (sin(theta) * al + cos(theta) * om**2), 0),
    "n'": vector(cos(theta) * om, sin(theta) * om, 0),
    "diff(r_P, theta)": vector(l * cos(theta), l * sin(theta), 0),
    "diff(r_P, t)": vector(l * cos(theta) * om, l * sin(theta) * om, 0),
    "(x i)'": vector(v, 0, 0),
    "sin theta i": vector(sin(theta), 0, 0),
    "sin theta n": vector(sin(theta) ** 2, -sin(theta) * cos(theta), 0),
    "norm(r_P) i": vector(sqrt(l**2 * sin(theta) ** 2 + l**2 * cos(theta) ** 2), 0, 0),
    "dot(r_P, i) j": vector(0, l * sin(theta), 0),
    "i - i": vector(0, 0, 0),
    "x' i": vector(v, 0, 0),
}


@pytest.mark.parametrize("text", VECTORS)
def test_vector(text: str) -> None:
    assert same(read_vector(Fragment.of(text), scope()), VECTORS[text])


# has another unit vector; otherwise the unit vector, with a note
k, i = symbol("k"), symbol("i")
DECLARED_K: dict[str, tuple[Vector, bool]] = {
    "[k*x, y]": (vector(k * x, y, 0), False),
    "k*x*i": (vector(k * x, 0, 0), False),
    "k i": (vector(k, 0, 0), False),
    "-k*x*i + k*y*j": (vector(-k * x, k * y, 0), False),
    "sin(k*t) i": (vector(sin(k * t), 0, 0), False),
    "x i + y*k": (vector(x, 0, y), True),
    "k": (vector(0, 0, 1), True),
    "x*k": (vector(0, 0, x), True),
    "k*x*e_z": (vector(0, 0, k * x), False),
    "e_z": (vector(0, 0, 1), False),
    "sin(k)*k": (vector(0, 0, sin(k)), True),
    "k*(x*i + y*j)": (vector(k * x, k * y, 0), False),
    "k*r_P": (vector(k * l * sin(theta), -k * l * cos(theta), 0), False),
    "cross(x' k, r_P)": (vector(v * l * cos(theta), v * l * sin(theta), 0), True),
    "k*x*i/l + m*j": (vector(k * x / l, m, 0), False),
}


@pytest.mark.parametrize("text", DECLARED_K)
def test_vector_where_k_is_a_stiffness(text: str) -> None:
    notes: list[Diagnostic] = []
    expected, noted = DECLARED_K[text]
    assert same(read_vector(Fragment.of(text), scope("k"), notes), expected)
    assert bool([n for n in notes if "`k`" in n.message and "unit vector" in n.message]) == noted


def test_a_declared_k_is_the_scalar_where_a_scalar_is_wanted() -> None:
    assert read_scalar(Fragment.of("k x^2/2"), scope("k")) == k * x**2 / 2
    assert read_scalar(Fragment.of("k(x + y)"), scope("k")) == k * (x + y)
    assert same(read_vector(Fragment.of("i*x*j"), scope("i")), vector(0, i * x, 0))


@pytest.mark.parametrize(("name", "inverse"), [("acosh", sp.cosh), ("arsinh", sp.sinh), ("arctanh", sp.tanh)])
def test_inverse_hyperbolic_functions(name: str, inverse: type[sp.Function]) -> None:
    """cosh(acosh y) = y, at a number."""
    read = read_scalar(Fragment.of(f"{name}(x)"), scope())
    number = sp.Rational(1, 2) if name == "arctanh" else sp.Rational(5, 2)
    assert abs(inverse(read.xreplace({x: number})).evalf() - number) < 1e-12
