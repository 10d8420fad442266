"""Coordinates of the answer's own."""

from __future__ import annotations

import pytest

from lagrange.answers.written.new_coordinates import defined_coordinate
from lagrange.core.diagnostics import Fragment
from tests.support.scopes import PLANE


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("x = a + s", "-a + x"),
        ("x = b*s", "x/b"),
        ("x' = b*s'", "x/b"),
        ("x = s^2", "None"),  # not linear
        ("x' = x*s'", "None"),  # not to be integrated
    ],
)
def test_a_coordinate_in_terms_of_those_of_the_problem(text: str, meaning: str) -> None:
    assert str(defined_coordinate(Fragment.of(text), "s", PLANE)) == meaning
