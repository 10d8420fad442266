"""What can be drawn of a system, and what is left out."""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.document.names import Notation
from lagrange.document.scene import StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import system_in_file
from lagrange.render import latex
from tests.support.drawings import lines_of, scenes
from tests.support.shared import reported

LEFT_OUT = ("constraints/form-in-two-variables", "constraints/contact-form")


@pytest.mark.parametrize("name", LEFT_OUT)
def test_an_abstract_form_has_no_figure(name: str) -> None:
    assert scenes(name) == []
    assert "tikzpicture" not in latex.render([(reported(name).derivation, reported(name).notation)])


def test_a_pendulum_hangs_from_hatched_ground() -> None:
    [scene, *_] = scenes("chapter6/ex11-ideal-pendulum")
    [rod], [support] = lines_of(scene, StrokeKind.ROD), lines_of(scene, StrokeKind.GROUND)
    ends = sorted(rod.points, key=lambda p: -p[1])
    assert abs(support.points[0][1] - ends[0][1]) < 0.1
    assert all(p[1] > support.points[0][1] for stroke in lines_of(scene, StrokeKind.HATCH) for p in stroke.points[1:])


def test_an_incline_slopes_and_its_gravity_points_down() -> None:
    [scene, *_] = scenes("motion/hoop-on-incline")
    [ground] = lines_of(scene, StrokeKind.GROUND)
    (x, y), (u, v) = ground.points[0], ground.points[-1]
    assert abs(v - y) > 0.2 * abs(u - x)
    down = min(
        (line for line in lines_of(scene, StrokeKind.AXIS)), key=lambda line: abs(line.points[1][0] - line.points[0][0])
    )
    assert down.points[1][1] < down.points[0][1]


def test_a_one_sided_constraint_is_hatched_on_the_forbidden_side() -> None:
    """The wall of the bowl is outside, that of the sphere inside."""
    [bowl, *_] = scenes("motion/loop-the-loop")
    [sphere, *_] = scenes("motion/leaving-a-sphere")
    for scene, outside in ((bowl, True), (sphere, False)):
        strokes = lines_of(scene, StrokeKind.HATCH)
        circle = max(lines_of(scene, StrokeKind.GROUND), key=lambda line: len(line.points))
        radius = max(abs(p[0]) for p in circle.points)
        on_it = [s for s in strokes if abs(sum(c * c for c in s.points[0]) ** 0.5 - radius) < 0.05]
        assert len(on_it) > 20
        far = [sum(c * c for c in s.points[1]) ** 0.5 > radius for s in on_it]
        assert all(far) if outside else not any(far)


GYROSCOPE = """
title: Gyroscope
parameters: [m, a, A, C, g]
coordinates: [phi, theta, psi]
bodies: {disc: {mass: m, inertia: [A, A, C], position: a*e3_disc, orientation: {axes: 313, angles: [phi, theta, psi]}}}
gravity: -g*k
"""
ON_ROD = """
title: A disc on a rod
axes: {i: right, j: down}
parameters: [m, r, l, g]
coordinates: [theta]
bodies: {disc: {mass: m, inertia: m*r^2/2, position: l*sin(theta)*i + l*cos(theta)*j, angle: -theta}}
gravity: g*j
"""


@pytest.mark.parametrize("text", [GYROSCOPE, ON_ROD])
def test_a_disc_hangs_together_with_its_pivot(text: str) -> None:
    system = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert system is not None
    scene = configuration_scene(system, Notation(), with_loads=False)
    assert scene is not None
    [rod] = [line.points for line in scene.lines if line.kind is StrokeKind.ROD]
    assert min(math.hypot(*end) for end in rod) < 1e-9
