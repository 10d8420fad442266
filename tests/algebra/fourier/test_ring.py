"""The ring of Fourier sums: identities, laws, derivatives, division. Second routes: numbers, SymPy's calculus."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.algebra.fourier.ring import FourierRing
from lagrange.core.symbols import Sign, Slots, Unspecified, prime, t
from tests.support.chance import examples

x, y, theta, phi, psi = sp.symbols("x y theta phi psi", real=True)
l, m, M, a, omega = sp.symbols("l m M a omega", positive=True)
sin, cos, tan, sqrt, pi = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi
sigma = Sign("sigma")
slots = Slots((x, y, theta, phi), (psi,))
F = Unspecified.of("F", ("X", "Y"), x - omega * t, y)

ZERO = [
    sin(theta) ** 2 + cos(theta) ** 2 - 1,
    cos(theta - phi) - cos(theta) * cos(phi) - sin(theta) * sin(phi),
    sin(theta / 2) ** 2 - (1 - cos(theta)) / 2,
    cos(theta / 3) * 4 * cos(theta / 3) ** 2 - 3 * cos(theta / 3) - cos(theta),
    cos(theta / 11) ** 2 - (1 + cos(2 * theta / 11)) / 2,
    sin(omega * t + phi) - sin(omega * t) * cos(phi) - cos(omega * t) * sin(phi),
    sin(a * (x + y)) - sin(a * x) * cos(a * y) - cos(a * x) * sin(a * y),
    cos(theta + pi / 3) - cos(theta) / 2 + sqrt(3) / 2 * sin(theta),
    cos(theta + pi / 7) - cos(theta) * cos(pi / 7) + sin(theta) * sin(pi / 7),
    4 * cos(pi / 5) - 1 - sqrt(5),
    sin(theta + pi / 2) - cos(theta),
    tan(theta) * cos(theta) - sin(theta),
    sp.cot(theta) * tan(theta) - 1,
    sp.sec(theta) ** 2 - 1 - tan(theta) ** 2,
    1 / sin(2 * theta) - sp.csc(theta) * sp.sec(theta) / 2,
    sqrt(l**2 - y**2) ** 2 - l**2 + y**2,
    sqrt(l**2 - y**2) ** 3 / (l**2 - y**2) - sqrt(l**2 - y**2),
    sqrt(4 * l**2 - 4 * y**2) - 2 * sqrt(l**2 - y**2),
    sqrt(m * l**2 - m * y**2) - sqrt(m) * sqrt(l**2 - y**2),
    1 / (l**2 - y**2) + 1 / (y**2 - l**2),
    y**2 / (l**2 - y**2) + 1 - l**2 / (l**2 - y**2),
    1 / (m + m * sin(theta) ** 2) * (1 + sin(theta) ** 2) - 1 / m,
    sqrt(6) - sqrt(2) * sqrt(3),
    sqrt(sp.Rational(2, 3)) - sqrt(6) / 3,
    sqrt(M / m) * sqrt(m / M) - 1,
    sigma * sigma - 1,
    1 / sigma - sigma,
    sp.cosh(x) ** 2 - sp.sinh(x) ** 2 - 1,
    sp.tanh(x) * sp.cosh(x) - sp.sinh(x),
    sp.exp(x) * sp.exp(-2 * x) * sp.exp(x) - 1,
    sp.exp(x + y) - sp.exp(x) * sp.exp(y),
    (x + y) ** 5 - (x + y) ** 2 * (x**3 + 3 * x**2 * y + 3 * x * y**2 + y**3),
]

NOT_ZERO = [
    sin(theta) ** 2 - cos(theta) ** 2,
    cos(theta - phi) - cos(theta + phi),
    cos(theta + pi / 3) - cos(theta - pi / 3),
    sqrt(l**2 - y**2) - l,
    1 / (l**2 - y**2) - 1 / (l**2 + y**2),
    sigma - 1,
    tan(theta) - sin(theta),
    sp.sinh(x) - sp.cosh(x),
    sqrt(2) - 1,
    cos(pi / 7) - cos(2 * pi / 7),
    F - F.partial(0),
    x ** (10**6) - x ** (10**6 + 1),
]


@pytest.mark.parametrize("expression", ZERO, ids=str)
def test_identities_are_zero(expression: sp.Expr) -> None:
    ring = FourierRing()
    assert ring.is_zero(ring.from_sympy(expression))


@pytest.mark.parametrize("expression", NOT_ZERO, ids=str)
def test_what_is_not_zero_is_not(expression: sp.Expr) -> None:
    ring = FourierRing()
    assert not ring.is_zero(ring.from_sympy(expression))


FUNCTIONS = [
    x**2 * sin(theta) * cos(phi - theta),
    sqrt(l**2 - y**2) ** 3,
    y / sqrt(l**2 - y**2),
    1 / (M + m * sin(theta) ** 2),
    tan(theta) * x,
    sp.exp(-a * x) * cos(omega * t),
    sp.atan(y / l) * x,
    sp.cosh(x / a) * sp.sinh(x),
    sqrt(x**2 + y**2) + sqrt(a * x**2),
    (x**2 + y**2) ** sp.Rational(1, 3),
    F * prime(x) + x * prime(theta, 2),
    cos(sp.exp(x)) + sp.log(l + y**2),
    cos(theta / 2 + omega * t**2) * psi,
    x**-2 * prime(psi),
    sp.asin(y / (2 * l)) * sigma,
]


def value(expression: sp.Expr, shift: int = 0) -> sp.Expr:
    """The value at a fixed admissible point, to 50 digits; F is taken to be X² sin Y."""
    X, Y = sp.Dummy(), sp.Dummy()

    def concrete(f: Unspecified) -> sp.Expr:
        derivative = (X**2 * sin(Y)).diff(X, f.orders[0]).diff(Y, f.orders[1]) if any(f.orders) else X**2 * sin(Y)
        return derivative.subs(dict(zip((X, Y), f.arguments, strict=True)))

    expression = expression.replace(lambda e: isinstance(e, Unspecified), concrete)
    symbols = sorted(expression.free_symbols, key=str)
    names = sorted(s.name for s in symbols)
    numbers = {s: sp.Rational(7 + 3 * names.index(s.name) + shift, 19) for s in symbols}
    numbers |= {sigma: sp.S.NegativeOne, l: sp.Rational(77 + shift, 10)}
    return sp.N(expression.xreplace(numbers), 50)


def close(one: sp.Expr, two: sp.Expr) -> bool:
    return abs(value(one - two)) < sp.Float("1e-40") and abs(value(one - two, 5)) < sp.Float("1e-40")


@pytest.mark.parametrize("expression", FUNCTIONS, ids=str)
def test_reading_and_writing_keeps_the_value(expression: sp.Expr) -> None:
    assert close(FourierRing().from_sympy(expression).to_sympy(), expression)


@pytest.mark.parametrize("expression", FUNCTIONS, ids=str)
def test_time_derivative_is_sympys(expression: sp.Expr) -> None:
    ring = FourierRing()
    derivative = ring.time_derivative(slots)(ring.from_sympy(expression))
    assert close(derivative.to_sympy(), slots.time_derivative(expression))


@pytest.mark.parametrize("expression", FUNCTIONS, ids=str)
def test_frozen_derivative_is_sympys(expression: sp.Expr) -> None:
    ring = FourierRing()
    derivative = ring.frozen_derivative(slots)(ring.from_sympy(expression))
    assert close(derivative.to_sympy(), slots.frozen_derivative(expression))


@pytest.mark.parametrize("expression", FUNCTIONS, ids=str)
@pytest.mark.parametrize("symbol", [x, y, theta, l, prime(x)], ids=str)
def test_partial_derivative_is_sympys(expression: sp.Expr, symbol: sp.Symbol) -> None:
    ring = FourierRing()
    derivative = ring.partial(symbol)(ring.from_sympy(expression))
    assert close(derivative.to_sympy(), expression.diff(symbol))


ANGLES = [theta, phi, theta - phi, 2 * theta, omega * t, theta / 2]
factors = st.sampled_from(
    [f(w) for f in (sin, cos) for w in ANGLES] + [x, y, m, prime(theta), prime(x, 2), sp.Integer(-3), sp.Rational(1, 2)]
)
monomials = st.lists(factors, max_size=5).map(lambda fs: sp.Mul(*fs))
polynomials = st.lists(monomials, max_size=4).map(lambda ms: sp.Add(*ms))
quick = settings(deadline=None, max_examples=examples(60))


@quick
@given(polynomials, polynomials, polynomials)
def test_ring_laws(e: sp.Expr, f: sp.Expr, g: sp.Expr) -> None:
    ring = FourierRing()
    p, q, r = map(ring.from_sympy, (e, f, g))
    assert (p * q) * r == p * (q * r)
    assert p * q == q * p
    assert p * (q + r) == p * q + p * r
    assert (p + q) - q == p
    assert (p + q) ** 3 == p**3 + 3 * p**2 * q + 3 * p * q**2 + q**3


@quick
@given(polynomials, polynomials)
def test_reading_is_a_homomorphism(e: sp.Expr, f: sp.Expr) -> None:
    ring = FourierRing()
    assert ring.from_sympy(sp.expand(e * f)) == ring.from_sympy(e) * ring.from_sympy(f)
    assert close((ring.from_sympy(e) * ring.from_sympy(f)).to_sympy(), e * f)


@quick
@given(polynomials, polynomials)
def test_derivations_obey_the_product_rule(e: sp.Expr, f: sp.Expr) -> None:
    ring = FourierRing()
    p, q = ring.from_sympy(e), ring.from_sympy(f)
    for d in (ring.time_derivative(slots), ring.partial(theta), ring.partial(omega)):
        assert d(p * q) == d(p) * q + p * d(q)


@quick
@given(polynomials)
def test_derivatives_commute_and_cancel_dots(e: sp.Expr) -> None:
    ring = FourierRing()
    p = ring.from_sympy(e.xreplace({prime(theta): y, prime(x, 2): y}))
    dt, d_theta = ring.time_derivative(slots), ring.partial(theta)
    assert ring.partial(x)(d_theta(p)) == d_theta(ring.partial(x)(p))
    assert ring.partial(prime(theta))(dt(p)) == d_theta(p)
    assert dt(d_theta(p)) == d_theta(dt(p))


@quick
@given(polynomials)
def test_derivative_of_an_expression(e: sp.Expr) -> None:
    ring = FourierRing()
    assert ring.time_derivative(slots)(ring.from_sympy(e)) == ring.from_sympy(slots.time_derivative(e))


def test_high_powers_are_left_alone() -> None:
    ring = FourierRing()
    for power in (
        cos(theta) ** 1000,
        (x + y) ** 1000,
        sqrt(x + y) ** 1001,
        (1 + x + y + l + m + M) ** 30,
        x ** (10**7),
        cos(theta * 10**6),
    ):
        assert len(ring.from_sympy(power)) == 1
    assert len(ring.from_sympy(cos(theta) ** 60)) == 31


numbers = st.integers(-1000, 1000)


def test_a_number_under_a_root_is_divided_by_small_primes_only() -> None:
    """A product of two primes of thirty digits is not factored, which may take forever; its root is its root."""
    ring = FourierRing()
    number = sp.Integer(31415926535897932384626433897) * 27182818284590452353602874829
    root = ring.from_sympy(sp.Pow(6 * number, sp.S.Half))
    assert root * root == ring.number(int(6 * number))
    assert root == ring.from_sympy(sqrt(2) * sqrt(3) * sp.Pow(number, sp.S.Half))
