"""D'Alembert's principle and the equations of motion, in words."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex11-ideal-pendulum", Rule.EQUATIONS_OF_MOTION, " is arbitrary, so its coefficient must vanish"),
        (
            "cylinder-on-rough-incline",
            Rule.EQUATIONS_OF_MOTION,
            "With multipliers instead, nothing is eliminated. The ",
        ),
        ("disc-that-rolls-steadily", Rule.EQUATIONS_OF_MOTION, "constraints on the displacements, times multipliers "),
    ],
)
def test_how_the_equations_follow(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
