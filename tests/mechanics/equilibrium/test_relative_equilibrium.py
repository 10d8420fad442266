"""Equilibria of the equations of motion."""

from __future__ import annotations

from collections.abc import Callable

from lagrange.mechanics.equilibrium.relative_equilibrium import branches_at_rest, is_time, without_time
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from tests.support.shared import solved

BEADS = """title: Two beads and a spring
parameters: {g: positive}
coordinates: [theta, phi]
particles:
  A: {mass: 3, position: 2*cos(theta)*i + 2*sin(theta)*j}
  B: {mass: 1, position: (4 + 2*cos(phi))*i + 2*sin(phi)*j}
gravity: -g*j
forces: {tie: {spring: 4, between: [A, B], length: 1}}
find: linearization
"""


def test_a_bead_on_a_turning_hoop_is_at_rest_at_the_poles_and_beside_them() -> None:
    linear = next(v.linearization for v in solved("bead-on-rotating-hoop").views if v.linearization is not None)
    branches, complete = branches_at_rest(linear.equilibrium)
    assert complete
    assert len(branches) == len(linear.branches) >= 3


def test_what_is_time() -> None:
    configuration = solved("ex11-ideal-pendulum").own.configuration
    x = configuration.slots.coordinates[0]
    assert not is_time(x, configuration)
    assert without_time(x**2 + 1, configuration) == x**2 + 1


def test_where_a_spring_has_no_length_there_is_no_rest(problem: Callable[[str], Problem]) -> None:
    """At θ = 0, φ = π the beads meet: the conditions, multiplied by the length, hold there, and no force has a value."""
    linear = solve(problem(BEADS)).own.linearization
    assert linear is not None
    assert linear.equilibrium.branches[0].left
    assert linear.branches == ()
    assert not linear.complete
