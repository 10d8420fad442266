"""Slots and tubes that turn."""

from __future__ import annotations

import math

import pytest

from lagrange.document.scene import StrokeKind
from lagrange.pictures.implied.turning_guides import radius_of_disc, turning_guides
from tests.support.drawings import drawing_of, lines_of, sketched

SLOT = """
parameters: [m, a, w, k]
coordinates: [s]
let: {u: cos(w*t)*i + sin(w*t)*j, v: -sin(w*t)*i + cos(w*t)*j}
particles: {bead: {mass: m, position: a*u + s*v}}
forces: {spring: {spring: k, between: [a*u, bead]}}
"""
TUBE = """
parameters: [m, J]
coordinates: [r, phi]
particles: {bead: {mass: m, position: r*cos(phi)*i + r*sin(phi)*j}}
"""


def test_a_slot_is_in_its_disc_at_its_distance_from_the_axis_with_the_speed() -> None:
    system = drawing_of("A slot in a disc", SLOT)
    [guide] = turning_guides(system)
    values = {s.name: v for s, v in system.pose.values.items()}
    assert math.hypot(*guide.foot) == pytest.approx(values["a"])
    assert str(guide.speed) == "w"
    assert radius_of_disc(system, [guide]) > math.hypot(*guide.place)
    scene = sketched("A slot in a disc", SLOT)
    assert {"w", "a"} <= {str(label.content) for label in scene.labels}
    assert lines_of(scene, StrokeKind.GROUND) == []  # the spring is fastened to the disc


def test_a_tube_turned_by_a_coordinate_goes_through_the_axis() -> None:
    system = drawing_of("A bead in a tube", TUBE)
    [guide] = turning_guides(system)
    assert math.hypot(*guide.foot) < 1e-9
    assert guide.speed is None
    assert radius_of_disc(system, [guide]) == 0


def test_no_guide_without_the_word() -> None:
    assert [*turning_guides(drawing_of("A particle in a plane", TUBE))] == []
