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
from tests.support.drawings import lines_of, sketched

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


# Round parts, and what several bodies stand on


ROUND = "axes: {i: right, j: up}\nparameters: {m: positive, R: positive, h: positive, alpha: acute, mu: positive, g: positive, W: positive, P: positive}\n"
HOOP = ROUND + (
    "coordinates: [x, y, q]\nbodies: {hoop: {mass: m, inertia: m*R^2, position: x*i + y*j, angle: -q}}\n"
    "constraints: {slope: {equation: y >= R, reaction: N}}\ngravity: -g*sin(alpha)*i - g*cos(alpha)*j\n"
).replace("{i: right, j: up}", "{i: up the slope, j: normal to it}")
HEMISPHERE = ROUND + (
    "coordinates: [x, y, phi]\nlet: {n: -sin(alpha)*i + cos(alpha)*j, C: r_B + 3/8*R*e2_B}\n"
    "bodies: {B: {position: x*i + y*j, angle: phi, inertia: 0}}\n"
    'constraints: {plane: {equation: "dot(C, n) >= R", reaction: N}}\n'
    "forces:\n  weight: {on: B, vector: -W*j}\n"
    "  rub: {friction: mu, static: mu, constraint: plane, on: B, at: C - R*n}\nfind: equilibrium\n"
)
KERB = ROUND + (
    "coordinates: [x, y, q]\nbodies: {wheel: {inertia: 0, position: x*i + y*j, angle: q, shape: {disc: R}}}\n"
    "constraints:\n  kerb: {equation: norm(r_wheel - h*j) >= R, reaction: S}\n  floor: {equation: y >= R, reaction: N}\n"
    "forces: {weight: {on: wheel, vector: -W*j}, pull: {on: wheel, vector: P*i}}\nfind: equilibrium\n"
)
LADDERS = (
    "axes: {i: right, j: up}\nparameters: [m, l, g]\ncoordinates: [h, q]\ngravity: -g*j\nbodies:\n"
    "  left: {mass: m, inertia: m*l^2/12, position: -l/2*cos(q)*i + (h + l/2*sin(q))*j, angle: q}\n"
    "  right: {mass: m, inertia: m*l^2/12, position: l/2*cos(q)*i + (h + l/2*sin(q))*j, angle: -q}\n"
    "constraints: {floor: {equation: h >= 0, reaction: N}}\n"
)


def outline(scene: Scene) -> list[tuple[float, float]]:
    """The points of the largest filled outline."""
    return list(max((line for line in scene.lines if line.closed), key=lambda line: len(line.points)).points)


def off_ground(scene: Scene, points: list[tuple[float, float]]) -> list[float]:
    """The distances of points from the only ground, positive above it."""
    [(start, end)] = [line.points for line in lines_of(scene, StrokeKind.GROUND)]
    way = ((end[0] - start[0]) / math.dist(start, end), (end[1] - start[1]) / math.dist(start, end))
    return [abs((x - start[0]) * way[1] - (y - start[1]) * way[0]) for x, y in points]


@pytest.mark.parametrize(("title", "text"), [("A hoop on a slope", HOOP), ("A hemisphere on an incline", HEMISPHERE)])
def test_what_is_round_touches_its_plane(title: str, text: str) -> None:
    scene = sketched(title, text)
    distances = off_ground(scene, outline(scene))
    assert min(distances) < 0.02
    assert max(distances) > 1.0


def test_a_hemisphere_is_half_a_disc_around_its_mass_centre() -> None:
    points = outline(sketched("A hemisphere on an incline", HEMISPHERE))
    widest = max(math.dist(a, b) for a in points for b in points)
    middle = tuple((points[0][n] + points[-1][n]) / 2 for n in range(2))
    assert math.dist(points[0], points[-1]) == pytest.approx(widest)
    assert max(math.dist(middle, p) for p in points) == pytest.approx(widest / 2)


def test_a_wheel_touches_the_edge_of_a_kerb() -> None:
    scene = sketched("A wheel before a kerb", KERB)
    rim = outline(scene)
    centre = (sum(x for x, _ in rim) / len(rim), sum(y for _, y in rim) / len(rim))
    [step] = [line.points for line in lines_of(scene, StrokeKind.GROUND) if len(line.points) > 2]
    radius = math.dist(centre, rim[0])
    assert min(abs(math.dist(centre, p) - radius) for p in step) < 1e-3
    assert all(math.dist(centre, p) > radius - 1e-3 for p in step)


def test_a_kerb_is_hatched_inside_and_below_the_centre() -> None:
    scene = sketched("A wheel before a kerb", KERB)
    rim = outline(scene)
    x, y = (sum(p[n] for p in rim) / len(rim) for n in range(2))
    [foot, edge, far] = next(line.points for line in lines_of(scene, StrokeKind.GROUND) if len(line.points) == 3)
    assert foot[1] < edge[1] < y
    assert x < edge[0] < far[0]  # the wheel is pulled towards it; to the right of the way up is inside


def test_a_ball_rolls_off_an_edge() -> None:
    text = ROUND + (
        "coordinates: [r, q, p]\ngravity: -g*j\nbodies: {ball: {mass: m, inertia: 2/5*m*R^2, angle: -p,\n"
        "  position: r*sin(q)*i + r*cos(q)*j}}\nconstraints:\n  edge: {equation: r >= R, reaction: N}\n"
        "  rolling: {equation: \"q' - p' = 0\", reaction: F}\ngeneralized_coordinates: {angle: {coordinates: [q]}}\n"
    )
    scene = sketched("A ball on an edge", text)
    [points] = [line.points for line in lines_of(scene, StrokeKind.GROUND) if len(line.points) == 3]
    assert math.hypot(*points[1]) < 1e-6
    assert min(x for x, _ in points) < -1  # behind the ball, which has rolled to the right
    assert max(y for _, y in points) < 1e-6


def test_cylinders_in_a_pile_are_as_large_as_where_they_are_rubbed() -> None:
    text = ROUND + (
        "coordinates: [x, y, q]\nbodies: {left: {inertia: 0, position: x*i + y*j, angle: q}}\n"
        "constraints: {floor: {equation: y >= R, reaction: N}}\nfind: equilibrium\nforces:\n"
        "  weight: {on: left, vector: -W*j}\n"
        "  rub: {friction: mu, static: mu, constraint: floor, on: left, at: r_left - R*j}\n"
    )
    scene = sketched("One of three cylinders", text)
    distances = off_ground(scene, outline(scene))
    assert min(distances) < 0.02
    assert max(distances) > 1.0


def test_several_bodies_stand_on_one_floor() -> None:
    scene = sketched("A step ladder", LADDERS)
    feet = [min(line.points, key=lambda p: p[1]) for line in scene.lines if line.closed]
    assert len(feet) == 2
    assert all(d < 0.15 for d in off_ground(scene, feet))


def test_no_ground_where_two_bodies_touch() -> None:
    text = ROUND + (
        "coordinates: [x, u, p, q]\nbodies:\n  A: {mass: m, inertia: m*R^2/2, position: x*i + R*j, angle: p}\n"
        "  B: {mass: m, inertia: m*R^2/2, position: u*i + R*j, angle: q}\n"
        "constraints: {touch: {equation: u - x >= 2*R, reaction: N}}\n"
    )
    assert lines_of(sketched("Two discs", text), StrokeKind.GROUND) == []


def test_a_thread_comes_off_the_hub_of_a_spool() -> None:
    text = ROUND + (
        "let: {u: cos(alpha)*i + sin(alpha)*j, n: sin(alpha)*i - cos(alpha)*j}\ncoordinates: [x, y, q]\n"
        "bodies: {spool: {mass: m, inertia: 3*m*h^2, position: x*i + y*j, angle: -q}}\ngravity: -g*j\n"
        "constraints: {floor: {equation: y >= R, reaction: N}, rolling: {equation: \"x' - R*q' = 0\", reaction: f}}\n"
        "forces: {thread: {on: spool, vector: P*u, at: r_spool + R/2*n}}\n"
    )
    scene = sketched("A spool", text)
    [thread] = lines_of(scene, StrokeKind.STRING)
    (x, y), (u, v) = thread.points
    circles = [line.points for line in scene.lines if line.closed and len(line.points) == 48]
    hub, rim = sorted(circles, key=lambda c: max(p[0] for p in c) - min(p[0] for p in c))
    centre = (sum(p[0] for p in hub) / 48, sum(p[1] for p in hub) / 48)
    assert math.dist(centre, (x, y)) == pytest.approx(math.dist(centre, hub[0]))
    assert abs((u - x) * (x - centre[0]) + (v - y) * (y - centre[1])) < 1e-6  # a tangent
    assert math.dist(centre, rim[0]) == pytest.approx(2 * math.dist(centre, hub[0]))
    assert math.dist(centre, (u, v)) > math.dist(centre, rim[0])


def test_a_ladder_that_cannot_move_stands_on_ground_and_not_on_a_hinge() -> None:
    text = (
        "parameters: {l: positive, W: positive, alpha: acute}\ncoordinates: [x, y, theta]\n"
        "bodies: {ladder: {position: (x - l/2*cos(theta))*i + (y + l/2*sin(theta))*j, angle: -theta}}\n"
        "constraints:\n  ground: {equation: y >= 0, reaction: N}\n"
        '  wall: {equation: "x - l*cos(theta) >= 0", reaction: H}\n  lean: theta = alpha\n'
        "forces: {weight: {on: ladder, vector: -W*j}}\nfind: equilibrium\n"
    )
    scene = sketched("A ladder at a wall", text)
    grounds = lines_of(scene, StrokeKind.GROUND)
    assert len(grounds) == 2
    assert not any(dot.open for dot in scene.dots)
