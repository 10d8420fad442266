"""The checks of a motion notice what is wrong."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from lagrange.core.inertia import InertiaTensor
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import check_motion
from lagrange.mechanics.results import Solution
from tests.support import shared


def solution_of(name: str) -> Solution:
    return shared.solved(name)


def checks_with(solution: Solution, changed: Configuration) -> list[bool | None]:
    motion = replace(solution.own.motion, configuration=changed)
    reactions = {c.name: c.reaction for c in solution.problem.constraints}
    return [c.passed for c in check_motion(motion, reactions)]


@pytest.mark.parametrize("name", ["heavy_top", "free_top", "rolling_disc", "compound_pendulum", "free_top_quasi"])
def test_the_checks_notice_another_moment_of_inertia(name: str) -> None:
    solution = solution_of(name)
    configuration = solution.own.configuration
    [turning] = configuration.rotations
    assert False not in checks_with(solution, configuration)
    a, b, c = turning.inertia.moments
    wrong = replace(turning, inertia=InertiaTensor((a, b, 2 * c)))
    assert False in checks_with(solution, replace(configuration, rotations=(wrong,)))


def test_the_checks_notice_other_moments_springs_and_dampers() -> None:
    plate, rods = solution_of("pushed_plate"), solution_of("braced_rods")
    torques = plate.own.configuration.torques
    assert False in checks_with(plate, replace(plate.own.configuration, torques=torques[:-1]))
    assert False in checks_with(rods, replace(rods.own.configuration, dampers=()))
    [spring] = rods.own.configuration.springs
    elsewhere = replace(spring, apart=spring.apart * sp.Integer(2))
    assert False in checks_with(rods, replace(rods.own.configuration, springs=(elsewhere,)))
