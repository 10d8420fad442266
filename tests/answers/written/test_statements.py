"""A statement about one quantity: label, sides, definitions."""

from __future__ import annotations

import pytest

from lagrange.answers.written.statements import statement
from lagrange.core.diagnostics import Fragment
from tests.support.scopes import PLANE


@pytest.mark.parametrize(
    ("text", "label", "sides"),
    [
        ("h_max = 2*m*g/k", "h", ["2*m*g/k"]),
        ("v^2 = 2*g*a", "v^2", ["2*g*a"]),
        (r"v_\text{esc} = \sqrt{2 g a}", "v", [r"\sqrt{2 g a}"]),
        ("x = a", "", ["x", "a"]),  # x is a coordinate, and no label
        ("h = a + b = c", "h", ["a + b", "c"]),
    ],
)
def test_a_name_on_the_left_that_nobody_declared_is_a_label(text: str, label: str, sides: list[str]) -> None:
    stated = statement(Fragment.of(text), PLANE)
    assert stated.label == label
    assert [s.text.strip() for s in stated.sides] == sides


def test_names_may_be_defined_beside_it() -> None:
    stated = statement(Fragment.of("a*cos(w*t), w = sqrt(k/m)"), PLANE)
    w = stated.scope.scalar("w")
    assert w is not None
    assert w**2 == PLANE.scalars["k"] / PLANE.scalars["m"]
    assert stated.sides[0].text.strip() == "a*cos(w*t)"
