"""Division in the ring of Fourier sums, and quotients written as fractions."""

from __future__ import annotations

import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.algebra.fourier.division import (
    as_fraction,
    by_denominator,
    exact_quotient,
    highest_multiples,
    may_divide,
    over_one_denominator,
    over_wave,
)
from lagrange.algebra.fourier.elements import Element
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.core.symbols import Sign, prime, t
from tests.support.chance import examples

x, y, theta, phi, psi = sp.symbols("x y theta phi psi", real=True)
l, m, M, a, omega = sp.symbols("l m M a omega", positive=True)
sin, cos, tan, sqrt, pi = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi
sigma = Sign("sigma")
ANGLES = [theta, phi, theta - phi, 2 * theta, omega * t, theta / 2]
factors = st.sampled_from(
    [f(w) for f in (sin, cos) for w in ANGLES] + [x, y, m, prime(theta), prime(x, 2), sp.Integer(-3), sp.Rational(1, 2)]
)
monomials = st.lists(factors, max_size=5).map(lambda fs: sp.Mul(*fs))
polynomials = st.lists(monomials, max_size=4).map(lambda ms: sp.Add(*ms))
quick = settings(deadline=None, max_examples=examples(60))


@quick
@given(polynomials, polynomials)
def test_division_undoes_multiplication(e: sp.Expr, f: sp.Expr) -> None:
    ring = FourierRing()
    p, q = ring.from_sympy(e), ring.from_sympy(f)
    if q and len(p * q) * len(q) <= 400:
        assert exact_quotient(p * q, q) == p or not p
    for w in (theta, theta - phi):
        for sine, function in ((True, sin), (False, cos)):
            wave = ring.from_sympy(function(w))
            (frequency,) = (key[1] for key in wave.terms)
            sign = wave.terms[0, frequency][sine]  # sin(theta - phi) may be kept as -sin(phi - theta)
            assert over_wave(p * wave, frequency, sine) == p * sign
            assert may_divide(frequency, p * wave, highest_multiples(p * wave))


def test_what_does_not_divide_has_no_quotient() -> None:
    ring = FourierRing()
    p, q = ring.from_sympy(M**2 - m**2 * cos(theta) ** 2), ring.from_sympy(M - m * cos(theta))
    assert exact_quotient(p, q) == ring.from_sympy(M + m * cos(theta))
    assert exact_quotient(p + 1, q) is None
    (frequency,) = (w for _, w in ring.from_sympy(cos(theta)).terms)
    assert over_wave(ring.from_sympy(1 + cos(theta)), frequency, sine=False) is None
    assert over_wave(ring.from_sympy(x * cos(theta) + y), frequency, sine=False) is None


def test_frequencies_alone_tell_that_most_waves_do_not_divide() -> None:
    ring = FourierRing()
    (one,), (other,) = ([w for _, w in ring.from_sympy(cos(angle)).terms] for angle in (theta, theta - phi))
    for e, frequency in ((1 + cos(theta), one), (x * cos(2 * theta) + y, one), (sin(theta) * cos(phi), other)):
        element = ring.from_sympy(e)
        assert not may_divide(frequency, element, highest_multiples(element))
        assert over_wave(element, frequency, sine=True) is over_wave(element, frequency, sine=False) is None


def test_fractions_are_joined_where_that_is_shorter() -> None:
    ring = FourierRing()
    joined = over_one_denominator(ring.from_sympy(prime(y) + y**2 * prime(y) / (l**2 - y**2)))
    assert joined == ring.from_sympy(l**2 * prime(y) / (l**2 - y**2))
    apart = ring.from_sympy(x + y / (l**2 - y**2))
    assert over_one_denominator(apart) == apart
    sum_of_squares = ring.from_sympy(x + x * tan(theta) ** 2 + y)
    assert over_one_denominator(sum_of_squares) == ring.from_sympy(x / cos(theta) ** 2 + y)


def test_as_fraction_and_by_denominator() -> None:
    ring = FourierRing()
    numerator, denominator = as_fraction(ring.from_sympy(x / y**2 + 1 / m + tan(theta)))
    inverse = Element(ring, {(-denominator, 0): (1, 0)})
    assert numerator == ring.from_sympy(m * x * cos(theta) + y**2 * cos(theta) + m * y**2 * sin(theta))
    assert inverse == ring.from_sympy(1 / (m * y**2 * cos(theta)))
    whole = ring.from_sympy(x / sqrt(l - y) + tan(theta) + y / cos(theta) + 1 / (l - y))
    pieces = by_denominator(whole)
    assert set(pieces) == set(map(ring.from_sympy, (x / sqrt(l - y), (y + sin(theta)) / cos(theta), 1 / (l - y))))


def test_roots_in_denominators_are_rationalized() -> None:
    ring = FourierRing()
    r = ring.from_sympy
    assert r(1 / sqrt(m)) == r(sqrt(m)) / r(m)
    assert r(m ** sp.Rational(-3, 2) * m**2) == r(sqrt(m))
    assert r(sigma * x) * r(sigma) == r(x)
    assert (r(sigma) ** -3) == r(sigma)
