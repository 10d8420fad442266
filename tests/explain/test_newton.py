"""Newton's law with reactions, in words: their nature, and what is not determined."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex11-ideal-pendulum", Rule.REACTIONS, "its reaction acts along the line joining them."),
        (
            "bifilar-suspension",
            Rule.REACTIONS,
            "At rest nothing is accelerated: by Newton's law applied force and reaction cancel",
        ),
        (
            "skewed-disc",
            Rule.REACTIONS,
            " times the coefficients of their forms. They have moments and are no single forces: ",
        ),
        (
            "ball-on-turntable",
            Rule.REACTIONS,
            "The reactions of the first and second rolling constraints on the ball are the forces ",
        ),
        ("bead-on-any-wire", Rule.REACTIONS, ", in the direction in which the left side less the right side increases"),
        (
            "trolley-on-three-wheels",
            Rule.REACTIONS,
            " The constraints are not independent, so the multipliers are not determined individually, only their combined effect.",
        ),
    ],
)
def test_what_is_said_of_reactions(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
