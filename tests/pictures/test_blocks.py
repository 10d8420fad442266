"""Blocks, and what they slide on as far as the text says.

The angle of an incline at its foot.
"""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.document.names import Notation
from lagrange.document.scene import Scene, StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import system_in_file
from tests.pictures.test_inferred import drawn, lines

ONE = "parameters: [m, k, a, g]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"
SPRING = ONE + "forces: {s: {spring: k, between: [[-a, 0], P], length: a}}\n"
FALL = "parameters: [m, g]\ncoordinates: [y]\nparticles: {P: {mass: m, position: y*j}}\n"
EDGE = (
    "parameters: [m, M, L, g]\ncoordinates: [x, y]\nparticles:\n  A: {mass: m, position: -x*i}\n"
    "  B: {mass: M, position: y*j}\nconstraints: {string: {equation: x + y = L, by: string}}\n"
)
LADDER = (
    "parameters: [m, l, g]\ncoordinates: [x, y]\nparticles: {A: {mass: m, position: x*i}, B: {mass: m, position: -y*j}}\n"
    "constraints: {ladder: {equation: x^2 + y^2 = l^2, by: rod}}\n"
)


def boxes(scene: Scene) -> list[tuple[float, float]]:
    """The lower sides of filled rectangles: left end and height."""
    found = [line.points for line in scene.lines if line.closed and len(line.points) == 4]
    return [(min(x for x, _ in p), min(y for _, y in p)) for p in found]


@pytest.mark.parametrize(
    ("title", "text", "block", "grounds"),
    [
        ("A block on a table", ONE, 1, 1),
        ("A particle on a table", ONE, 0, 1),
        ("A particle in one plane", ONE, 0, 0),
        ("A block falls to the ground", FALL, 1, 0),
        ("A ladder against a wall", LADDER, 0, 2),
    ],
)
def test_the_words_tell_what_is_drawn(title: str, text: str, block: int, grounds: int) -> None:
    scene = drawn(title, text)
    assert (len(boxes(scene)), lines(scene, StrokeKind.GROUND)) == (block, grounds)


def test_a_block_stands_on_its_ground_and_its_spring_ends_at_its_side() -> None:
    scene = drawn("A cart on a rail", SPRING)
    [(left, low)] = boxes(scene)
    [spring] = [line for line in scene.lines if line.kind is StrokeKind.SPRING]
    assert abs(max(x for x, _ in spring.points) - left) < 1e-9
    assert any(abs(y - low) < 1e-9 for line in scene.lines if line.kind is StrokeKind.GROUND for _, y in line.points)


def test_a_pulley_at_the_edge_is_held_by_the_table() -> None:
    scene = drawn("Block on a table, pulley", EDGE)
    [ground] = [line for line in scene.lines if line.kind is StrokeKind.GROUND]
    [bracket] = [line for line in scene.lines if line.kind is StrokeKind.LINK]
    assert lines(scene, StrokeKind.STRING) == 2
    assert (
        bracket.points[1] in ground.points
        or min(abs(bracket.points[1][0] - x) + abs(bracket.points[1][1] - y) for x, y in ground.points) < 1e-6
    )


# Slopes


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


# Carts as bodies, wedges, prisms, frames


CART_BODY = (
    "parameters: [M, m, k, c, a, l, g]\ncoordinates: [x, theta]\nbodies:\n"
    "  cart: {mass: M, inertia: 0, position: x*i, angle: 0}\n"
    "  rod: {mass: m, inertia: m*a^2/3, position: (x + a*sin(theta))*i + a*cos(theta)*j, angle: -theta}\n"
    "forces:\n  spring: {spring: k, between: [O, cart], length: l}\n  damper: {damper: c, between: [O, cart]}\n"
)
WEDGE = (
    "parameters: {M: positive, m: positive, k: positive, h: positive, l: positive, g: positive, alpha: acute}\n"
    "coordinates: [X, s]\nlet: {down: cos(alpha)*i + sin(alpha)*j, top: X*i - h*j}\nparticles:\n"
    "  wedge: {mass: M, position: X*i}\n  block: {mass: m, position: top + s*down}\n"
    "forces: {spring: {spring: k, between: [top, block], length: l}}\n"
)
PRISM = (
    "parameters: {m: positive, M: positive, L: positive, g: positive, alpha: acute, beta: acute}\ncoordinates: [x, y]\n"
    "particles:\n  A: {mass: m, position: -x*cos(alpha)*i + x*sin(alpha)*j}\n"
    "  B: {mass: M, position: y*cos(beta)*i + y*sin(beta)*j}\nconstraints: {string: {equation: x + y = L, by: string}}\n"
)
FRAME = (
    "parameters: [a, P, g]\ncoordinates: [theta]\nparticles:\n  A: {position: -a*sin(theta)*i}\n"
    "  B: {position: a*sin(theta)*i}\n  C: {position: -a*cos(theta)*j}\n"
    "forces: {load: {on: C, vector: P*j}}\nfind: equilibrium\n"
)


def test_a_cart_given_as_a_body_is_a_box_with_its_spring_and_damper_at_one_wall() -> None:
    scene = drawn("A rod on a cart on a rail", CART_BODY)
    [(left, _)] = boxes(scene)
    [wall, *ground] = sorted(
        (line.points for line in scene.lines if line.kind is StrokeKind.GROUND), key=lambda p: abs(p[0][0] - p[1][0])
    )
    assert abs(wall[0][0] - wall[1][0]) < 1e-9
    assert wall[0][0] < left
    assert len(ground) == 2  # with a gap for the rod


def test_a_wedge_reaches_down_to_its_floor_and_carries_the_end_of_its_spring() -> None:
    scene = drawn("A block on a wedge", WEDGE)
    [wedge] = [line.points for line in scene.lines if line.closed and len(line.points) == 3]
    [ground] = [line.points for line in scene.lines if line.kind is StrokeKind.GROUND]
    [name] = [label for label in scene.labels if label.content == "wedge"]
    assert min(y for _, y in wedge) == pytest.approx(ground[0][1])
    assert abs(name.at[1] - ground[0][1]) < 0.5


def test_both_faces_of_a_prism_end_at_its_pulley() -> None:
    scene = drawn("Two blocks on the slopes of a prism", PRISM)
    grounds = [line.points for line in scene.lines if line.kind is StrokeKind.GROUND]
    assert len(grounds) == 2
    assert all(min(math.hypot(*p) for p in ground) < 0.6 for ground in grounds)


def test_a_weightless_frame_stands_on_its_floor() -> None:
    scene = drawn("A stepladder on a smooth floor", FRAME)
    assert (lines(scene, StrokeKind.GROUND), lines(scene, StrokeKind.ROD)) == (1, 0)
    assert lines(drawn("A stepladder", FRAME), StrokeKind.GROUND) == 0
