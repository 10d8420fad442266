"""Wrong positions of rest beside the derived value of a tangent: what each answer is was worked out from the slip."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import diagnoses

PLANES = "rod-on-unequal-planes"


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (PLANES, "2*tan(theta) = 1/tan(beta) - 1/tan(alpha)", "with alpha and beta exchanged"),
        (PLANES, "tan(theta) = 1/tan(alpha) - 1/tan(beta)", "in the value of tan(theta): there is a factor 2 too many"),
        ("ex16-rod-on-two-planes", "theta = 0", "these are the equilibria for k = 1/2 alone"),
    ],
)
def test_the_value_of_a_tangent(problem: str, stated: str, said: str) -> None:
    _, diagnosis = diagnoses(problem, {"equilibrium": [stated]})
    assert said in diagnosis
