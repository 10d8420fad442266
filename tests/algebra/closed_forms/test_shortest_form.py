"""The shortest of a few forms of a value."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import (
    by_stated_root,
    shortest_form,
    with_differences_of_squares,
    with_whole_contents,
    without_leading_minus,
)
from lagrange.core.symbols import Bounded

alpha = sp.Symbol("alpha", real=True)
a, b, c = sp.symbols("a b c", positive=True)
sin, cos, tan = sp.sin, sp.cos, sp.tan


@pytest.mark.parametrize(
    ("long", "short"),
    [
        (cos(alpha) / sin(alpha), 1 / tan(alpha)),
        (sin(alpha) ** 2 / cos(alpha), sin(alpha) * tan(alpha)),
        (a * sin(alpha) ** 2 + a * cos(alpha) ** 2, a),
        (sp.sqrt(sin(alpha) ** 2 + cos(alpha) ** 2 + b), sp.sqrt(1 + b)),
        (a * b, a * b),
        ((a**2 + b**2) * cos(alpha) / (b * c), (a**2 + b**2) * cos(alpha) / (b * c)),  # and not (a²/b + b) cos α/c
        (b * (1 - a / c), b * (1 - a / c)),
        (b / (a * (a + b - a * cos(alpha) ** 2)), b / (a * (b + a * sin(alpha) ** 2))),
    ],
)
def test_the_form_is_shorter_and_has_the_same_value(long: sp.Expr, short: sp.Expr) -> None:
    found = shortest_form(long)
    assert found == short
    values = {alpha: 0.7, a: 1.3, b: 0.4, c: 1.9}
    assert float(found.subs(values)) == pytest.approx(float(long.subs(values)))


# -- Signs before and in products: the value stays, and no minus sign is left that a sum can take ----------------------


a, b, c = sp.symbols("a b c", positive=True)


@pytest.mark.parametrize("e", [-2 * a / (a * b - 1), -c * (a * b - 1), -(a - b) / c, -a / (b - c) ** 3])
def test_a_sum_takes_the_sign(e: sp.Expr) -> None:
    written = without_leading_minus(e)
    assert sp.simplify(written - e) == 0
    assert all(f != -1 for f in written.args)


@pytest.mark.parametrize("e", [-a * b, -a / (b + c), a / (b - c), -a / (b - c) ** 2])
def test_what_no_sum_can_take_stays(e: sp.Expr) -> None:
    assert without_leading_minus(e) == e


def test_common_numbers_stand_before_a_product() -> None:
    """4 a (1 − M/m) for 2 a (2 − 2 M/m), and 2 b/(3 + c) for 6 b·2/(18 + 6 c)."""
    assert str(with_whole_contents(2 * a * (2 - 2 * b / c))) == "4*a*(-b/c + 1)"
    assert with_whole_contents(12 * b / (18 + 6 * c)) == 2 * b / (3 + c)
    assert with_whole_contents(2 * a + 2) == 2 * a + 2


def test_roots_by_the_cosine_of_which_a_power_is_stated() -> None:
    a, b, length = sp.symbols("a b l", positive=True)
    theta, third = sp.Symbol("theta", real=True), sp.Rational(1, 3)
    cosine = sp.cos(theta)
    stated, value = cosine**3, 2 * a / length
    for e, by_cosine in [
        ((2 * a) ** third * length ** (2 * third) / 2, length * cosine / 2),
        (b * (length / (2 * a)) ** third, b / cosine),
        (b * (2 * a / length) ** (2 * third) + b, b * cosine**2 + b),
    ]:
        form = by_stated_root(e, stated, value)
        assert sp.expand(form - by_cosine) == 0
        assert sp.simplify(form.xreplace({cosine: value**third}) - e) == 0
    for e in (b * sp.sqrt(a), b * b**third, b * a):
        assert by_stated_root(e, stated, value) == e, "other roots, and none"
    root = sp.sqrt(a) * b
    assert by_stated_root(root, cosine**2, a) == root, "the sign of the cosine is open"


def test_the_modulus_of_what_has_a_sign() -> None:
    acute, angle = Bounded("alpha", sp.S.Zero, sp.pi / 2, (True, True)), sp.Symbol("theta", real=True)
    assert shortest_form(abs(sp.sin(acute)) / 2) == sp.sin(acute) / 2
    assert shortest_form(abs(-sp.cos(acute))) == sp.cos(acute)
    assert shortest_form(abs(sp.sin(angle))) == abs(sp.sin(angle))


def test_differences_of_squares() -> None:
    whole = with_differences_of_squares(2 * b * (a - b) * (a + b) / c)
    assert {f for f in whole.args if f.is_Add} == {a**2 - b**2}
    assert sp.expand(whole - 2 * b * (a**2 - b**2) / c) == 0
    below = with_differences_of_squares(c / ((a - b) * (a + b)))
    assert below.has(a**2 - b**2)
    assert sp.cancel(below - c / (a**2 - b**2)) == 0
    assert with_differences_of_squares(c / ((1 - a) * (a + 1))).has(1 - a**2)
    assert with_differences_of_squares(c + sp.sqrt((a - b) * (a + b))).has(a**2 - b**2)
    for e in ((1 - sp.cos(a)) * (1 + sp.cos(a)), (a - b) * (a + b) ** 2, (a - b) * (a + c), (a + b) ** 2, a - b):
        assert with_differences_of_squares(e) == e


def test_factors_whose_difference_is_a_product() -> None:
    m, P = sp.symbols("m P", positive=True)
    e = P * (sp.Rational(1, 2) - m * P) * (sp.Rational(1, 2) + m * P)
    assert sp.expand(with_differences_of_squares(e) - e) == 0
