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
from tests.support.drawings import lines_of, sketched

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
    [name] = [label for label in scene.labels if str(label.content) == "M"]
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


# What carries something else


def faces(scene: Scene) -> list[tuple[tuple[float, float], ...]]:
    return [line.points for line in scene.lines if line.closed]


CUT = (
    "axes: {i: right, j: up}\nparameters: [m, M, R, g]\ncoordinates: [X, x, y]\ngravity: -g*j\n"
    "particles: {block: {mass: M, position: X*i}, P: {mass: m, position: x*i + y*j}}\n"
    "constraints: {cut: {equation: (x - X)^2 + y^2 <= R^2, reaction: N, by: surface}}\n"
    "generalized_coordinates: {angle: {coordinates: [X, q], substitute: {x: X - R*cos(q), y: -R*sin(q)}}}\n"
)


def test_a_hollow_in_a_block_is_no_rod() -> None:
    scene = sketched("A block with a circular cut", CUT)
    assert lines_of(scene, StrokeKind.ROD) == []
    block = max(faces(scene), key=len)
    particle = min(scene.dots, key=lambda d: d.at[1]).at
    assert min(math.dist(particle, p) for p in block) < 0.3
    [ground] = lines_of(scene, StrokeKind.GROUND)
    assert ground.points[0][1] == pytest.approx(min(y for _, y in block))


def test_two_faces_make_one_wedge_on_one_ground() -> None:
    text = (
        "axes: {i: right, j: up}\nparameters: {M: positive, m: positive, L: positive, g: positive, alpha: acute, beta: acute}\n"
        "coordinates: [X, s, u]\ngravity: -g*j\nparticles:\n  wedge: {mass: M, position: X*i}\n"
        "  A: {mass: m, position: X*i - s*(cos(alpha)*i + sin(alpha)*j)}\n"
        "  B: {mass: m, position: X*i + u*(cos(beta)*i - sin(beta)*j)}\n"
        "constraints: {string: {equation: s + u = L, reaction: T}}\n"
    )
    scene = sketched("Two blocks on a wedge", text)
    [wedge] = [face for face in faces(scene) if len(face) == 3]
    [ground] = lines_of(scene, StrokeKind.GROUND)
    low = min(y for _, y in wedge)
    assert sum(abs(y - low) < 1e-6 for _, y in wedge) == 2
    assert ground.points[0][1] == pytest.approx(low)


@pytest.mark.parametrize(("name", "boards"), [("plank", 1), ("stone", 0)])
def test_a_plank_lies_under_what_moves_on_it(name: str, boards: int) -> None:
    text = (
        "axes: {i: right, j: up}\nparameters: [m, M, F]\ncoordinates: [X, s]\n"
        f"particles: {{{name}: {{mass: M, position: X*i}}, man: {{mass: m, position: (X + s)*i}}}}\n"
        f"forces: {{feet: {{on: man, vector: F*i}}, back: {{on: {name}, vector: -F*i}}}}\n"
    )
    scene = sketched("Walking on ice", text)
    assert len(faces(scene)) == boards
    if boards:
        [board] = faces(scene)
        [man] = [d.at for d in scene.dots if not d.open]
        assert min(x for x, _ in board) < man[0] < max(x for x, _ in board)
        assert 0 <= man[1] - max(y for _, y in board) < 0.1


@pytest.mark.parametrize(("name", "grounds"), [("car", 1), ("boat", 0)])
def test_a_vehicle_stands_on_a_road(name: str, grounds: int) -> None:
    text = f"parameters: [m, F]\ncoordinates: [x]\nparticles: {{{name}: {{mass: m, position: x*i}}}}\n"
    text += f"forces: {{pull: {{on: {name}, vector: F*i}}}}\n"
    assert len(lines_of(sketched("Motion", text), StrokeKind.GROUND)) == grounds


@pytest.mark.parametrize(("title", "grounds"), [("A rod slides between a wall and a floor", 2), ("A rod moves", 0)])
def test_a_rod_that_coordinates_keep_in_a_corner_touches_wall_and_floor(title: str, grounds: int) -> None:
    text = (
        "axes: {i: right, j: up}\nparameters: [m, l, g]\ncoordinates: [q]\ngravity: -g*j\nbodies:\n"
        "  rod: {mass: m, inertia: m*l^2/3, position: l*cos(q)*i + l*sin(q)*j, angle: -q}\n"
    )
    assert len(lines_of(sketched(title, text), StrokeKind.GROUND)) == grounds


def test_a_raft_has_no_ground_and_a_cylinder_rolls_on_top_of_its_plank() -> None:
    raft = (
        "parameters: [m, M, F]\ncoordinates: [X, s]\nparticles: {raft: {mass: M, position: X*i}, "
        "child: {mass: m, position: (X + s)*i}}\nforces: {feet: {on: child, vector: F*i}}\n"
    )
    assert lines_of(sketched("A child runs", raft), StrokeKind.GROUND) == []
    plank = (
        "axes: {i: right, j: up}\nparameters: [m, M, R, F, g]\ncoordinates: [x, y, q, X]\ngravity: -g*j\n"
        "bodies: {cylinder: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: -q}}\n"
        "particles: {plank: {mass: M, position: X*i}}\nforces: {pull: {on: plank, vector: F*i}}\n"
        "constraints: {contact: {equation: y >= R, reaction: N}, "
        "rolling: {equation: \"x' - R*q' = X'\", reaction: f}}\n"
    )
    scene = sketched("A cylinder on a plank on a floor", plank)
    [board] = [face for face in faces(scene) if len(face) == 4]
    [ground] = lines_of(scene, StrokeKind.GROUND)
    assert ground.points[0][1] == pytest.approx(min(y for _, y in board))
    rim = max((line.points for line in scene.lines if line.closed), key=len)
    assert min(y for _, y in rim) == pytest.approx(max(y for _, y in board), abs=0.02)


def test_two_slopes_end_at_their_ridge() -> None:
    text = (
        "axes: {i: right, j: up}\nparameters: {W: positive, Q: positive, alpha: acute, beta: acute, L: positive}\n"
        "coordinates: [s, u, n, v]\nparticles:\n"
        '  A: {position: "-s*(cos(alpha)*i + sin(alpha)*j) + n*(-sin(alpha)*i + cos(alpha)*j)"}\n'
        '  B: {position: "u*(cos(beta)*i - sin(beta)*j) + v*(sin(beta)*i + cos(beta)*j)"}\n'
        "constraints:\n  one: {equation: n >= 0, reaction: N}\n  two: {equation: v >= 0, reaction: R}\n"
        "  cord: {equation: s + u = L, reaction: T}\n"
        "forces: {W: {on: A, vector: -W*j}, Q: {on: B, vector: -Q*j}}\nfind: equilibrium\n"
    )
    scene = sketched("Two blocks", text)
    first, second = (line.points for line in lines_of(scene, StrokeKind.GROUND) if math.dist(*line.points) > 1.5)
    assert min(math.dist(a, b) for a in first for b in second) < 1e-6


def test_the_weight_of_a_block_on_a_plane_points_down() -> None:
    text = (
        "axes: {i: up the slope, j: normal to it}\nparameters: {W: positive, mu: positive, alpha: acute}\n"
        "coordinates: [x, y]\nparticles: {block: {position: x*i + y*j}}\n"
        "constraints: {plane: {equation: y >= 0, reaction: N}}\n"
        "forces:\n  weight: {on: block, vector: -W*sin(alpha)*i - W*cos(alpha)*j}\n"
        "  rub: {friction: mu, static: mu, constraint: plane, on: block, slip: -i}\nfind: equilibrium\n"
    )
    system = system_in_file(kinematics_and_law(lagrange.loads(f"title: A block\n{text}")))
    assert system is not None
    assert system.down is not None
    x, y = system.page.way(system.pose.at(system.down))
    assert abs(x) < 1e-9 > y
