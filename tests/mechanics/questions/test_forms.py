"""How values are written."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.core.symbols import prime
from lagrange.mechanics.questions.forms import (
    rate_of,
    settled,
    under_one_root,
    with_factors,
    with_half_angle,
    with_joined_logarithms,
    with_known_signs,
    with_number_apart,
    with_tanh,
    without_roots_below,
    without_roots_in_logarithms,
    without_weaker,
)

g, h, m, x = sp.symbols("g h m x", positive=True)


@pytest.mark.parametrize(
    "e", [sp.sqrt(2) * sp.sqrt(g) * sp.sqrt(h), m * sp.sqrt(g) / sp.sqrt(h), g + sp.sqrt(2) * sp.sqrt(h)]
)
def test_square_roots_under_one_root(e: sp.Expr) -> None:
    written = under_one_root(e)
    assert len([p for p in written.atoms(sp.Pow) if p.exp == sp.S.Half]) <= 1
    values = {g: 1.3, h: 0.7, m: 2.1}
    assert float(written.subs(values)) == pytest.approx(float(e.subs(values)))


def test_logarithms_and_denominators() -> None:
    assert sp.expand(without_roots_in_logarithms(sp.log(sp.sqrt(x))) - sp.log(x) / 2) == 0
    e = h / (sp.sqrt(g + h) - sp.sqrt(g))
    assert sp.simplify(without_roots_below(e) - e) == 0
    assert without_roots_below(g * h) == g * h


def test_the_signs_that_conditions_give() -> None:
    """u log(a/b) + g (b − a)/q is written u log(a/b) − g (a − b)/q where a > b."""
    q, u = sp.symbols("q u", positive=True)
    e = u * sp.log(g / h) + x * (h - g) / q
    written = with_known_signs(e, [SignCondition(g, ">", h)])
    assert sp.expand(written - e) == 0
    assert any((g - h) in term.args for term in written.args)
    assert with_known_signs(e, []) is e


def test_conditions_that_others_imply() -> None:
    a = sp.Symbol("a", positive=True)
    more = SignCondition(m * a + x, ">", m * h + g * a)
    implied = SignCondition(m * a + x, "≠", g * a)  # the left side is more by m h
    other = SignCondition(m * a, "≠", x)
    assert settled((implied, more, other), g) == (more, other)


def test_what_a_value_is_divided_by_is_not_zero() -> None:
    theta = sp.Symbol("theta", real=True)
    [strict] = settled((SignCondition(sp.cos(theta), "≥", sp.S.Zero),), g / (m * sp.cos(theta)))
    assert strict.relation == ">"
    [open_] = settled((SignCondition(sp.cos(theta), "≥", sp.S.Zero),), sp.sqrt(g * sp.cos(theta)))
    assert open_.relation == "≥"


def test_an_angle_by_the_tangent_of_its_half() -> None:
    """A swing that is pushed by F from rest turns at 2 arctan(F/(m g)); F = h here."""
    cosine = m**2 * g**2 / (m**2 * g**2 + h**2) - h**2 / (m**2 * g**2 + h**2)
    assert with_half_angle(sp.acos(cosine)) == 2 * sp.atan(h / (m * g))
    assert float(sp.acos(cosine).subs({g: 2, h: 3, m: 5})) == pytest.approx(
        float((2 * sp.atan(h / m / g)).subs({g: 2, h: 3, m: 5}))
    )
    assert with_half_angle(sp.acos(g / h)) == sp.acos(g / h)


def test_a_number_apart_from_a_quotient() -> None:
    whole = (2 * (h + m) ** 2 * g * x - m**2).expand() / (2 * (h + m) ** 2 * g * x)
    apart = with_number_apart(whole)
    assert sp.S.One in apart.args
    assert sp.simplify(apart - whole) == 0
    assert with_number_apart((h + m) / (h - m)) == (h + m) / (h - m)


def test_a_hyperbolic_tangent() -> None:
    assert with_tanh(m * sp.sinh(g * x) / sp.cosh(g * x)) == m * sp.tanh(g * x)
    assert with_tanh(sp.sinh(g * x) / sp.cosh(h * x)) == sp.sinh(g * x) / sp.cosh(h * x)


def test_values_with_factors() -> None:
    assert with_factors(x * (g * (h**2 + m**2) - g * h**2 - m * x) / h) == -x * m * (x - g * m) / h
    assert str(under_one_root(m / sp.sqrt(g) / sp.sqrt(h + x))) == "m/sqrt(g*(h + x))"


def test_what_stands_in_a_logarithm_is_a_number() -> None:
    e = h * x + g * sp.log(g) - g * sp.log(g + h * x)
    joined = with_joined_logarithms(e)
    assert [f.args[0] for f in joined.atoms(sp.log)] == [(g + h * x) / g]
    numbers = {g: 2, h: 3, x: 5}
    assert float(joined.xreplace(numbers)) == pytest.approx(float(e.xreplace(numbers)))


def test_no_condition_beside_a_stronger_one() -> None:
    strong, weak = SignCondition(g, ">", h), SignCondition(g - h, "≥", sp.S.Zero)
    turned = SignCondition(h, "≤", g)
    assert without_weaker([weak, strong, turned, strong]) == (strong,)
    assert without_weaker([weak]) == (weak,)


def test_the_rate_of_a_coordinate_and_of_a_distance() -> None:
    a, b = sp.symbols("a b", real=True)
    assert rate_of(a) == prime(a)
    assert rate_of(b - a) == prime(b) - prime(a)
