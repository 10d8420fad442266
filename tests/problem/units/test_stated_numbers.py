"""Numbers with units among stated answers are read as numbers when the file is loaded."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Fragment
from lagrange.problem.units.stated_numbers import without_units


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("P <= 117.7 N", "P <= 117.7"),
        ("s = 12 in", "s = 12"),
        ("-2.5 kN <= P <= 117.7 N", " -2.5 <= P <= 117.7"),
        ("theta = 24.75 deg", "theta = 24.75"),
        ("P <= 3 x", "P <= 3 x"),
    ],
)
def test_a_side_that_is_a_number_with_a_unit_is_the_number(text: str, plain: str) -> None:
    assert " ".join(without_units(Fragment.of(text)).text.split()) == " ".join(plain.split())
