"""The results for a problem: one record for each set of coordinates.

The values of a problem, with the units of named forces.
"""

from __future__ import annotations

import lagrange
from lagrange.core.units import unit_of
from lagrange.mechanics.results import values_in
from lagrange.mechanics.solution import solve
from tests.support.shared import solved


def test_the_coordinates_of_the_file_are_the_first_of_them() -> None:
    solution = solved("ex11-ideal-pendulum")
    assert [v.name for v in solution.views] == ["", "angle", "depth"]
    assert [v.is_own for v in solution.views] == [True, False, False]
    assert solution.holds
    assert all(v.motion is not None for v in solution.views)


# Solution values


PENDULUM = """
title: Weight on a rod
coordinates: {x: {unit: m}, y: {unit: m}}
parameters: {m: 10 kg, g: 9.81 m/s^2, l: 1 m}
particles: {P: {mass: m, position: x*i + y*j}}
gravity: -g*j
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: S}}
"""


def test_a_named_force_is_in_newtons() -> None:
    solution = solve(lagrange.loads(PENDULUM), complete=False)
    values = values_in(solution)
    newton = unit_of("N")
    assert values is not None
    assert newton is not None
    assert {s.name: d for s, d in values.units.items()}["S"] == newton.dimension


def test_without_numbers_there_are_none() -> None:
    assert values_in(solved("ex11-ideal-pendulum")) is None
