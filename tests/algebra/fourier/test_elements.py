"""Elements of the ring: zero, parts, what they contain, when they are equal."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp

from lagrange.algebra.fourier.elements import Element
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.core.symbols import Unspecified, prime, t

x, y, theta, phi, psi = sp.symbols("x y theta phi psi", real=True)
l, m, M, a, omega = sp.symbols("l m M a omega", positive=True)
sin, cos, tan, sqrt, pi = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi
F = Unspecified.of("F", ("X", "Y"), x - omega * t, y)


def test_a_polynomial_zero_is_empty() -> None:
    ring = FourierRing()
    assert not ring.from_sympy(sin(theta) ** 2 + cos(theta) ** 2 - 1).terms
    assert ring.from_sympy(sin(theta) ** 2 + cos(theta) ** 2) == ring.one


def test_numerator_drops_only_denominators() -> None:
    ring = FourierRing()
    r = ring.from_sympy
    assert ring.numerator(r(prime(y, 2) + y**2 * prime(y, 2) / (l**2 - y**2))) == r(l**2 * prime(y, 2))
    assert ring.numerator(r(x * cos(theta) + sin(theta) / cos(theta))) == r(x * cos(theta) ** 2 + sin(theta))
    assert ring.numerator(r(x * cos(theta))) == r(x * cos(theta))
    assert ring.numerator(r(1 / x)) == r(1 / x)
    cube = r(sp.expand((l**2 - y**2) ** 3))
    assert ring.numerator(cube * r(1 / (l**2 - y**2))) == r((l**2 - y**2) ** 2)
    assert ring.numerator(cube * r(1 / (l**2 - y**2) ** 4)) == ring.one


def test_collect_and_linear() -> None:
    ring = FourierRing()
    e = ring.from_sympy(x * prime(x, 2) * sin(theta) - y * prime(y, 2) + m * prime(x) ** 2)
    (c1, c2), rest = ring.linear(e, (prime(x, 2), prime(y, 2)))
    assert (c1, c2, rest) == tuple(map(ring.from_sympy, (x * sin(theta), -y, m * prime(x) ** 2)))
    assert ring.collect(e, (prime(x), psi)) == {
        (0, 0): ring.from_sympy(x * prime(x, 2) * sin(theta) - y * prime(y, 2)),
        (2, 0): ring.from_sympy(m),
    }
    with pytest.raises(ValueError, match="not linear in x'"):
        ring.linear(e, (prime(x),))
    with pytest.raises(ValueError, match="not linear in x'"):
        ring.linear(ring.from_sympy(1 / prime(x)), (prime(x), y))
    with pytest.raises(ValueError, match="not polynomial in theta"):
        ring.collect(e, (theta,))
    with pytest.raises(ValueError, match="not polynomial in y"):
        ring.collect(ring.from_sympy(sqrt(l**2 - y**2)), (x, y))


def test_free_symbols() -> None:
    ring = FourierRing()
    e = ring.from_sympy(m * cos(omega * t) + sqrt(l - x) + F - F)
    assert ring.free_symbols(e) == {m, omega, t, l, x}


def test_dot_is_the_sum_of_products() -> None:
    ring = FourierRing()
    a1, a2, b1, b2 = map(ring.from_sympy, (x * sin(theta), y, sin(theta), sp.Integer(0)))
    assert ring.dot((a1, a2), (b1, b2)) == ring.from_sympy(x * sin(theta) ** 2)
    with pytest.raises(ValueError, match="zip"):
        ring.dot((a1, a2), (b1,))


def test_monomials_are_inverted_and_sums_become_denominators() -> None:
    ring = FourierRing()
    r = ring.from_sympy
    assert r(2 * x / y) ** -2 == r(y**2 / x**2) / 4
    assert r(x + y) ** -1 * r(x + y) != ring.one  # not reduced by itself,
    assert ring.is_zero(r(x + y) ** -1 * r(x + y) - 1)  # but recognized
    assert (r(x) + 1) / 2 - Fraction(1, 2) == r(x / 2)
    assert 3 - r(x) == -(r(x) - 3)
    with pytest.raises(ZeroDivisionError):
        ring.zero**-1


def test_content() -> None:
    ring = FourierRing()
    e = ring.from_sympy(6 * m * l**2 * x - 4 * m * l * cos(theta) / y)
    number, monomial = e.content()
    assert number == 2
    assert e.over_monomial(monomial) / number == ring.from_sympy(3 * l * x * y - 2 * cos(theta))


def test_elements_of_two_rings_are_not_equal() -> None:
    one, two = FourierRing().from_sympy(x), FourierRing().from_sympy(x)
    assert one != two
    assert one != x
    assert hash(one) == hash(one + 0)
    with pytest.raises(ValueError, match="another ring"):
        FourierRing().from_sympy(one)


def test_elements_say_what_they_are() -> None:
    assert repr(FourierRing().from_sympy(x * cos(theta))) == "Element(x*cos(theta))"


def test_waves_are_whole_or_not() -> None:
    ring = FourierRing()
    assert isinstance(ring.from_sympy(cos(theta / 2)), Element)
    ((_, half),) = ring.from_sympy(cos(theta / 2)).terms
    assert not ring.is_whole(half)
    assert ring.half(2 * half) is None
    assert ring.half(2 * half, fine=True) == half
