"""Mistakes in composed velocities are named: the answers are derived by hand from the wrong models."""

from __future__ import annotations

import pytest

from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.answers.models.slips import examiner

OFFSET = "without r in the position, and with phi' subtracted from the angular velocity of `yo_yo`"
ABSOLUTE = "for `cylinder` turning according to its absolute velocity, X' included"
AT_RIGHT_ANGLES = "as if the part of the velocity of `half` that comes from x' were at right angles to the rest"


@pytest.mark.parametrize(
    ("problem", "equations", "said"),
    [
        ("rocking-half-cylinder", ["(I_G + m*(R^2 + h^2))*theta'' + m*g*h*sin(theta) = 0"], AT_RIGHT_ANGLES),
        ("rocking-half-cylinder", ["(I_G + m*h^2)*theta'' + m*g*h*sin(theta) = 0"], "without what x' contributes"),
        (
            "cylinder-on-wedge",
            [
                "(M + m)*X'' + m*s''*cos(alpha) + m/2*cos(alpha)*(s'' + X''*cos(alpha)) = 0",
                "3/2*(s'' + X''*cos(alpha)) = g*sin(alpha)",
            ],
            ABSOLUTE,
        ),
        (
            "swinging-yo-yo",
            ["(m + I_G/r^2)*s'' = m*s*phi'^2 + m*g*cos(phi)", "s*phi'' + 2*s'*phi' + g*sin(phi) = 0"],
            OFFSET,
        ),
    ],
)
def test_the_part_of_the_velocity_is_named(problem: str, equations: list[str], said: str) -> None:
    judgement = examiner(problem).check(tuple(map(Fragment.of, equations)))
    assert judgement.verdict is Verdict.WRONG
    assert all(said in e.diagnosis for e in judgement.each)
