"""The expression language, read from the contract: what a text means, where it is refused, and what is said about it.

Every expected value is built by hand from plain symbols. A refusal has a code and a column, and says what to do.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.expression_size import Measures
from lagrange.core.symbols import Slots, Unspecified, t
from lagrange.core.vectors import Vector
from lagrange.expressions.bounded import MAX_SIZE
from lagrange.expressions.reader import (
    EquationRead,
    FunctionDeclaration,
    Scope,
    canonical_name,
    read_equation,
    read_scalar,
    read_vector,
)

x, y, theta, phi, theta_1, x1 = (sp.Symbol(n, real=True) for n in ("x", "y", "theta", "phi", "theta_1", "x1"))
v, w, om, om_1 = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'", "theta_1'"))
a, b, al, al_1 = (sp.Symbol(n, real=True) for n in ("x''", "y''", "theta''", "theta_1''"))
u, du, ddu = (sp.Symbol(n, real=True) for n in ("u", "u'", "u''"))
m, l, g, R, c = (sp.Symbol(n, positive=True) for n in ("m", "l", "g", "R", "c"))
dx, dy, dtheta, dt = (sp.Symbol(f"d({n})", real=True) for n in ("x", "y", "theta", "t"))
delta_x = sp.Symbol("delta(x)", real=True)
lambda_rod = sp.Symbol("lambda_rod", real=True)
sin, cos, tan, sqrt, pi, half = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi, sp.Rational(1, 2)


def f(*arguments: sp.Expr) -> Unspecified:
    return Unspecified.of("f", ("X", "Y"), *arguments)


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(c) for c in components)
    return Vector((p, q, r))


def scope(*more: str) -> Scope:
    """Coordinates x, y, theta, phi, theta_1, x1, a prescribed u, parameters m, l, g, R, c and more, f(X, Y)."""
    names = {s.name: s for s in (m, l, g, R, c, lambda_rod)}
    names |= {n: sp.Symbol(n, positive=True) for n in more}
    functions = {"f": FunctionDeclaration("f", ("X", "Y"))}
    vectors = {"r_P": vector(l * sin(theta), -l * cos(theta), 0), "n": vector(sin(theta), -cos(theta), 0)}
    return Scope(names, Slots((x, y, theta, phi, theta_1, x1), (u,)), functions, vectors)


def same(found: sp.Expr | Vector, expected: sp.Expr | Vector) -> bool:
    if isinstance(found, Vector) or isinstance(expected, Vector):
        assert isinstance(found, Vector)
        assert isinstance(expected, Vector)
        return all(same(p, q) for p, q in zip(found.fixed().components, expected.fixed().components, strict=True))
    return found == expected or sp.expand(found - expected) == 0


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

EQUATIONS: dict[str, tuple[sp.Expr | int, sp.Expr | int]] = {
    "theta'' + g/l*sin(theta) = 0": (al + g / l * sin(theta), 0),
    "theta'' == 0": (al, 0),
    "0 = 0": (0, 0),
    "sin(theta)^2+cos(theta)^2 = 1": (sin(theta) ** 2 + cos(theta) ** 2, 1),
    "0*theta'' = 0": (0, 0),
    "m x'' = -m g": (m * a, -m * g),
    "m(x''+g) = 0": (m * (a + g), 0),
    "x=-y": (x, -y),
    "m*x'' = 2*x*lambda_rod": (m * a, 2 * x * lambda_rod),
    "2*x*d(x) + 2*y*d(y) = 0": (2 * x * dx + 2 * y * dy, 0),
    "2*x*delta(x) = 0": (2 * x * delta_x, 0),
}


@pytest.mark.parametrize("text", EQUATIONS)
def test_equation(text: str) -> None:
    read = read_equation(Fragment.of(text), scope())
    lhs, rhs = EQUATIONS[text]
    assert same(read.lhs, sp.sympify(lhs))
    assert same(read.rhs, sp.sympify(rhs))


def test_equation_of_vectors() -> None:
    read = read_equation(Fragment.of("r_P' = [x, y] - cross(k, r_P)"), scope())
    assert same(read.lhs, vector(l * cos(theta) * om, l * sin(theta) * om, 0))
    assert same(read.rhs, vector(x - l * cos(theta), y - l * sin(theta), 0))
    assert read_equation(Fragment.of("r_P = 0"), scope()).rhs == Vector.zero()
    assert isinstance(read_equation(Fragment.of("0 = r_P"), scope()), EquationRead)


# -- vectors -----------------------------------------------------------------------------------------------------------

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


# a file that declares k: the scalar inside component lists, inside arguments of scalar functions, and in any term that
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


# -- names that other languages have taken --------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name",
    [
        "e", "E", "I", "S", "N", "Q", "O", "C", "beta", "gamma", "zeta", "lambda", "d", "delta", "D", "Delta", "ln", "re", "im",
        "if", "for", "None", "True", "print", "y_1", "a_b_c", "Gamma", "mu_k", "factorial", "oo", "nan", "zoo", "Sum",
    ],
)  # fmt: skip
def test_free_names(name: str) -> None:
    known, s = scope(name), symbol(name)
    for text, expected in {
        name: s,
        f"{name}*x": s * x,
        f"2 {name} x": 2 * s * x,
        f"{name}^2": s**2,
        f"{name}(x + 1)": s * (x + 1),
        f"x/{name}": x / s,
        f"sin({name})": sin(s),
    }.items():
        assert same(read_scalar(Fragment.of(text), known), expected), text


def test_a_power_of_ten_is_a_product_where_e_is_declared() -> None:
    e = symbol("e")
    assert read_scalar(Fragment.of("2 e x"), scope("e")) == 2 * e * x
    assert read_scalar(Fragment.of("2e x"), scope("e")) == 2 * e * x
    assert read_scalar(Fragment.of("2e3"), scope()) == 2000
    e3 = symbol("e3")
    assert read_scalar(Fragment.of("2e3"), scope("e", "e3")) == 2 * e3
    found = refused("2e3", scope("e"))
    assert [d.code for d in found] == ["unknown-symbol"]
    assert "10^3" in found[0].help


def test_names_are_greek_letters_and_subscripts() -> None:
    known, omega_0 = scope("omega_0", "μ"), symbol("omega_0")
    assert read_scalar(Fragment.of("ω₀ t"), known) == omega_0 * t
    assert read_scalar(Fragment.of("ω_0t"), scope("omega_0t")) == symbol("omega_0t")
    assert read_scalar(Fragment.of("ωt"), scope("omega")) == symbol("omega") * t
    assert read_scalar(Fragment.of("mẍ"), scope()) == m * a


def test_the_script_ell_is_ell_where_that_is_declared_and_l_otherwise() -> None:
    ell = symbol("ell")
    assert read_scalar(Fragment.of("2ℓ t"), scope("ell")) == 2 * ell * t
    assert read_scalar(Fragment.of("2ell t"), scope("ell")) == 2 * ell * t
    assert read_scalar(Fragment.of("ℓ₁ t"), scope("ell_1")) == symbol("ell_1") * t
    assert read_scalar(Fragment.of("ℓ t"), scope("l")) == symbol("l") * t
    assert canonical_name("ℓ_0") == "ell_0"


def test_canonical_name() -> None:
    assert canonical_name("θ") == "theta"
    assert canonical_name(" phi_1 ") == "phi_1"
    assert canonical_name("e") == "e"
    for bad in ("", "2x", "x y", "x'", "t", "pi", "sin", "dot", "e_x", "a-b", "_x", "x" * 61, "ẋ", "π"):
        assert canonical_name(bad) is None, bad


# -- what is refused: text -> code, column, a word of the help ------------------------------------------------------

REFUSED: dict[str, tuple[str, int, str]] = {
    "": ("empty-expression", 1, "write"),
    "   \n": ("empty-expression", 1, "write"),
    "x +": ("ends-early", 4, "complete"),
    "x + * y": ("misplaced-operator", 5, "remove"),
    "* x": ("misplaced-operator", 1, "remove"),
    "x ^": ("ends-early", 4, "complete"),
    "()": ("empty-brackets", 1, "write"),
    "sin()": ("empty-brackets", 4, "write"),
    "sin(x, )": ("empty-brackets", 6, "write"),
    "f(x, )": ("empty-brackets", 4, "write"),
    "[x, ]": ("empty-brackets", 3, "write"),
    "f(, x)": ("misplaced-operator", 3, "comma"),
    "f(x,, y)": ("misplaced-operator", 5, "comma"),
    "sin": ("no-argument", 1, "sin(...)"),
    "m g sin": ("no-argument", 5, "sin(...)"),
    "sin + 1": ("no-argument", 1, "sin(...)"),
    "sin - x": ("no-argument", 1, "sin(-"),
    "sin * x": ("no-argument", 1, "sin(...)"),
    "sin(x": ("not-closed", 4, "add `)`"),
    "[x": ("not-closed", 1, "add `]`"),
    "((x)": ("not-closed", 1, "add `)`"),
    "x)": ("not-opened", 2, "remove"),
    "(x]": ("not-closed", 3, "`)`"),
    "{x}": ("unexpected-character", 1, "parentheses"),
    "(x, y)": ("list-in-parentheses", 3, "[a, b]"),
    "1,5": ("misplaced-operator", 2, "decimal point"),
    "ml": ("unknown-symbol", 1, "m l"),
    "m + mgl": ("unknown-symbol", 5, "m g l"),
    "sintheta": ("unknown-symbol", 1, "sin theta"),
    "thetaa": ("unknown-symbol", 1, "theta"),
    "Theta": ("unknown-symbol", 1, "theta"),
    "xdot": ("unknown-symbol", 1, "x'"),
    "theta_ddot": ("unknown-symbol", 1, "theta''"),
    "dx": ("unknown-symbol", 1, "d(x)"),
    "e^x": ("unknown-symbol", 1, "exp(x)"),
    "q": ("unknown-symbol", 1, "`x`"),
    "E": ("unknown-symbol", 1, "declared are"),
    "I": ("unknown-symbol", 1, "did you mean `l`"),
    "arcsin(x)": ("unknown-function", 1, "asin"),
    "ln(x)": ("unknown-function", 1, "log"),
    "tg(x)": ("unknown-function", 1, "tan"),
    "factorial(10**7)": ("unknown-function", 1, "the functions are"),
    "gamma(10**8)": ("unknown-function", 1, "the functions are"),
    "binomial(10**9,5*10**8)": ("unknown-function", 1, "the functions are"),
    "print(m)": ("unknown-function", 1, "the functions are"),
    "m'": ("prime-of-constant", 1, "coordinates:"),
    "2'": ("prime-of-constant", 1, "x'^2"),
    "pi'": ("prime-of-constant", 1, "coordinates:"),
    "x'''": ("too-many-primes", 1, "second"),
    "(x'')'": ("too-many-primes", 1, "second"),
    "diff(x'', t)": ("too-many-primes", 1, "second"),
    "'x": ("misplaced-prime", 1, "x'"),
    "sin'(x)": ("misplaced-prime", 4, "sin(x)'"),
    "f'(x, y)": ("prime-of-function", 1, "diff"),
    "f(x)": ("number-of-arguments", 1, "f(X, Y)"),
    "f": ("no-argument", 1, "f(X, Y)"),
    "atan2(x)": ("number-of-arguments", 1, "atan2(y, x)"),
    "sin(x, y)": ("number-of-arguments", 1, "sin(x)"),
    "dot(i)": ("number-of-arguments", 1, "dot(a, b)"),
    "diff(x)": ("number-of-arguments", 1, "diff(e, x)"),
    "diff(x, 2)": ("not-a-variable", 9, "coordinate"),
    "diff(x, x^2)": ("not-a-variable", 9, "coordinate"),
    "u(x)": ("argument-of-prescribed", 2, "u(t)"),
    "d(m)": ("not-a-differential", 1, "d(x)"),
    "delta(t)": ("not-a-differential", 1, "delta(x)"),
    "x + i": ("vector-for-scalar", 5, "unit vector"),
    "sin(r_P)": ("vector-for-scalar", 5, "dot(r_P, i)"),
    "cross(i, j)": ("vector-for-scalar", 1, "dot"),
    "[x, y]": ("vector-for-scalar", 1, "parentheses"),
    "[m*l](theta'')": ("vector-for-scalar", 1, "parentheses"),
    "r_P^2": ("vector-power", 1, "dot(a, a)"),
    "norm(x)": ("scalar-for-vector", 6, "x*i"),
    "1.2.3": ("bad-number", 4, "numbers"),
    "x.y": ("unexpected-character", 2, "dot"),
    "x⁻": ("bad-exponent", 2, "^2"),
    "sin^-1(x)": ("function-exponent", 5, "asin"),
    "sin^x(x)": ("function-exponent", 5, "sin(x)^n"),
    "2 3": ("missing-operator", 3, "*"),
    "x 2": ("missing-operator", 3, "*2"),
    "x = y": ("unexpected-equation", 3, "one side"),
    "x < 1": ("inequality", 3, "reversible"),
    "x >= 1": ("inequality", 3, "reversible"),
    "x ≤ 1": ("inequality", 3, "reversible"),
    "x != 1": ("inequality", 3, "="),
    "x/0": ("division-by-zero", 3, "0"),
    "x/(1-1)": ("division-by-zero", 4, "0"),
    "x/(y - y)": ("division-by-zero", 4, "0"),
    "0^-1": ("division-by-zero", 1, "positive"),
    "0^0": ("not-finite", 1, "positive"),
    "log(0)": ("not-finite", 1, "argument"),
    "tan(pi/2)": ("not-finite", 1, "argument"),
    "sqrt(-1)": ("not-real", 1, "positive"),
    "sqrt(-m)": ("not-real", 1, "negative"),
    "log(-2)": ("not-real", 1, "positive"),
    "asin(2)": ("not-real", 1, "-1 and 1"),
    "(-1)^x": ("not-real", 1, "whole"),
    "x # pull": ("unexpected-character", 3, "comments"),
    "theta''\x00": ("invisible-character", 8, "delete"),
    "theta''+\u200bg": ("invisible-character", 9, "delete"),
    "x\u202ey": ("invisible-character", 2, "delete"),
    "x\u00ady": ("invisible-character", 2, "delete"),
    "х": ("unexpected-character", 1, "Latin letter `x`"),
    "x₊": ("unexpected-character", 2, "write"),
    "x ± y": ("unexpected-character", 3, "sign"),
    'x"': ("unexpected-character", 2, "apostrophes"),
    "30°": ("unexpected-character", 3, "pi/180"),
    "∂x": ("unexpected-character", 1, "diff"),
    "__import__('os').system('id')": ("unexpected-character", 1, "letter"),
    "S('__import__(\"os\").getpid()')": ("unexpected-character", 4, "letter"),
    "lambda: 1": ("unexpected-character", 7, "="),
    "print(hello)": ("unknown-function", 1, "the functions are"),
    "[0]*10**10": ("vector-for-scalar", 1, "parentheses"),
    "'a'*10**10": ("misplaced-prime", 1, "x'"),
    "Sum(1,(x,1,10**10)).doit()": ("unexpected-character", 20, "write"),
    "24! * 24!": ("unexpected-character", 3, "factorial"),
}


def refused(text: str, known: Scope | None = None, limit: int = 10_000) -> tuple[Diagnostic, ...]:
    with pytest.raises(ProblemError) as caught:
        read_scalar(Fragment.of(text), known or scope(), limit=limit)
    return caught.value.diagnostics


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    found = refused(text)[0]
    code, column, help_ = REFUSED[text]
    assert found.span is not None
    assert (found.code, found.span.start + 1) == (code, column)
    assert found.span.end <= max(len(text), found.span.start + 1)
    assert help_ in found.help
    assert found.message[0] == "`" or found.message[0].islower() or found.message[0].isdigit()
    assert not found.message.endswith(".")


def test_every_unknown_name_of_a_text_is_reported_once() -> None:
    found = refused("ml + q + sin(ml) + w(q)")
    assert [(d.code, d.span.start) for d in found if d.span] == [
        ("unknown-symbol", 0),
        ("unknown-symbol", 5),
        ("unknown-function", 19),
    ]


EQUATIONS_REFUSED: dict[str, tuple[str, int]] = {
    "": ("empty-expression", 1),
    "=": ("empty-side", 1),
    "x =": ("empty-side", 4),
    "= x": ("empty-side", 1),
    "x": ("no-equals-sign", 2),
    "x = y = 0": ("several-equals-signs", 7),
    "x == y == 0": ("several-equals-signs", 8),
    "(x = 0)": ("misplaced-operator", 4),
    "x, y = 0": ("misplaced-operator", 2),
    "x = 0; y = 0": ("unexpected-character", 6),
    "y >= 0": ("inequality", 3),
    "x := 0": ("unexpected-character", 3),
    "x ≈ 0": ("unexpected-character", 3),
    "i = x": ("scalar-for-vector", 5),
    "9**9**9 = 0": ("exponent-too-large", 1),
}


@pytest.mark.parametrize("text", EQUATIONS_REFUSED)
def test_equation_refused(text: str) -> None:
    with pytest.raises(ProblemError) as caught:
        read_equation(Fragment.of(text), scope())
    found = caught.value.diagnostics[0]
    assert found.span is not None
    assert (found.code, found.span.start + 1) == EQUATIONS_REFUSED[text]
    assert found.help


# -- what could surprise is echoed ---------------------------------------------------------------------------------------

ECHOED: dict[str, tuple[sp.Expr, str]] = {
    "1/2m": (m / 2, "(1/2)*m"),
    "g/l sin(theta)": (g / l * sin(theta), "(g/l)*sin(theta)"),
    "sin theta/2": (sin(theta) / 2, "before the `/`"),
    "sin theta^2": (sin(theta**2), "sin(theta^2)"),
    "sin m x": (sin(m * x), "sin(m x)"),
    "sin theta'": (sin(om), "sin(theta')"),
    "sin -x": (sin(-x), "sin(-x)"),
    "sin^2 m x": (sin(m * x) ** 2, "sin^2(m x)"),
    "√-x": (sqrt(-x), "sqrt(-x)"),
    "sqrt 2 x": (sqrt(2 * x), "sqrt(2 x)"),
    "√2 x": (sqrt(2) * x, "before the `x`"),
    "sin x(y + 1)": (sin(x) * (y + 1), "before the `(`"),
    "sin theta x": (sin(theta) * x, "before the `x`"),
    "sqrt x y": (sqrt(x * y), "sqrt(x y)"),
    "x^1/2": (x / 2, "before the `/`"),
    "m(t)": (m * t, "m*t"),
    "x(2)": (2 * x, "x*2"),
    "√x y": (sqrt(x) * y, "before"),
    "|x| y |x|": (sp.Abs(x) * y * sp.Abs(x), "pairs"),
}


@pytest.mark.parametrize("text", ECHOED)
def test_a_surprising_reading_is_echoed(text: str) -> None:
    notes: list[Diagnostic] = []
    value, said = ECHOED[text]
    assert same(read_scalar(Fragment.of(text), scope(), notes), value)
    assert len(notes) == 1
    assert (notes[0].code, notes[0].level, notes[0].span is not None) == ("read-as", "note", True)
    assert said in notes[0].message
    assert notes[0].help


@pytest.mark.parametrize(
    "text",
    [
        "1/2 m", "2 m g l", "m(x + y)", "sin theta cos theta", "sin 2 theta", "sin theta x'", "g/l*sin(theta)", "-x^2", "theta''(t)", "sin^2 theta",
        "2e3", "x(y + 1)", "m g sin theta", "exp(-t) x", "sin omega t", "1/2 m x'^2 + 1/2 k x^2", "|x|", "x^(1/2)",
    ],
)  # fmt: skip
def test_a_plain_reading_is_not_echoed(text: str) -> None:
    notes: list[Diagnostic] = []
    read_scalar(Fragment.of(text), scope("omega", "k"), notes)
    assert notes == []


# -- limits ----------------------------------------------------------------------------------------------------------

LIMITS: dict[str, tuple[str, str]] = {
    "length": ("theta+" * 20_000 + "theta", "expression-too-long"),
    "nesting of brackets": ("(" * 61 + "x" + ")" * 61, "nested-too-deep"),
    "nesting of powers": ("x**" * 200 + "x", "nested-too-deep"),
    "nesting of functions": ("sin " * 200 + "x", "nested-too-deep"),
    "nesting of lists": ("[" * 200 + "x" + "]" * 200, "nested-too-deep"),
    "nesting of bars": ("|(" * 100 + "x" + ")|" * 100, "nested-too-deep"),
    "nesting of roots": ("√" * 200 + "x", "nested-too-deep"),
    "digits": ("1" * 31, "number-too-long"),
    "digits and decimals": ("1." + "1" * 30, "number-too-long"),
    "power of ten": ("1e400", "number-too-long"),
    "negative power of ten": ("1e-400", "number-too-long"),
    "long power of ten": ("1e" + "9" * 400, "number-too-long"),
    "superscript digits": ("x" + "¹" * 31, "number-too-long"),
    "exponent": ("x^21", "exponent-too-large"),
    "negative exponent": ("x^-21", "exponent-too-large"),
    "exponent of a number": ("2^100", "exponent-too-large"),
    "exponent of a function": ("sin^21(x)", "exponent-too-large"),
    "exponent with a symbol": ("2^(20000*x)", "exponent-too-large"),
    "computed exponent": ("theta''^(10^10)", "exponent-too-large"),
    "large exponent": ("theta'' + x^(10^18)", "exponent-too-large"),
    "tower": ("9**9**9", "exponent-too-large"),
    "decimal tower": ("10.0**10.0**10.0", "exponent-too-large"),
    "nested": ("(x^7)^6", "exponent-too-large"),
    "nested in sums": ("((x^5 + 1)^3 + 1)^3", "exponent-too-large"),
    "fine denominators": ("x^(1/100003)", "exponent-too-large"),
    "huge value": ("sin(sin(exp(exp(exp(3)))+3))", "number-too-large"),
    "many terms": ("(x + y + m + g + l + theta)^20 * (x + y + m + g + l + phi)^20", "expression-too-large"),
}


@pytest.mark.parametrize("what", LIMITS)
def test_limit(what: str) -> None:
    text, code = LIMITS[what]
    found = refused(text)
    assert [d.code for d in found] == [code]
    assert found[0].help
    assert found[0].span is not None


@pytest.mark.parametrize(
    "text",
    ["(" * 59 + "x" + ")" * 59, "1" * 30, "x^20", "x^-20", "(x^20)^2", "(x^8)^5", "x^(1/2)", "x + " * 2_499 + "x"],
    ids=lambda text: text[:12],
)
def test_just_within_the_limits(text: str) -> None:
    assert read_scalar(Fragment.of(text), scope()) is not None


def test_messages_of_limits_name_the_limit() -> None:
    assert "20" in refused("x^21")[0].message
    assert "20" in refused("2^100")[0].message
    assert "40" in refused("(x^20)^3")[0].message
    assert "60" in refused("(" * 61 + "x" + ")" * 61)[0].message
    assert "30" in refused("1" * 31)[0].message
    assert "10,000" in refused("x+" * 6_000 + "x")[0].message
    assert "2,000" in refused("x+" * 1_500 + "x", limit=2_000)[0].message


def test_abbreviations_do_not_get_around_the_limits() -> None:
    """Each name is an expression ten times as large as the one before."""
    value: sp.Expr = x + y
    known = scope()
    for step in range(60):
        known = replace(known, scalars={**known.scalars, "z": value})
        try:
            value = read_scalar(Fragment.of(f"sin(z) + z*cos(z + {step}) + z"), known)
        except ProblemError as error:
            codes = {d.code for d in error.diagnostics}
            break
    else:
        pytest.fail("no limit")
    assert codes <= {"expression-too-large", "nested-too-deep"}


# -- whatever is typed ---------------------------------------------------------------------------------------------------

PIECES = [
    *"+-*/^=()[]|,.'\"!#$%&:;<>?@\\_`{}~ 0123456789eExyijkdtπθ̇̈²√½₁−·″’𝑥ｘ\u200b\x00\n", "**", "==", "sin", "cos ", "sqrt", "abs(", "atan2(", "log",
    "exp(", "theta", "x'", "theta''", "(t)", "diff(", "dot(", "cross(", "norm(", "d(", "delta(", "f(", ", X)", "r_P", "u", "m ", "l", "1/2",
    "10^10", "2e3", "^20", "^(1/2)", "pi", "lambda_rod", "i", "j", "e_x", "0", "sign", "tan(pi/2)", "__class__", "lambda", "import",
]  # fmt: skip
NONSENSE = st.one_of(st.text(max_size=40), st.lists(st.sampled_from(PIECES), max_size=25).map("".join))
SENSIBLE = [*MEANINGS, *VECTORS, *EQUATIONS, *REFUSED]


@st.composite
def misspelt(draw: st.DrawFn) -> str:
    """A sensible text with a few pieces cut out, doubled, moved or put in."""
    text = draw(st.sampled_from(SENSIBLE))
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, len(text)))
        end = draw(st.integers(start, min(len(text), start + 6)))
        piece = draw(st.sampled_from(["", *PIECES, text[start:end] * 2, "(" + text + ")", text + "*" + text]))
        text = (text[:start] + piece + text[end:])[:2_000]
    return text


def check_reading(text: str) -> None:
    """A value that is made of what is declared and of moderate size, or errors at places of the text that say what to do."""
    known = scope("k", "e")
    for read in (read_scalar, read_vector, read_equation):
        notes: list[Diagnostic] = []
        shown = "nothing is wrong"
        try:
            value = read(Fragment.of(text), known, notes)
        except ProblemError as error:
            notes.extend(error.diagnostics)
            shown = error.show()
        else:
            sides = [value.lhs, value.rhs] if isinstance(value, EquationRead) else [value]
            for e in (c for s in sides for c in (s.fixed().components if isinstance(s, Vector) else [s])):
                assert not e.has(sp.I, sp.nan, sp.zoo, sp.oo, -sp.oo), text
                assert Measures().of(e).size <= MAX_SIZE
                assert {s.name.rstrip("'") for s in e.free_symbols} <= NAMES
        assert shown
        for d in notes:
            assert d.span is not None
            assert 0 <= d.span.start <= d.span.end <= max(len(text), d.span.start + 1)
            assert d.help or d.message == "`==` is read as `=`"


NAMES = {s.name for s in (x, y, theta, phi, theta_1, x1, u, m, l, g, R, c, lambda_rod, t)} | {"k", "e"}
NAMES |= {f"{o}({n})" for o in ("d", "delta") for n in ("x", "y", "theta", "phi", "theta_1", "x1", "u", "t")}


@given(NONSENSE)
@settings(max_examples=400, deadline=None)
def test_nonsense_is_refused_or_read(text: str) -> None:
    check_reading(text)


@given(misspelt())
@settings(max_examples=400, deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_misspelt_texts_are_refused_or_read(text: str) -> None:
    check_reading(text)
