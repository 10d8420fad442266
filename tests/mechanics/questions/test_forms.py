"""How values are written."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.core.symbols import prime
from lagrange.mechanics.questions.forms import (
    joined_conditions,
    rate_of,
    settled,
    shown,
    under_one_root,
    with_common_number,
    with_exponentials_under_roots,
    with_factors,
    with_half_angle,
    with_joined_logarithms,
    with_known_signs,
    with_number_apart,
    with_root_as_letter,
    with_tanh,
    without_roots_below,
    without_roots_in_logarithms,
    without_waves_of_logarithms,
    without_weaker,
)
from lagrange.mechanics.questions.results import AnswerBranch

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


def test_hyperbolic_functions_of_logarithms() -> None:
    grown = sp.log(x + sp.sqrt(x**2 - 1))
    for f in (sp.cosh, sp.sinh, sp.tanh):
        for number in (1, -1, sp.S.Half):
            written = without_waves_of_logarithms(f(number * grown))
            assert not written.has(sp.log, sp.cosh, sp.sinh, sp.tanh)
            assert float((written - f(number * grown)).subs(x, 1.7)) == pytest.approx(0, abs=1e-12)
    assert without_waves_of_logarithms(sp.tanh(grown)) == sp.sqrt(x**2 - 1) / x
    assert without_waves_of_logarithms(sp.tanh(x)) == sp.tanh(x)


def test_exponentials_go_under_a_root() -> None:
    e = m * sp.sqrt(sp.exp(2 * x) - 1) * sp.exp(-x)
    assert with_exponentials_under_roots(e) == m * sp.sqrt(1 - sp.exp(-2 * x))


@pytest.mark.parametrize(("relation", "other"), [(">", "<"), ("≥", "≤")])
def test_conditions_on_exponentials_are_about_their_exponents(relation: str, other: str) -> None:
    y = sp.Symbol("y", real=True)
    positive = SignCondition(y, relation, sp.S.Zero)
    e = sp.exp(m * y)
    assert joined_conditions([SignCondition(e, relation, sp.S.One)]) == (positive,)
    assert joined_conditions([SignCondition(sp.S.One, other, e)]) == (positive,)
    assert joined_conditions([SignCondition(e, other, sp.S.One)]) != (positive,)


def test_fourth_roots_of_numbers_go_under_the_root() -> None:
    e = sp.root(3, 4) * sp.sqrt(g) / sp.sqrt(h)
    written = under_one_root(e)
    assert (written.base, written.exp) == (sp.sqrt(3) * g / h, sp.S.Half)


def test_terms_beside_a_root_cancel() -> None:
    root = sp.sqrt(g**2 - h)
    e = (2 * x * (m + g) - 2 * m * x - 2 * g * x + root) / (m + g)
    assert with_factors(e) == root / (m + g)


def test_a_strict_condition_has_the_shorter_sides() -> None:
    """l² + b² cos² φ ≥ b² and b² sin² φ ≠ l² are l² > b² sin² φ."""
    phi = sp.Symbol("phi", real=True)
    weak = SignCondition(h**2 + g**2 * sp.cos(phi) ** 2, "≥", g**2)
    different = SignCondition(g**2 * sp.sin(phi) ** 2, "≠", h**2)
    expected = (SignCondition(h**2, ">", g**2 * sp.sin(phi) ** 2),)
    assert joined_conditions([weak, different]) == expected
    assert joined_conditions([different, weak]) == expected
    assert len(joined_conditions([weak, SignCondition(g**2, "≠", m**2)])) == 2


def test_a_number_that_all_terms_share_stands_before_them() -> None:
    e = sp.Rational(27, 10) * g - sp.Rational(27, 10) * h
    written = with_common_number(e)
    assert written.args == (sp.Rational(27, 10), g - h)
    assert sp.expand(written) == e
    assert with_common_number(g - 2 * h) == g - 2 * h
    assert with_common_number(2 - 2 * h) == 2 - 2 * h
    assert shown(AnswerBranch(x, e, ())).rhs == written


def test_a_sum_that_is_the_square_of_a_root_beside_it_is_divided_by_it() -> None:
    """The greatest speed in a car that speeds up: θ'² = 2 (√(a² + g²) − g)/l."""
    a, l = sp.symbols("a l", positive=True)
    w = sp.sqrt(a**2 + g**2)
    long = sp.sqrt(2) * sp.sqrt((a**2 + g**2 - g * w) / l) / sp.sqrt(w)
    short = with_root_as_letter(long)
    assert short == sp.sqrt(2) * sp.sqrt(w - g) / sp.sqrt(l)
    assert with_root_as_letter(a * w + g) == a * w + g
