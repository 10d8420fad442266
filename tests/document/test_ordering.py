"""The order in which the factors of a product and the terms of a sum are written."""

import pytest
import sympy as sp

from lagrange.core.symbols import (
    DotProduct,
    VectorSymbol,
    prime,
    t,
)
from lagrange.document.math_writer import Notation, latex, text, unicode
from lagrange.document.names import SymbolKind
from tests.document.test_math_writer import FACTORS, TERMS


def symbols(names):
    return sp.symbols(names, real=True)


x, y, z, r, th, ph = symbols("x y z r theta phi")
x1, x2, th1, th2 = symbols("x_1 x_2 theta_1 theta_2")
m, M, m1, m2, l, l1, l2, g, k, a, b, c = symbols("m M m_1 m_2 l l_1 l_2 g k a b c")
omega, alpha, gamma, mu, F, P = symbols("omega alpha gamma mu F P")
u, s = symbols("u s")
sin, cos, tan, sqrt = sp.sin, sp.cos, sp.tan, sp.sqrt
N = Notation(coordinates=(x, y, z, r, th, ph, x1, x2, th1, th2), prescribed=(s,), forces=(P,))


def D(symbol, order=1):
    return prime(symbol, order)


def mul(*factors):
    return sp.Mul(*factors, evaluate=False)


def add(*terms):
    return sp.Add(*terms, evaluate=False)


@pytest.mark.parametrize(("expression", "terminal"), FACTORS + TERMS, ids=[w for _, w in FACTORS + TERMS])
def test_order_of_writing(expression, terminal):
    assert unicode(expression, N) == terminal


def test_ell_is_one_letter_among_the_latin_ones():
    ell = symbols("ell")
    assert unicode(m * ell**2 * omega * D(symbols("ell_1")), N) == "m ℓ² ω ℓ̇₁"
    assert latex(alpha * ell * m, N) == r"m \ell \alpha"
    assert text(alpha * ell * m, N) == "m*ell*alpha"


def test_an_unknown_frequency_stands_before_time_and_first_among_terms():
    notation = Notation(coordinates=(x,), frequencies=(omega,))
    assert unicode(a * cos(omega * t), notation) == "a cos ωt"
    assert unicode(x * sin(omega * t + alpha), notation) == "x sin(ω t + α)"
    assert unicode(m * (a + b) * omega**2 - c, notation) == "m (a + b) ω² − c"


def test_matrices_keep_their_place_whatever_the_letters_mean():
    notation = Notation(coordinates=(x,), speeds=symbols("q u"), forces=symbols("M A"))
    for letter in "MA":
        assert unicode(mul(VectorSymbol(letter), VectorSymbol("q''")), notation) == f"{letter} q̈"


def test_order_does_not_depend_on_the_order_of_construction():
    terms = [m * D(x, 2), c * D(x), k * x, -F, a * cos(omega * t)]
    forward, backward = add(*terms), add(*reversed(terms))
    assert unicode(forward, N) == unicode(backward, N) == "m ẍ + c ẋ + k x − F + a cos ωt"


def test_the_second_particle_stands_before_the_tenth():
    work = sp.Add(*(DotProduct(VectorSymbol(f"F_P{n}"), VectorSymbol(f"r_P{n}")) for n in (10, 2, 1)))
    assert unicode(work) == "F_P₁·r_P₁ + F_P₂·r_P₂ + F_P₁₀·r_P₁₀"


def test_quasi_velocities_count_as_velocities():
    v = symbols("v")
    notation = Notation(coordinates=(x,), speeds=(v,))
    assert notation.kind(v) is SymbolKind.VELOCITY
    assert notation.kind(D(v)) is SymbolKind.ACCELERATION
    assert unicode(k * x + c * v + m * D(v), notation) == "m v̇ + c v + k x"


@pytest.mark.parametrize(
    ("terms", "written"),
    [((a, -mu * c, b), "a + b − μ c"), ((-m * g, P, a), "a − m g + P"), ((-a, 2 * P, P * b), "P b + 2P − a"),
     ((-x, l, y), "y − x + l")],
)  # fmt: skip
def test_what_has_a_plus_is_together(terms, written):
    """Constants, and forces, where the sum would begin with a minus otherwise."""
    assert unicode(sp.Add(*terms), N).replace("b P", "P b") == written
