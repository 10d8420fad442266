"""Reactions are written without the velocities that constraints keep zero: what is zero is printed as zero."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

BLADES = """
title: A skate that is held by several constraints
parameters: [m, J, F]
coordinates: [x, y, theta]
bodies: {P: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
constraints:
  blade: x'*sin(theta) = y'*cos(theta)
  line: y' = 0
  stop: x'*sin(theta) - y'*cos(theta) + y' = 0
  also: 2*y' = 0
"""


@pytest.mark.parametrize(
    ("forces", "values"),
    [("", ["0", "0"]), ("forces: {push: {on: P, vector: F*i}}\n", ["-F/sin(theta)", "-F*cos(theta)/sin(theta)"])],
)
def test_dependent_constraints_that_leave_no_velocity(problem: Read, forces: str, values: list[str]) -> None:
    """x' = y' = 0: there is no m x' theta' cos(theta) in what the four multipliers do together."""
    solution = solve(problem(BLADES + forces))
    assert solution.holds
    assert solution.dynamics is not None
    assert solution.dynamics.reactions is not None
    found = solution.dynamics.reactions.combinations
    assert [[s.name for _, s in c.terms] for c in found] == [
        ["lambda_blade", "lambda_stop"],
        ["lambda_line", "lambda_stop", "lambda_also"],
    ]
    assert [str(c.value) for c in found] == values
