"""The parameters that are loads."""

from __future__ import annotations

import lagrange
from lagrange.mechanics.equilibrium.loads import loads
from lagrange.mechanics.solution import solve

COLUMN = """
title: Bar on a spring
parameters: [l, c, P]
coordinates: [theta]
particles: {top: {position: l*sin(theta)*i + l*cos(theta)*j}}
forces: {load: {on: top, vector: -P*j}, spring: {potential: c*theta^2/2}}
find: equilibrium
"""


def test_the_size_of_a_force_and_no_stiffness() -> None:
    configuration = solve(lagrange.loads(COLUMN), complete=False).own.configuration
    assert [s.name for s in loads(configuration)] == ["P"]
