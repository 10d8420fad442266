"""Reactions that are too long as functions of position and velocity."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("four-bar-linkage", Rule.SOLVED_REACTIONS, " too long to be written as functions of position and velocity."),
        ("four-bar-linkage", Rule.SOLVED_REACTIONS, " In terms of the accelerations, Newton's equations give"),
    ],
)
def test_they_are_given_by_the_accelerations(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
