"""Which coordinates are drawn as angles and distances."""

from __future__ import annotations

import math

import pytest
import sympy as sp

import lagrange
from lagrange.document.names import Notation
from lagrange.document.scene import StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.poses import angle_mark, is_distance
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import system_in_file
from tests.support.drawings import CLOSE, DRAWN, lines_of, scenes, sketched, system_of
from tests.support.shared import reported


def test_angles_and_distances_are_recognised_by_what_they_do() -> None:
    system = system_of("motion/spring-pendulum")
    [point] = system.configuration.points
    r, phi = (next(q for q in system.pose.coordinates if q.name == name) for name in ("r", "phi"))
    mark = angle_mark(system.pose, phi, point.position)
    assert mark is not None
    assert math.hypot(*mark.centre) < CLOSE
    assert angle_mark(system.pose, r, point.position) is None
    assert is_distance(system.pose, r, point.position)
    assert not is_distance(system.pose, phi, point.position)
    doubled = point.position.fixed().xreplace({phi: 2 * phi})
    assert angle_mark(system.pose, phi, doubled) is None


@pytest.mark.parametrize("name", DRAWN)
def test_every_coordinate_of_a_known_problem_is_marked(name: str) -> None:
    marked = {label.content for scene in scenes(name) for label in scene.labels}
    assert set(reported(name).solution.own.configuration.slots.coordinates) - {sp.Symbol("y", real=True)} <= marked


def test_a_dumbbell_is_drawn_with_its_mass_centre_and_its_two_angles() -> None:
    """θ opens from k at C towards P2, and φ lies in the horizontal plane of C, not of O."""
    choice = scenes("chapter6/ex04-dumbbell")[-1]
    at = {str(label.content): label.at for label in choice.labels}
    assert {"x_C", "y_C", "z_C", "theta", "phi", "C"} <= set(at)
    assert at["P₂"][1] > at["theta"][1] > at["phi"][1] > at["z_C"][1]


TRAMMEL = """
title: A rod in two slots
axes: {i: right, j: up}
parameters: [m, l, g]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: m*l^2/12, position: x/2*i + y/2*j, angle: theta}}
particles: {A: {position: y*j}, B: {position: x*i}}
constraints: {across: x = l*sin(theta), along: y = l*cos(theta)}
gravity: -g*j
"""


ON_FLOOR = """
title: A rod on a floor
axes: {i: right, j: up}
parameters: [m, a, g]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: m*a^2/3, position: x*i + y*j, angle: -theta}}
particles: {A: {position: (x - a*sin(theta))*i + (y - a*cos(theta))*j}, B: {position: x*i + y*j}}
constraints: {floor: y - a*cos(theta) = 0}
gravity: -g*j
"""


@pytest.mark.parametrize("text", [TRAMMEL, ON_FLOOR])
def test_the_angle_of_a_rod_ends_on_the_rod(text: str) -> None:
    system = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert system is not None
    scene = configuration_scene(system, Notation(), with_loads=False)
    assert scene is not None
    [arc] = [line.points for line in scene.lines if line.kind is StrokeKind.ANGLE and len(line.points) > 2]
    places = {p.name: system.page(system.pose.at(p.position)) for p in system.configuration.points}
    (a, b), end = (places["A"], places["B"]), arc[-1]
    assert abs((b[0] - a[0]) * (end[1] - a[1]) - (b[1] - a[1]) * (end[0] - a[0])) < 1e-6


def test_a_distance_from_the_top_of_a_slope_begins_there() -> None:
    wedge = """title: Block on a wedge
axes: {i: right, j: up}
gravity: -g*j
parameters: [m, M, alpha, h, g]
coordinates: [X, s]
particles:
  wedge: {mass: M, position: X*i}
  block: {mass: m, position: (X + s*cos(alpha))*i + (h - s*sin(alpha))*j}
"""
    system = system_in_file(kinematics_and_law(lagrange.loads(wedge)))
    assert system is not None
    scene = configuration_scene(system, Notation(), with_loads=False)
    assert scene is not None
    assert {sp.Symbol("X", real=True), sp.Symbol("s", real=True)} <= {label.content for label in scene.labels}


def test_the_angle_of_a_spring_whose_length_changes_with_it_is_marked_at_its_fixed_end() -> None:
    text = (
        "parameters: [W, k, R]\ncoordinates: {theta: {range: [-80 deg, 80 deg]}}\n"
        "particles: {collar: {position: 2*R*cos(theta)*(sin(theta)*i - cos(theta)*j)}}\n"
        "forces:\n  weight: {on: collar, vector: -W*j}\n  spring: {spring: k, between: [O, collar], length: R}\n"
        "find: equilibrium\n"
    )
    scene = sketched("A collar on a hoop", text)
    assert "theta" in {str(label.content) for label in scene.labels}
    assert any(len(line.points) > 50 for line in lines_of(scene, StrokeKind.CURVE))  # the hoop
