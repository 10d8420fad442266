"""The surface of a bowl."""

from __future__ import annotations

import lagrange
from lagrange.animation.samples import surfaces
from lagrange.mechanics.solution import solve

BOWL = """
title: Bowl
parameters: [a, b, c]
coordinates: [x, y, z]
particles: {P: {position: x*i + y*j + z*k}}
constraints: {bowl: z = a*(x - c)^2 + b*y^2}
find: constraints
"""


def test_a_surface_is_solved_for_its_height_and_has_its_bottom() -> None:
    solution = solve(lagrange.loads(BOWL), complete=False)
    [((x, y, height), along, shift)] = surfaces(solution.own.configuration)
    assert along == (x, y)
    a, b, c = (p.symbol for p in solution.problem.parameters)
    assert (height - a * (x - c) ** 2 - b * y**2).expand() == 0
    assert shift == c
