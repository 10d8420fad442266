"""Coordinates that the constraints hold are put in."""

from __future__ import annotations

from lagrange.explain.report import report
from lagrange.render import json as in_json
from tests.mechanics.equilibrium.friction.test_friction_at_rest import Read

SHAFT = """title: Bracket on a rough shaft, written without a choice of coordinates
axes: {i: right, j: up}
parameters: {W: positive, mu: positive, h: positive, d: positive, x_W: positive}
coordinates: [x, y, theta]
bodies: {bracket: {inertia: 0, position: x*i + y*j, angle: theta}}
constraints:
  A: {equation: "x + d/2 - h*sin(theta) <= d/2", reaction: N_A}
  B: {equation: "x - d/2 >= -d/2", reaction: N_B}
forces:
  load: {on: bracket, vector: -W*j, at: r_bracket + x_W*i}
  rub_A: {friction: mu, static: mu, constraint: A, on: bracket, at: r_bracket + d/2*i + h*e2_bracket, slip: -j}
  rub_B: {friction: mu, static: mu, constraint: B, on: bracket, at: r_bracket - d/2*i, slip: -j}
find: equilibrium
"""


def test_coordinates_that_the_constraints_hold_are_put_in(problem: Read) -> None:
    rest = in_json.as_object(report(problem(SHAFT)))["rest"]
    assert sorted(case[0] for case in rest["cases"]) == ["h/(2*x_W) <= mu", "h/d <= mu"]
