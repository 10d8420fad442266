"""Wrong velocities after an impact, impulses, and losses of energy."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from tests.answers.results.diagnoses import Row, assert_explained
from tests.support.shared import loaded, solved

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
    ("ballistic-pendulum", "impact", {"theta'": "2*m*v/((M + m)*l)"}, "the velocity after an elastic impact"),
    ("rod-falls-on-an-edge", "impact", {"theta'": "3*a*v/l^2"}, "the moment of inertia about the mass centre"),
    ("rod-falls-on-an-edge", "impact", {"theta'": "3*a*v/(4*l^2)"}, "the moment of inertia about an end of `rod`"),
    ("rod-falls-on-an-edge", "impact", {"N": "m*v"}, "as if its mass centre came to rest"),
    ("centre-of-percussion", "impact", {"x'": "J/m"}, "without `hinge`, as if nothing were held there"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_impacts(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


def test_the_square_of_a_velocity_is_explained_as_the_velocity_is() -> None:
    problem = "rod-falls-on-an-edge"
    judged = Examiner(loaded(problem), solved(problem)).check((Fragment.of("theta'^2 = 3*v^2/(l^2 + 3*a^2)"),))
    [said] = [e.diagnosis for a in judged.others for e in a.equations]
    assert "the kinetic energy is taken to be conserved" in said
