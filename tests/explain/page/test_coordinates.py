"""Which coordinates are independent, and how many."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule, Step
from lagrange.explain.page.coordinates import explain_independence, line
from tests.support.derivation_text import words
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("ex04-dumbbell", "These five coordinates are independent, with no relation between them; the six of the file"),
        ("ex06-two-particle-skate", "These three coordinates are independent, with no finite relation between them;"),
        ("ex11-ideal-pendulum", ""),
        ("statics/crate-tips-or-slides", ""),
    ],
)
def test_how_many_coordinates_are_independent(name: str, sentence: str) -> None:
    solution = reported(name).solution
    said = explain_independence(solution, solution.choices[0])
    if not sentence:
        assert said is None  # motion or rest is the question
        return
    assert said is not None
    assert words(Step(Rule.GENERALIZED_COORDINATES, "", (said,))).startswith(sentence)


def test_a_line_is_called_by_two_letters_where_both_can_be_read() -> None:
    assert [line("", "P"), line("P1", "P2")] == ["OP", "P1P2"]
    assert line("", "AB") == "the line from O to AB"
