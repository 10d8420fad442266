"""Coordinates that two contacts hold together, and the forces there."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.rewriting.held_together import held_together
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

CAR = """title: A car that is pulled
parameters: [m, J, a, b, h, F, g]
coordinates: [x, y, phi]
bodies:
  car: {mass: m, inertia: J, position: x*i + y*j, angle: phi}
constraints:
  front: {equation: "y + a*sin(phi) - h*cos(phi) = 0", reaction: N}
  rear: {equation: "y - b*sin(phi) - h*cos(phi) = 0", reaction: S}
gravity: -g*j
forces:
  pull: {on: car, vector: F*i, at: "r_car - h*e2_car"}
"""


def test_two_axles_hold_height_and_tilt() -> None:
    """The forces against moments about the two points of contact: N (a + b) = m g b − F h, S (a + b) = m g a + F h."""
    solution = solve(read_problem(Source("car.yaml", CAR)), complete=False)
    held = held_together(solution)
    assert held is not None
    letters = {p.symbol.name: p.symbol for p in solution.problem.parameters}
    m, a, b, h, F, g = (letters[n] for n in ("m", "a", "b", "h", "F", "g"))
    assert {q.name: e for q, e in held.values.items()} == {"y": h, "phi": 0}  # without an initial state
    forces = {s.name: e for s, e in held.forces.items()}
    assert sp.simplify(forces["N"] * (a + b) - (m * g * b - F * h)) == 0
    assert sp.simplify(forces["S"] * (a + b) - (m * g * a + F * h)) == 0


@pytest.mark.parametrize(
    "constraints",
    [
        'front: {equation: "y - h = 0", reaction: N}',  # each by itself
        'front: {equation: "y + a*sin(phi) - h*cos(phi) = 0", reaction: N}',  # it can still tilt
    ],
)
def test_what_is_not_held_together(constraints: str) -> None:
    head, _, rest = CAR.partition("  front:")
    text = f"{head}  {constraints}\n{rest[rest.index('gravity') :]}"
    assert held_together(solve(read_problem(Source("car.yaml", text)), complete=False)) is None
