"""Which letters of lengths a figure has, and where they stand."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.document.scene import Scene, StrokeKind
from lagrange.pictures.implied.lengths import other_values, places_of, rounds_of
from tests.support.drawings import drawing_of, lines_of, sketched

LADDER = """
parameters: [m, l, g]
coordinates: [theta]
axes: {i: right, j: up}
bodies:
  ladder:
    {mass: m, inertia: m*l^2/12, position: l/2*cos(theta)*i + l/2*sin(theta)*j, angle: -theta,
     shape: {rod: [l*cos(theta)*i, l*sin(theta)*j]}}
gravity: -g*j
"""
DISC = """
parameters: [m, R, g]
coordinates: [x, phi]
axes: {i: right, j: up}
bodies: {disc: {mass: m, inertia: m*R^2/2, position: x*i + R*j, angle: -phi, shape: {disc: R}}}
constraints: {rolling: "x' = R*phi'"}
gravity: -g*j
"""
CRATE = """
parameters: [W, P, b, c, h]
coordinates: [x, y]
axes: {i: right, j: up}
bodies: {crate: {inertia: 0, position: x*i + y*j, angle: 0, shape: {box: [2*b, 2*c]}}}
forces: {push: {on: crate, vector: P*i, at: r_crate + (h - c)*j}}
"""
BOWL = """
parameters: [m, R, r, g]
coordinates: [phi]
axes: {i: right, j: up}
particles: {P: {mass: m, position: R*sin(phi)*i - R*cos(phi)*j}}
gravity: -g*j
"""


def where(scene: Scene, name: str) -> tuple[float, float]:
    labels = [w for w in scene.labels if isinstance(w.content, sp.Expr) and name in map(str, w.content.free_symbols)]
    return labels[0].at


def test_the_length_of_a_rod_stands_at_a_dimension_line() -> None:
    scene = sketched("Ladder", LADDER)
    x, y = where(scene, "l")
    lines = [line for line in lines_of(scene, StrokeKind.DIMENSION) if math.dist(*line.points) > 0.5]
    assert min(math.dist(((a + c) / 2, (b + d) / 2), (x, y)) for (a, b), (c, d) in (w.points for w in lines)) < 1


def test_a_radius_leads_from_the_centre() -> None:
    assert where(sketched("Disc", DISC), "R")


@pytest.mark.parametrize("letter", ["b", "c"])
def test_the_sides_of_a_box_and_the_height_of_a_force(letter: str) -> None:
    assert where(sketched("Crate", CRATE), letter)


def test_what_is_no_length_of_anything_has_no_letter() -> None:
    labels = {str(w.content) for w in sketched("Pendulum", BOWL).labels}
    assert "R" in labels
    assert "r" not in labels


def test_lengths_are_compared_for_other_values_of_all_parameters() -> None:
    system = drawing_of("Ladder", LADDER)
    first, second = other_values(system)
    [l] = [s for s in system.pose.values if s.name == "l"]
    sizes = [s.pose.values[l] for s in (system, first, second)]
    assert len({round(x, 6) for x in sizes}) == 3
    for s, size in zip((system, first, second), sizes, strict=True):
        at = places_of(s)
        assert math.dist(at["end ladder 0"], at["end ladder 1"]) == pytest.approx(size)


def test_a_disc_is_round() -> None:
    system = drawing_of("Disc", DISC)
    [disc] = [r for name, r in rounds_of(system).items() if name == "shape disc"]
    assert all(math.dist(disc.centre, at) == pytest.approx(disc.radius) for at in disc.rim)
