"""14,01 as 14.01, and no list taken for a decimal."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.decimal_commas import with_decimal_points


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("h = 2,5 R, v = 3", "h = 2.5 R, v = 3"),
        ("sin(0,5 x)", "sin(0.5 x)"),
        (r"\frac{2,5}{3} x_{1,2}", r"\frac{2.5}{3} x_{1,2}"),
        ("atan2(1,2) + f(1,2) + [1,2]", "atan2(1,2) + f(1,2) + [1,2]"),
        ("n = 1,2,3 and W = 10,000", "n = 1,2,3 and W = 10,000"),
    ],
)
def test_decimal_commas(text: str, written: str) -> None:
    assert with_decimal_points(text) == written
