"""Products of powers, and what divides an equation."""

from __future__ import annotations

from fractions import Fraction
from itertools import permutations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.algebra.fourier.terms import PowerProduct, factored_sum
from lagrange.algebra.fourier.textbook_form import CommonFactor, common_factor, normalised, textbook_form
from lagrange.core.symbols import Sign, prime, t
from tests.support.chance import examples

x, y, r, s, x1, x2, z = sp.symbols("x y r s x1 x2 z", real=True)
theta, phi, psi, theta1, theta2, phi1, phi2 = sp.symbols("theta phi psi theta1 theta2 phi1 phi2", real=True)
alpha = sp.Symbol("alpha", real=True)
m, m1, m2, M, l, l0, l1, l2, g, a, b, k, k1, k2, R, omega, mu = sp.symbols(
    "m m1 m2 M l l0 l1 l2 g a b k k1 k2 R omega mu", positive=True
)
sigma = Sign("sigma")
sin, cos, tan, sqrt = sp.sin, sp.cos, sp.tan, sp.sqrt


def dot(q: sp.Symbol) -> sp.Symbol:
    return prime(q)


def ddot(q: sp.Symbol) -> sp.Symbol:
    return prime(q, 2)


X = ddot(x)
ANGLES = [theta, phi, theta - phi, 2 * theta, omega * t, psi / 2]
atoms = [f(w) for f in (sin, cos) for w in ANGLES] + [x, y, m, l, dot(theta), X, sp.Integer(-2), sp.Rational(1, 3)]
quick = settings(deadline=None, max_examples=examples(80))


def sums(factors: list[sp.Expr]) -> st.SearchStrategy[sp.Expr]:
    products = st.lists(st.sampled_from(factors), max_size=5).map(lambda fs: sp.Mul(*fs))
    brackets = st.lists(products, max_size=3).map(lambda ps: sp.Add(*ps))
    return st.builds(lambda p, q, s: p * q + s, brackets, brackets, products)


def value(expression: sp.Expr) -> sp.Expr:
    symbols = sorted(expression.free_symbols, key=str)
    point = {s: sp.Rational(sum(map(ord, s.name)) % 37 + 5, 17 + len(s.name)) for s in symbols}
    return sp.N(expression.xreplace(point), 50)


def same(one: sp.Expr, two: sp.Expr) -> bool:
    return abs(value(one - two)) <= sp.Float("1e-40") * (1 + abs(value(one)))


@quick
@given(sums(atoms), st.sampled_from(atoms), st.sampled_from(atoms))
def test_a_common_factor_divides(expression: sp.Expr, one: sp.Expr, two: sp.Expr) -> None:
    form = textbook_form(expression * one * two)
    factor = common_factor(form)
    quotient = factor.divide(form)
    assert same(quotient * factor.expression, form)
    assert form == 0 or common_factor(quotient) == CommonFactor(sp.S.One, ())


def test_a_sum_is_factored_whatever_the_order_of_its_terms() -> None:
    product = sp.expand((x + y - m * cos(theta)) * (a + b * cos(phi)))
    terms = [PowerProduct(Fraction(int(c)), dict.fromkeys(rest.args, sp.S.One)) for c, rest in map(split, product.args)]
    for order in permutations(terms):
        factored = factored_sum(list(order))
        assert factored is not None
        assert len(factored.factors) == 2
        assert sp.expand(factored.to_sympy()) == product


def split(product: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    number, rest = product.as_coeff_Mul()
    return number, rest


FACTORS = [
    (
        -m * r**2 * sin(theta) ** 2 * ddot(phi)
        - 2 * m * r * dot(r) * dot(phi) * sin(theta) ** 2
        - 2 * m * r**2 * dot(theta) * dot(phi) * sin(theta) * cos(theta),
        (m, r * sin(theta)),
        (r, sin(theta)),
        r * ddot(phi) * sin(theta) + 2 * dot(r) * dot(phi) * sin(theta) + 2 * r * dot(theta) * dot(phi) * cos(theta),
    ),
    (
        m * l**2 * ddot(theta) + m * g * l * sin(theta),
        (m * l, 1),
        (),
        l * ddot(theta) + g * sin(theta),
    ),
    (
        (m1 + m2) * l * ddot(theta) + (m1 + m2) * g * sin(theta),
        (m1 + m2, 1),
        (),
        l * ddot(theta) + g * sin(theta),
    ),
    (
        m * (l + x) ** 2 * ddot(theta) + m * (l + x) * g * sin(theta),
        (m, l + x),
        (l + x,),
        (l + x) * ddot(theta) + g * sin(theta),
    ),
    (m * ddot(y) - m * y / x * X - m * g, (m, 1 / x), (), -x * ddot(y) + y * X + g * x),
    (m * ddot(r) + k / r**2, (1, 1), (), m * ddot(r) + k / r**2),
    (4 * X + 6 * x, (2, 1), (), 2 * X + 3 * x),
    (X / 2 + sp.Rational(3, 2) * x, (sp.Rational(1, 2), 1), (), X + 3 * x),
    (dot(x) * X + dot(x) * x, (1, 1), (), dot(x) * X + dot(x) * x),
    (sigma * x * X + sigma * g * x**2, (sigma, x), (x,), X + g * x),
    (sp.exp(2 * x) * X + sp.exp(x) * g, (sp.exp(x), 1), (), sp.exp(x) * X + g),
    (X * sin(alpha) + g * tan(alpha), (1, sin(alpha)), (sin(alpha),), X + g / cos(alpha)),
    (sp.S.Zero, (1, 1), (), sp.S.Zero),
]


@pytest.mark.parametrize(("expression", "factor", "nonzero", "quotient"), FACTORS, ids=[str(f[0]) for f in FACTORS])
def test_common_factor(
    expression: sp.Expr, factor: tuple[sp.Expr, sp.Expr], nonzero: tuple[sp.Expr, ...], quotient: sp.Expr
) -> None:
    found = common_factor(textbook_form(expression))
    assert (found.parameters, found.state) == factor
    assert set(found.nonzero) == set(nonzero)
    assert found.expression == sp.Mul(*factor)
    assert normalised(found.divide(textbook_form(expression))) == quotient


def test_a_number_times_a_sum_cancels() -> None:
    equation = (m1 + m2) * X * 2 + (m1 + m2) * x * 4
    factor = common_factor(equation)
    assert factor.number == 2
    assert factor.powers == ((m1 + m2, 1),)
    assert str(factor.expression) == str(factor.parameters) == "2*(m1 + m2)"
    assert factor.divide(equation) == X + 2 * x


def test_numerator_and_denominator_of_a_factor() -> None:
    factor = common_factor(m * X / (2 * x) + m * g * y / (2 * x))
    assert (factor.numerator.expression, factor.denominator.expression) == (m, 2 * x)
    assert factor.only(lambda f: f == x).expression == 1 / (2 * x)
    assert factor.denominator.multiply(factor.numerator.divide(m * X / (2 * x))) == X


def test_normalised() -> None:
    assert normalised(-X + g) == X - g
    assert normalised(y * X - x * ddot(y), leading=(ddot(y),)) == x * ddot(y) - y * X
    assert normalised(y * X - x * ddot(y), leading=(X,)) == y * X - x * ddot(y)
    assert normalised(-X - ddot(y) + ddot(theta)) == X + ddot(y) - ddot(theta)
    assert normalised(-k * x - m * g + a) == k * x + m * g - a
    assert normalised(sp.S.Zero) == 0
