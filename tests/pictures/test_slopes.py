"""The angle of an incline at its foot."""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.document.math_writer import Notation
from lagrange.document.scene import Scene, StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import system_in_file

DOWN = (
    "parameters: {m: positive, R: positive, alpha: acute, g: positive}\ncoordinates: [x, theta]\n"
    "bodies: {cylinder: {mass: m, inertia: m*R^2/2, position: x*i + R*j, angle: -theta}}\n"
    "constraints: {rolling: x' = R*theta'}\n"
)


def of_file(text: str) -> Scene:
    system = system_in_file(kinematics_and_law(lagrange.loads(f"title: A cylinder rolls down a plane\n{text}")))
    assert system is not None
    scene = configuration_scene(system, Notation(), with_loads=False)
    assert scene is not None
    return scene


def slope(scene: Scene) -> float:
    [ground] = [line.points for line in scene.lines if line.kind is StrokeKind.GROUND]
    return abs(math.atan2(ground[1][1] - ground[0][1], ground[1][0] - ground[0][0]))


def test_a_cylinder_on_an_incline_has_the_angle_at_its_foot() -> None:
    scene = of_file(DOWN + "gravity: g*sin(alpha)*i - g*cos(alpha)*j\n")
    foot = min((p for line in scene.lines if line.kind is StrokeKind.GROUND for p in line.points), key=lambda p: p[1])
    level = [
        line.points
        for line in scene.lines
        if line.kind is StrokeKind.REFERENCE and any(math.dist(p, foot) < 1e-9 for p in line.points)
    ]
    assert len(level) == 1
    assert level[0][0][1] == pytest.approx(level[0][1][1])
    assert 0.1 < min(slope(scene), math.pi - slope(scene)) < 1.4
    assert any("alpha" in str(label.content) for label in scene.labels)


def test_a_level_plane_has_none() -> None:
    scene = of_file(DOWN.replace("R*j,", "R*cos(alpha)^2*j + R*sin(alpha)^2*j,") + "gravity: -g*j\n")
    assert not any("alpha" in str(label.content) for label in scene.labels)
