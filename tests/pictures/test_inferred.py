"""What the coordinates alone show: rods, hoops, strings over pulleys, pivots, rails."""

from __future__ import annotations

import pytest

import lagrange
from lagrange.document.math_writer import Notation
from lagrange.document.scene import Scene, StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import system_in_file
from tests.support.drawings import lines_of, sketched

HEAD = "axes: {i: right, j: down}\ngravity: g*j\n"
CIRCLE = "parameters: [m, l, g]\ncoordinates: [q]\nparticles: {P: {mass: m, position: l*sin(q)*i + l*cos(q)*j}}\n"
TWO = (
    "parameters: [m, l, d, g, c]\ncoordinates: [q, s]\nparticles:\n"
    "  A: {mass: m, position: l*sin(q)*i + l*cos(q)*j}\n  B: {mass: m, position: (d + l*sin(s))*i + l*cos(s)*j}\n"
    'forces: {spring: {spring: c, between: ["r_A/2", "(r_B + d*i)/2"], length: d}}\n'
)
STRING = (
    "parameters: [m, M, L, d, g]\ncoordinates: [x, y]\nparticles:\n  A: {mass: m, position: x*j}\n"
    "  B: {mass: M, position: d*i + y*j}\nconstraints: {string: {equation: x + y = L, by: string}}\n"
)
LEVER = (
    "parameters: [I, a, m, g]\ncoordinates: [q]\nbodies:\n  plank: {inertia: I, position: 0*i, angle: q, "
    'shape: {rod: ["-a*cos(q)*i - a*sin(q)*j", "a*cos(q)*i + a*sin(q)*j"]}}\n'
    'particles: {P: {mass: m, position: "a*cos(q)*i + a*sin(q)*j"}}\n'
)
CART = (
    "parameters: [m, M, l, g]\ncoordinates: [x, q]\nparticles:\n"
    "  cart: {mass: M, position: x*i, shape: {box: [1, 0.5]}}\n"
    "  P: {mass: m, position: (x + l*sin(q))*i + l*cos(q)*j}\n"
)


def drawn(title: str, text: str) -> Scene:
    system = system_in_file(kinematics_and_law(lagrange.loads(f"title: {title}\n{HEAD}{text}")))
    assert system is not None
    scene = configuration_scene(system, Notation(), with_loads=False)
    assert scene is not None
    return scene


def lines(scene: Scene, kind: StrokeKind) -> int:
    return sum(line.kind is kind for line in scene.lines)


@pytest.mark.parametrize(
    ("title", "rods", "strings", "curves"),
    [
        ("Pendulum", 1, 0, 0),
        ("Pendulum with a string", 0, 1, 0),
        ("Stone on a string", 0, 1, 0),
        ("Bead on a hoop", 0, 0, 1),
        ("Circular motion", 0, 0, 1),
    ],
)
def test_what_keeps_a_distance_is_what_the_text_says(title: str, rods: int, strings: int, curves: int) -> None:
    scene = drawn(title, CIRCLE)
    found = [lines(scene, k) for k in (StrokeKind.ROD, StrokeKind.STRING, StrokeKind.CURVE)]
    assert found == [rods, strings, curves]
    assert sum(d.open for d in scene.dots) == rods + strings  # the pivot


def test_no_support_where_the_end_of_a_spring_moves() -> None:
    scene = drawn("Two pendulums", TWO)
    assert lines(scene, StrokeKind.ROD) == 2
    assert sum(d.open for d in scene.dots) == 2  # the pivots, and not the ends of the spring on the rods


def test_a_string_runs_over_pulleys() -> None:
    assert lines(drawn("Two weights", STRING), StrokeKind.STRING) == 3


def test_a_lever_stands_on_a_wedge() -> None:
    assert any(line.closed and len(line.points) == 3 for line in drawn("Seesaw", LEVER).lines)


def test_the_rail_has_a_gap_for_the_rod() -> None:
    scene = drawn("Pendulum on a cart", CART)
    assert lines(scene, StrokeKind.ROD) == 1
    assert lines(scene, StrokeKind.GROUND) == 2


def test_a_path_is_drawn_where_one_coordinate_moves_a_bead() -> None:
    text = 'parameters: [m, a, g]\ncoordinates: [x]\nparticles: {P: {mass: m, position: "x*i - x^2/a*j"}}\n'
    assert lines(drawn("Slide", text), StrokeKind.CURVE) == 1


def test_a_wide_tackle_has_two_fixed_pulleys() -> None:
    text = STRING.replace("x + y = L", "2*x + y = L").replace("d*i", "5*d*i")
    assert lines(drawn("Two weights", text), StrokeKind.STRING) == 4
    assert sum(d.open for d in drawn("Two weights", text).dots) == 3


def test_a_weightless_beam_is_a_rod_from_its_hinge() -> None:
    beam = "parameters: [l, P, g]\ncoordinates: [q]\nparticles: {B: {position: l*cos(q)*i + l*sin(q)*j}}\n"
    scene = drawn("A hinged beam", beam + "forces: {load: {on: B, vector: P*j}}\nfind: equilibrium\n")
    assert lines(scene, StrokeKind.ROD) == 1


BOOM = (
    "parameters: [m, M, a, h, L, g]\ncoordinates: [q, y]\nparticles:\n  A: {mass: m, position: a*sin(q)*i - a*cos(q)*j}\n"
    "  B: {mass: M, position: OFFSET*i + (y - h)*j}\nconstraints:\n"
    '  rope: {equation: "y + sqrt(a^2 + h^2 - 2*a*h*cos(q)) = L", by: string}\n'
)


@pytest.mark.parametrize(("offset", "circles"), [("0", 1), ("(0.2)", 1), ("(-1.5)", 2)])
def test_a_rope_to_a_boom_runs_over_the_place_from_which_its_length_counts(offset: str, circles: int) -> None:
    scene = drawn("Rod on a rope", BOOM.replace("OFFSET", offset))
    strings = [line for line in scene.lines if line.kind is StrokeKind.STRING]
    assert len(strings) == 2 * circles


def test_a_root_that_is_no_distance_is_no_rope() -> None:
    scene = drawn("Rod on a rope", BOOM.replace("OFFSET", "0").replace("2*a*h*cos(q)", "a*h*cos(q)"))
    assert not lines(scene, StrokeKind.STRING)


BOWL = (
    "parameters: [m, l, R, g]\ncoordinates: [q]\nlet: {h: sqrt(R^2 - l^2)}\nbodies:\n  rod: {mass: m, inertia: m*l^2/3, "
    'position: "h*(sin(q)*i + cos(q)*j)", angle: -q, shape: {rod: [r_rod - l*e1_rod, r_rod + l*e1_rod]}}\n'
)


def test_a_rod_that_slides_in_a_bowl_hangs_on_nothing() -> None:
    scene = drawn("Rod in a bowl", BOWL)
    assert lines(scene, StrokeKind.CURVE) == 1
    assert not any(d.open for d in scene.dots)
    assert not lines(drawn("Rod", BOWL), StrokeKind.CURVE)


TURNING = (
    "axes: {k: up}\ngravity: -g*k\nparameters: [m, J, R, g]\ncoordinates: [q, p]\nlet: {out: cos(p)*i + sin(p)*j}\n"
    "particles: {bead: {mass: m, position: R*sin(q)*out - R*cos(q)*k}}\n"
    "bodies: {hoop: {mass: 0, inertia: [J, J, J], position: 0*k, orientation: {axes: 313, angles: [p, 0, 0]}}}\n"
)


def test_a_hoop_that_turns_is_the_circle_of_its_bead() -> None:
    system = system_in_file(kinematics_and_law(lagrange.loads(f"title: Bead on a hoop\n{TURNING}")))
    assert system is not None
    scene = configuration_scene(system, Notation(), with_loads=False)
    assert scene is not None
    assert lines(scene, StrokeKind.CURVE) == 1
    assert not lines(scene, StrokeKind.BODY)


@pytest.mark.parametrize(("name", "strings"), [("string", 1), ("track", 0)])
def test_a_one_sided_string_is_a_string_and_no_track(name: str, strings: int) -> None:
    text = (
        "parameters: [m, l, g]\ncoordinates: [rho, q]\n"
        "particles: {P: {mass: m, position: rho*sin(q)*i + rho*cos(q)*j}}\n"
        f"constraints: {{{name}: {{equation: rho <= l, reaction: T}}}}\n"
    )
    scene = drawn("A stone", text)
    assert lines(scene, StrokeKind.STRING) == strings
    arcs = [line for line in scene.lines if line.kind is StrokeKind.GROUND and len(line.points) > 2]
    assert bool(arcs) is not bool(strings)


def test_a_straight_wire_that_turns_in_space_is_drawn() -> None:
    text = (
        "axes: {k: up}\nparameters: {m: positive, g: positive, w: positive, alpha: acute}\ncoordinates: [r]\n"
        "gravity: -g*k\nlet: {u: sin(alpha)*cos(w*t)*i + sin(alpha)*sin(w*t)*j + cos(alpha)*k}\n"
        "particles: {bead: {mass: m, position: r*u}}\n"
    )
    assert len(lines_of(sketched("A bead slides on a straight wire", text), StrokeKind.ROD)) == 1
    assert lines_of(sketched("A bead", text), StrokeKind.ROD) == []


def test_both_links_of_a_toggle_are_drawn() -> None:
    """B is at a constant distance from C, but does not turn with it about O: no frame."""
    text = (
        "axes: {i: right, j: up}\nparameters: [l, W, k]\ncoordinates: [q]\n"
        "particles: {B: {position: [l*cos(q), l*sin(q)]}, C: {position: [2*l*cos(q), 0]}}\n"
        "forces: {load: {on: B, vector: [0, -W]}, spring: {spring: k, between: [0*i, C], length: l, sense: positive}}\n"
        "find: equilibrium\n"
    )
    assert len(lines_of(sketched("Two links", text), StrokeKind.ROD)) == 2


OVER = (
    "parameters: [m, M, a, L, g]\ncoordinates: [q, y]\nparticles:\n  P: {mass: m, position: a*sin(q)*i - a*cos(q)*j}\n"
    "  load: {mass: M, position: OFFSET*i + y*j}\nconstraints:\n"
    '  string: {equation: "y + a*(pi/2 - q) = L"}\n'
)


@pytest.mark.parametrize(("offset", "strings"), [("a", 1), ("2*a", 0)])
def test_a_string_lies_on_a_cylinder_and_leaves_it_straight(offset: str, strings: int) -> None:
    """From the particle over the cylinder to the load, where that hangs on its side."""
    scene = drawn("Particle on a cylinder", OVER.replace("OFFSET", offset))
    found = [line for line in scene.lines if line.kind is StrokeKind.STRING]
    assert len(found) == strings
    for line in found:
        assert line.points[-1][1] < min(y for _, y in line.points[:-1])  # the load is lowest


def test_a_bent_arm_is_no_ellipse() -> None:
    text = (
        "parameters: [m, I, b, h, c, g]\ncoordinates: [q, x, y]\nbodies:\n"
        "  NAME: {mass: m, inertia: I, position: 0*i, angle: q}\n"
        "particles: {P: {mass: m, position: x*i + y*j}}\nconstraints:\n"
        '  one: {equation: "dot(r_NAME + b*e1_NAME + h*e2_NAME - r_P, r_NAME + b*e1_NAME + h*e2_NAME - r_P) = c^2"}\n'
        "forces: {s: {spring: m*g/c, between: [r_NAME + b*e1_NAME - h*e2_NAME, 3*i], length: c}}\n"
    )
    capsules, ellipse = (
        [line for line in drawn("Two bodies", text.replace("NAME", name)).lines if line.closed] for name in ("arm", "Q")
    )
    assert len(capsules) > len(ellipse)
