"""Titles of questions say what is asked for, and when."""

from __future__ import annotations

import pytest

from lagrange.explain.asked_for import titles_of_questions
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "titles"),
    [
        (
            "leaving-a-sphere",
            (
                "The angle from the top where contact ends",
                "The speed where contact ends",
                "The reaction as a function of the angle from the top",
            ),
        ),
        ("governor", ("The angular velocity in a steady state",)),
        (
            "released-pendulum",
            (
                "The velocity where the angle is zero",
                "The tension where the angle is zero",
                "The tension as a function of the angle",
                "Extreme value of the angle",
                "The angular acceleration at a given angle",
            ),
        ),
        ("ballistic-pendulum", ("Extreme value of the angle",)),
        (
            "raindrop",
            ("The acceleration as a function of the distance fallen", "The velocity at a given distance fallen"),
        ),
    ],
)
def test_the_title_says_what_is_asked_for(name: str, titles: tuple[str, ...]) -> None:
    assert titles_of_questions(reported(name, complete=False).solution) == titles


def test_two_questions_with_one_title_have_their_names() -> None:
    first, second, _ = titles_of_questions(reported("over-the-top", complete=False).solution)
    assert first != second
    assert first.endswith("(a turn later)")
