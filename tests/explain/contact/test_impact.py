"""An impact, in words: the principle for impulses, restitution, the work of a blow, the motion after it."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "ball-on-a-wedge",
            Rule.IMPACT,
            " the principle for impulses holds: the changes of momentum less the given impulses do no work. Here this reads",
        ),
        (
            "ball-on-a-wedge",
            Rule.IMPACT,
            ", where the rate of separation is that of approach times the coefficient of restitution ",
        ),
        (
            "centre-of-percussion",
            Rule.IMPACT,
            "The blow does the work of its impulse on the mean of the velocities before and after, ",
        ),
        (
            "ballistic-pendulum",
            Rule.IMPACT,
            "The questions are about the motion after the impact. It begins with the velocities just after it, at ",
        ),
    ],
)
def test_what_is_said_of_an_impact(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
