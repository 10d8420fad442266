"""Answers to questions, with the reason for the branch that is taken."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "hoop-off-a-cylinder",
            Rule.QUESTION,
            "The initial state is an equilibrium, from which the motion may start in either direction: one value belongs to each.",
        ),
        (
            "chain-off-a-table",
            Rule.QUESTION,
            " has the wrong sense: a coordinate that reaches a value for the first time moves towards it.",
        ),
        ("ball-thrown-up", Rule.QUESTION, " has the opposite sense, for which this equation of motion does not hold."),
        (
            "boat-that-drifts",
            Rule.QUESTION,
            "There the velocity and the acceleration vanish: a motion that starts elsewhere only approaches this state, in the limit ",
        ),
    ],
)
def test_the_reason_for_a_branch(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
