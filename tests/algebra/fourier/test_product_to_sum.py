"""Sums of sines and cosines written as products."""

from __future__ import annotations

from fractions import Fraction
from itertools import permutations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.algebra.fourier.product_to_sum import Atom, Factoring, TrigProduct, gathered
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.core.effort import GivenUpError, allowed
from lagrange.core.symbols import prime, t
from tests.support.chance import examples

x, y, theta, phi, psi = sp.symbols("x y theta phi psi", real=True)
l, m, M, a, omega = sp.symbols("l m M a omega", positive=True)
sin, cos, tan, sqrt, pi = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi
ANGLES = [theta, phi, theta - phi, 2 * theta, omega * t, theta / 2]
factors = st.sampled_from(
    [f(w) for f in (sin, cos) for w in ANGLES] + [x, y, m, prime(theta), prime(x, 2), sp.Integer(-3), sp.Rational(1, 2)]
)
monomials = st.lists(factors, max_size=5).map(lambda fs: sp.Mul(*fs))
polynomials = st.lists(monomials, max_size=4).map(lambda ms: sp.Add(*ms))
quick = settings(deadline=None, max_examples=examples(60))


@quick
@given(polynomials)
def test_sums_of_products_keep_the_value(e: sp.Expr) -> None:
    ring = FourierRing()
    factoring = Factoring(ring)
    for piece in ring.from_sympy(e).by_monomial().values():
        ((monomial, _),) = {(k[0], 0) for k in piece.terms}
        bare = piece.over_monomial(monomial)
        back = ring.zero
        for p in factoring.products(bare):
            product = ring.number(p.number)
            for atom, exponent in p.powers:
                product = product * ring.circle(atom.frequency, atom.sine) ** exponent
            back = back + product
        assert back == bare


def test_products_of_equal_powers_are_added() -> None:
    atom = Atom(1, sine=True)
    one, two, none = (TrigProduct(Fraction(n), powers) for n, powers in ((1, ((atom, 2),)), (2, ((atom, 2),)), (3, ())))
    assert gathered((one, none, two)) == (TrigProduct(Fraction(3), ((atom, 2),)), none)
    assert gathered((none, TrigProduct(Fraction(-3)))) == ()


def test_signs_of_differences_are_those_of_sympy() -> None:
    ring = FourierRing()
    symbols = [sp.Symbol(name, real=True) for name in ("theta1", "theta2", "theta10", "alpha", "B", "x", "varphi")]
    for u, v in permutations(symbols, 2):
        for p, q in ((1, -1), (2, -3), (-1, 2), (sp.Rational(1, 2), -1)):
            angle = p * u + q * v
            [(_, frequency)] = ring.from_sympy(cos(angle)).terms
            sign, written = ring.factoring.angle(frequency)
            assert (sign == -1) == (ring.angle_expression(frequency).could_extract_minus_sign())
            assert written == sign * ring.angle_expression(frequency)


def test_the_search_for_factors_is_work() -> None:
    """Trying the half sums of all frequencies grows with the third power of the terms, without a sum of SymPy's."""
    ring = FourierRing()
    angles = sp.symbols("theta1:6", real=True)
    many = ring.from_sympy(sp.Add(*(cos(3 * p + (k + 2) * q) for k, (p, q) in enumerate(permutations(angles, 2)))))
    with pytest.raises(GivenUpError), allowed(1_000):
        Factoring(ring).products(many)


def test_a_long_sum_is_divided_by_what_all_its_terms_have_in_common() -> None:
    """300 waves have 180,000 sums and differences of their frequencies: naming these took half a minute."""
    ring = FourierRing()
    factoring = Factoring(ring)
    e = ring.from_sympy(sp.Add(*(sin((n * n + 1) * theta) for n in range(300))))
    with allowed(8_000):
        assert factoring._halves(e) == []
        assert len(factoring.products(e)) > 250
    angles = sp.symbols("theta1:8", real=True)
    product = ring.from_sympy(sp.Mul(*map(sin, angles[:3]), *map(cos, angles[3:])))
    assert len(product.terms) == 64
    [found] = factoring.products(product)
    assert found.number == 1
    assert [exponent for _, exponent in found.powers] == [1] * 7
