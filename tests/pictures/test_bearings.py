"""Pins, rollers, clamps and slots."""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.document.names import Notation
from lagrange.document.scene import Scene, StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import system_in_file
from tests.support.drawings import lines_of

BEAM = """
title: Beam
axes: {i: right, j: up}
parameters: [F, a, l, W]
coordinates: [x, y, theta]
bodies:
  plate: {position: x*i + y*j + l/2*e1_plate, angle: theta, shape: {rod: [x*i + y*j, x*i + y*j + l*e1_plate]}}
constraints: {across: x = 0, up: y = 0, LAST}
forces: {load: {on: plate, at: x*i + y*j + a*e1_plate, vector: -F*j}}
find: equilibrium
"""
BOX = """
title: Box
axes: {i: right, j: up}
parameters: [b, h, P, W]
coordinates: [x, y, theta]
bodies: {block: {position: x*i + y*j, angle: theta, shape: {box: [b, h]}}}
constraints:
  left: y - h/2*cos(theta) - b/2*sin(theta) >= 0
  right: y - h/2*cos(theta) + b/2*sin(theta) >= 0
forces:
  push: {on: block, at: x*i + y*j - b/2*i + h/2*j, vector: P*i}
  weight: {on: block, vector: -W*j}
find: equilibrium
"""
YOKE = """
title: Scotch yoke
axes: {i: right, j: up}
parameters: [J, r, m]
coordinates: [phi, x]
bodies: {crank: {inertia: J, position: 0*i, angle: phi, shape: {rod: [O, r*e1_crank]}}}
particles: {yoke: {mass: m, position: x*i}}
constraints: {slot: x = r*cos(phi)}
"""


def drawn(text: str) -> tuple[Scene, dict[str, float], float]:
    system = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert system is not None
    scene = configuration_scene(system, Notation(), with_loads=True)
    assert scene is not None
    return scene, {s.name: v for s, v in system.pose.values.items()}, system.page.scale


def levels(scene: Scene) -> list[tuple[float, float]]:
    """The middles of the pieces of ground."""
    grounds = [line.points for line in lines_of(scene, StrokeKind.GROUND)]
    return [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in grounds]


def test_a_beam_stands_on_a_pin_and_a_roller() -> None:
    scene, number, scale = drawn(BEAM.replace("LAST", "roller: y + l*sin(theta) = 0"))
    left, right = sorted(levels(scene))
    assert left[0] == pytest.approx(0, abs=1e-6)
    assert right[0] == pytest.approx(number["l"] * scale)
    assert left[1] == right[1] < -0.3
    closed = [line for line in lines_of(scene, StrokeKind.BODY) if line.closed]
    assert {3, 48} <= {len(line.points) for line in closed}  # a wedge and a roller


def test_a_beam_that_is_kept_from_turning_is_built_into_a_wall() -> None:
    scene, _, _ = drawn(BEAM.replace("LAST", "clamp: theta = 0"))
    [wall] = lines_of(scene, StrokeKind.GROUND)
    assert all(abs(x) < 1e-6 for x, _ in wall.points)
    hatches = [line.points[1][0] for line in lines_of(scene, StrokeKind.HATCH)]
    assert max(hatches) < 0  # the beam is on the other side


def test_a_box_stands_on_the_ground_and_is_pushed_from_outside() -> None:
    scene, number, scale = drawn(BOX)
    [ground] = lines_of(scene, StrokeKind.GROUND)
    bottom = (number["y"] - number["h"] / 2) * scale
    assert [y for _, y in ground.points] == pytest.approx([bottom, bottom])
    tips = [line.points[-1] for line in lines_of(scene, StrokeKind.FORCE)]
    corner = (number["x"] - number["b"] / 2) * scale, (number["y"] + number["h"] / 2) * scale
    assert min(math.dist(tip, corner) for tip in tips) < 1e-6


def test_the_pin_of_a_crank_slides_in_the_slot_of_a_yoke() -> None:
    scene, number, scale = drawn(YOKE)
    pin = number["r"] * math.cos(number["phi"]) * scale, number["r"] * math.sin(number["phi"]) * scale
    boxes = [line.points for line in lines_of(scene, StrokeKind.BODY) if len(line.points) == 4]
    [slot] = [b for b in boxes if min(y for _, y in b) < 0 < pin[1] < max(y for _, y in b)]
    assert sum(x for x, _ in slot) / 4 == pytest.approx(pin[0])
    assert not lines_of(scene, StrokeKind.ROD)
