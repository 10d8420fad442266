"""Two mistakes at once are named together."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, feedback_on, name_of


@pytest.mark.parametrize("answer", answers_by("pairs"), ids=name_of)
def test_both_are_named(answer: WrongAnswer) -> None:
    assert_named(answer)


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (
            "chain-off-a-table",
            "x*x'' + x'^2 = g*x",
            "as if the exchanged mass had no velocity, and without the mass of `lying_part`",
        ),
    ],
)
def test_exchanged_mass_and_a_mass_left_out(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
