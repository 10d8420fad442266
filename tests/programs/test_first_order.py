"""First-order equations in symbols."""

from __future__ import annotations

import sympy as sp

from lagrange.programs.first_order import in_coordinates
from tests.support.shared import solved


def test_a_pendulum_in_its_angle_and_with_its_rod() -> None:
    solution = solved("ex11-ideal-pendulum")
    angle = solution.choices[0].dynamics
    assert angle is not None
    free = in_coordinates(angle)
    [acceleration] = sp.Matrix(free.mass).LUsolve(sp.Matrix(free.force))
    theta = free.slots.coordinates[0]
    g, length = sp.Symbol("g", positive=True), sp.Symbol("l", positive=True)
    assert sp.simplify(acceleration + g / length * sp.sin(theta)) == 0
    assert solution.own.dynamics is not None
    held = in_coordinates(solution.own.dynamics)
    assert len(held.constraint_matrix) == 1
    assert len(held.state) == 4
