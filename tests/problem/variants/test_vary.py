"""The section `vary`."""

from __future__ import annotations

from fractions import Fraction

import pytest

from lagrange.problem.variants.vary import decimal


@pytest.mark.parametrize(
    ("number", "digits"),
    [("1/2", "0.5"), ("-1/8", "-0.125"), ("7", "7"), ("1/3", "1/3"), ("21/20", "1.05"), ("1000", "1000"), ("0", "0")],
)
def test_decimals(number: str, digits: str) -> None:
    import sympy as sp

    assert decimal(sp.Rational(number)) == digits
    assert Fraction(digits) == Fraction(number)
