"""Results in numbers: rounding, units, what is not real; against floating-point evaluation."""

from __future__ import annotations

import math
import random

import pytest
import sympy as sp

from lagrange.core.units import unit_of
from lagrange.document.math_writer import Writer, latex, text, unicode
from lagrange.document.style_mathml import MathML
from lagrange.values.quantities import NotRealError, Values, real_value, rounded, with_unit

l, g, m, k = sp.symbols("l g m k", positive=True)
theta, acceleration = sp.Symbol("theta", real=True), sp.Symbol("theta''", real=True)
ONE = sp.pi / 7
VALUES = Values(
    {l: sp.Rational(3, 10), g: sp.Rational(981, 100), k: sp.Integer(200)},
    frozenset({l, g, m, k}),
    {s: unit_of(u).dimension for s, u in ((l, "m"), (g, "m/s^2"), (m, "kg"), (k, "N/m"))},  # type: ignore[union-attr]
)


@pytest.mark.parametrize(
    ("expression", "shown"),
    [
        (sp.sqrt(g / l), "5.718 s⁻¹"),
        (g * l, "2.943 m²/s²"),
        (k * l, "60 N"),
        (k * l**2, "18 N m"),
        (-k / 7, "−28.57 N/m"),
        (g - g, "0"),
        (l * acceleration + g * sp.sin(theta), "0.3θ̈ + 9.81 sin θ"),
        (3 * sp.sqrt(2) * l * acceleration + sp.pi * acceleration + g * sp.sin(2 * theta), "4.414θ̈ + 9.81 sin 2θ"),
        ((l * acceleration + g) ** 2 / l, "3.333 (0.3θ̈ + 9.81)²"),
        (sp.exp(-g * theta / l), "e^(−32.7θ)"),
        (2 * theta + g, "2θ + 9.81"),
        (-theta * l / l, "−θ"),
        (theta * sp.sin(ONE) ** 2 + theta * sp.cos(ONE) ** 2 - theta + g * sp.cos(theta), "9.81 cos θ"),
    ],
)
def test_expressions_in_numbers(expression: sp.Expr, shown: str) -> None:
    quantity = VALUES.quantity(expression)
    assert quantity is not None
    assert unicode(quantity.shown()) == shown


@pytest.mark.parametrize(
    "expression", [m * g, sp.sqrt(l - g), sp.acos(g), sp.log(l - g), 1 / (g - 981 * sp.S.One / 100)]
)
def test_what_has_no_real_value(expression: sp.Expr) -> None:
    assert VALUES.quantity(expression) is None


@pytest.mark.parametrize(
    ("number", "digits", "shown"),
    [
        (sp.Rational(20004, 10000), 4, "2.000"),
        (sp.Integer(2), 4, "2"),
        (sp.Integer(123456), 4, "123500"),
        (sp.Integer(1200), 4, "1200"),
        (sp.Rational(1, 3), 4, "0.3333"),
        (sp.Rational(1, 3), 10, "0.3333333333"),
        (sp.pi * 10**6, 4, "3.142·10⁶"),
        (-sp.pi / 10**5, 4, "−3.142·10⁻⁵"),
        (sp.pi, 1, "3"),
        (sp.pi, 14, "3.1415926535898"),
        (sp.Rational(1, 8), 2, "0.12"),
        (sp.sqrt(2) - sp.Rational(141421356, 10**8), 4, "2.373·10⁻⁹"),
        (sp.sin(sp.pi / 7) ** 2 + sp.cos(sp.pi / 7) ** 2 - 1, 4, "0"),
    ],
)
def test_rounding(number: sp.Expr, digits: int, shown: str) -> None:
    assert unicode(rounded(number, digits)) == shown


def test_what_is_printed_is_right_to_its_last_digit() -> None:
    chance = random.Random(1)
    for _ in range(300):
        number = sp.Rational(chance.randint(-(10**6), 10**6), chance.randint(1, 10**6)) * sp.sqrt(chance.randint(1, 9))
        digits = chance.randint(1, 12)
        value = float(number)
        printed = float(text(rounded(number, digits)).replace(" ", ""))
        assert math.isclose(printed, value, rel_tol=0.5000001 * 10 ** (1 - digits), abs_tol=0)


@pytest.mark.parametrize("number", [sp.zoo, sp.sqrt(-1), sp.acos(2), sp.log(-3)])
def test_numbers_that_are_not_real(number: sp.Expr) -> None:
    with pytest.raises(NotRealError):
        real_value(number)


def test_units_in_every_style() -> None:
    speed = with_unit(rounded(sp.sqrt(3)), "m/s^2")
    assert (unicode(speed), text(speed), latex(speed)) == ("1.732 m/s²", "1.732 m/s^2", r"1.732 \,\mathrm{m/s^{2}}")
    assert "<mn>1.732</mn>" in Writer(MathML()).plain(speed)
    assert "<mtext>m/s²</mtext>" in Writer(MathML()).plain(speed)
    angle = with_unit(sp.Integer(30), "°")
    assert (unicode(angle), latex(angle)) == ("30°", r"30 ^\circ")
