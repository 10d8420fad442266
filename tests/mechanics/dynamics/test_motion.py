"""The motion in one set of coordinates, with its reactions."""

from __future__ import annotations

from lagrange.mechanics.dynamics.motion import Method
from tests.support.shared import solved


def test_the_tension_of_a_pendulum() -> None:
    solution = solved("ex11-ideal-pendulum")
    motion = solution.choices[0].dynamics
    assert motion is not None
    assert {q.name: str(a) for q, a in motion.accelerations.items()} == {"theta''": "-g*sin(theta)/l"}
    assert motion.reactions is not None
    assert not motion.sliding
    assert solution.law is not None
    assert solution.law.method is Method.DALEMBERT
    assert solution.law.frictions == ()


def test_friction_slides() -> None:
    assert solved("mass-on-belt").own.dynamics.sliding or solved("mass-on-belt").choices[0].dynamics.sliding
