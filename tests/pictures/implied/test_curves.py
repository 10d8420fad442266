"""The curves and the ground of constraints: what a disc or box touches, and on which side."""

from __future__ import annotations

import math

import pytest

from lagrange.document.scene import Scene, StrokeKind
from tests.support.drawings import lines_of, sketched

BOX = """
axes: {i: right, j: up}
parameters: {W: positive, r: positive, b: positive}
coordinates: [x_1, y_1, x_2, y_2]
particles:
  lower: {position: "[x_1, y_1]", shape: {disc: r}}
  upper: {position: "[x_2, y_2]", shape: {disc: r}}
constraints:
  floor: {equation: y_1 >= r, reaction: N_1}
  left_wall: {equation: x_1 >= r, reaction: N_2}
  right_wall: {equation: x_2 <= b - r, reaction: N_3}
forces: {w: {on: lower, vector: -W*j}, v: {on: upper, vector: -W*j}}
figure: {at: {r: 0.5, b: 3, y_2: 1.2}}
find: equilibrium
"""
PARABOLA = """
axes: {i: right, j: up}
parameters: [W, a, c]
coordinates: {x: x, y: y, theta: {range: [-89 deg, 89 deg]}}
bodies: {rod: {position: x*i + y*j, angle: theta, shape: {rod: [r_rod - a*e1_rod, r_rod + a*e1_rod]}}}
constraints:
  A: {equation: "4*c*(y - a*sin(theta)) = (x - a*cos(theta))^2"}
  B: {equation: "4*c*(y + a*sin(theta)) = (x + a*cos(theta))^2"}
forces: {weight: {on: rod, vector: -W*j}}
find: equilibrium
"""


def hatched_side(scene: Scene, upright: bool) -> dict[float, int]:
    """The straight pieces of ground at their x or y: 1 where what is hatched is at smaller values."""
    found = {}
    for line in lines_of(scene, StrokeKind.GROUND):
        (a, b), n = line.points, 0 if upright else 1
        if abs(a[n] - b[n]) < 1e-6:  # hatched to the right of the way
            right = (b[1] - a[1], a[0] - b[0])
            found[round(a[n], 3)] = 1 if right[n] < 0 else -1
    return found


def test_a_disc_touches_floor_and_walls_with_its_rim_and_is_between_the_walls() -> None:
    scene = sketched("Two discs in a box", BOX)
    walls, floors = hatched_side(scene, True), hatched_side(scene, False)
    left, right = sorted(walls)
    assert walls[left] == 1
    assert walls[right] == -1, "the hatching of a wall is on the side from which N pushes"
    scale = (right - left) / 3
    assert scale > 0.1
    assert left == pytest.approx(0.0, abs=1e-3)
    assert floors == {0.0: 1}


def test_the_end_of_a_rod_slides_on_the_curve_of_its_constraint() -> None:
    curves = lines_of(sketched("Rod in a parabola", PARABOLA), StrokeKind.CURVE)
    assert curves
    ratios = [y / x**2 for line in curves for x, y in line.points if abs(x) > 0.3]
    assert max(ratios) - min(ratios) < 1e-3 * math.fabs(max(ratios))


def test_the_ellipse_on_which_a_rope_keeps_a_ring_is_no_wire() -> None:
    text = (
        "parameters: [W, L, d]\ncoordinates: [x, y]\nparticles: {ring: {position: x*i - y*j}}\n"
        "constraints: {%s: sqrt(x^2 + y^2) + sqrt((d - x)^2 + y^2) = L}\n"
        "forces: {weight: {on: ring, vector: -W*j}}\nfind: equilibrium\n"
    )
    curves = [len(lines_of(sketched("A ring", text % name), StrokeKind.CURVE)) for name in ("rope", "track")]
    assert curves == [0, 1]
