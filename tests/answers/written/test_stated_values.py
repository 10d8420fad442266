"""Values that an answer states for parameters."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.written.stated_values import NUMBER, is_unit, value_of


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        (" 9.81 m/s^2", sp.Rational("9.81"), " m/s^2"),
        ("2,5", sp.Rational(5, 2), ""),
        (r" 6.67 \cdot 10^{-11} N m^2/kg^2", sp.Rational("6.67e-11"), " N m^2/kg^2"),
        ("3e4 N", sp.Integer(30000), " N"),
    ],
)
def test_a_number_with_what_follows_it(text: str, value: sp.Expr, unit: str) -> None:
    match = NUMBER.match(text)
    assert match is not None
    assert (value_of(match), match["unit"]) == (value, unit)


@pytest.mark.parametrize(
    ("text", "bare", "is_one"),
    [
        (" m/s^2", False, True),
        (" m", False, True),
        ("m", False, False),
        (" x", False, False),
        ("", True, True),
        ("", False, False),
    ],
)
def test_a_letter_after_a_number_is_a_unit_only_after_a_space(text: str, bare: bool, is_one: bool) -> None:
    assert is_unit(text, {"m"}, bare) is is_one
