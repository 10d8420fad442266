"""Wrong velocities after an impact, impulses, and losses of energy."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

CAUGHT = "rod-caught-at-an-end"
STEP = "disc-against-a-step"

WRONG: list[Row] = [
    (STEP, "impact", {"theta'": "omega*(1 - h/(2*R))"}, "the moment of inertia m*R^2 for `disc`, which a hoop has"),
    (STEP, "impact", {"theta'": "2*omega*(R - h)/(3*R)"}, "without theta' just before the impact"),
    (STEP, "impact", {"theta'": "omega"}, "the velocity just before the impact"),
    (CAUGHT, "impact", {"theta'": "sqrt(3)*v/l"}, "the kinetic energy is taken to be conserved"),
    (CAUGHT, "impact", {"energy_lost": "m*v^2/2"}, "the whole kinetic energy just before the impact"),
    (CAUGHT, "impact", {"theta'": "6*v/l"}, "the moment of inertia about the mass centre"),
    ("ballistic-pendulum", "impact", {"theta'": "m*v/(M*l)"}, "without the inertia of `bullet`"),
    ("ballistic-pendulum", "impact", {"energy_lost": "0"}, "some kinetic energy is lost here"),
    ("centre-of-percussion", "impact", {"x'": "J/m"}, "without `hinge`, as if nothing were held there"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_impacts(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
