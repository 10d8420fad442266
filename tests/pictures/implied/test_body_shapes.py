"""Shapes of bodies inferred from their moments of inertia, and from what they are called."""

from __future__ import annotations

import math

import pytest
import sympy as sp

import lagrange
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.implied.body_shapes import ratio, with_implied_shapes
from lagrange.pictures.systems import SystemPicture, system_in_file
from lagrange.problem.keys import Outline

m, R = sp.symbols("m R", positive=True)
HEAD = "axes: {i: right, j: down}\ngravity: g*j\nparameters: [m, a, k, g]\ncoordinates: [q]\n"
ROD = HEAD + (
    "bodies: {B: {mass: m, inertia: m*a^2/3, position: a*sin(q)*i + a*cos(q)*j, angle: -q}}\n"
    'forces: {s: {spring: k, between: ["2*a*sin(q)*i + 2*a*cos(q)*j", [3*a, 0]], length: a}}\n'
)
WHEEL = HEAD + "bodies: {B: {mass: m, inertia: %s, position: q*i - a*j, angle: q/a}}\n"
TOP = (
    "gravity: -g*k\nparameters: [m, A, C, h, g]\ncoordinates: [phi, theta, psi]\nbodies:\n"
    "  B: {mass: m, inertia: [A, A, C], orientation: {axes: 313, angles: [phi, theta, psi]},\n"
    '      position: "h*(sin(theta)*sin(phi)*i - sin(theta)*cos(phi)*j + cos(theta)*k)"}\n'
)


def drawn(text: str, title: str) -> SystemPicture:
    system = system_in_file(kinematics_and_law(lagrange.loads(f"title: {title}\n{text}")))
    assert system is not None
    return with_implied_shapes(system)


def test_a_moment_is_a_number_times_mass_times_a_length_squared() -> None:
    assert ratio(m * R**2 / 2, m) == (sp.Rational(1, 2), R)
    assert ratio(m * (R**2 + 1) / 2, m) is None
    assert ratio(sp.Symbol("I"), m) is None


def test_a_rod_reaches_from_its_hinge_to_as_far_on_the_other_side() -> None:
    system = drawn(ROD, "Rod")
    ends = [system.at(end) for end in system.problem.figure.shapes["B"].ends]
    q, a = (system.pose.values[next(s for s in system.pose.values if s.name == name)] for name in "qa")
    far = max(ends, key=lambda e: math.hypot(*e))
    assert min(math.hypot(*e) for e in ends) < 1e-9
    assert math.dist(far, (2 * a * math.sin(q), 2 * a * math.cos(q), 0.0)) < 1e-9


@pytest.mark.parametrize(
    ("inertia", "kind"),
    [("m*a^2/2", Outline.DISC), ("m*a^2", Outline.RING), ("2*m*a^2/5", Outline.SPHERE), ("m*a^2/7", None)],
)
def test_a_number_tells_what_is_round(inertia: str, kind: Outline | None) -> None:
    shape = drawn(WHEEL % inertia, "A hoop rolls").problem.figure.shapes.get("B")
    assert (None if shape is None else shape.kind) is kind


def test_a_top_stands_on_its_tip() -> None:
    assert drawn(TOP, "A top").problem.figure.shapes["B"].kind is Outline.CONE
    assert "B" not in drawn(TOP, "A satellite").problem.figure.shapes


# What it is called


PLANE = "axes: {i: right, j: up}\nparameters: [m, a, b, h, I, g]\ncoordinates: [x, y, q]\ngravity: -g*j\n"
BODY = PLANE + "bodies: {%s: {mass: m, inertia: %s, position: x*i + y*j, angle: q}}\n"


@pytest.mark.parametrize(
    ("name", "inertia", "kind"),
    [
        ("box", "2/3*m*a^2", Outline.BOX),
        ("ball", "2/3*m*a^2", Outline.SPHERE),
        ("crate", "m*(b^2 + h^2)/12", Outline.BOX),
        ("arm", "I", Outline.ROD),
        ("drum", "I", Outline.DISC),
        ("body", "I", None),
        ("stone", "m*(b^2 + h^2)/12", None),
    ],
)
def test_the_name_decides_where_the_moment_leaves_a_choice(name: str, inertia: str, kind: Outline | None) -> None:
    shape = drawn(BODY % (name, inertia), "A thing is thrown").problem.figure.shapes.get(name)
    assert (None if shape is None else shape.kind) is kind


def test_the_sides_of_a_box_are_those_of_its_moment() -> None:
    system = drawn(BODY % ("crate", "m*(b^2 + h^2)/12"), "A crate is thrown")
    b, h = (next(s for s in system.pose.values if s.name == name) for name in "bh")
    assert system.problem.figure.shapes["crate"].lengths == (b, h)
    cube = drawn(BODY % ("box", "2/3*m*a^2"), "A box is thrown").problem.figure.shapes["box"]
    assert {str(x) for x in cube.lengths} == {"2*a"}


def test_an_arm_reaches_beyond_what_slides_on_it() -> None:
    text = (
        "parameters: [m, I]\ncoordinates: [r, phi]\nbodies: {arm: {inertia: I, position: 0*i, angle: phi}}\n"
        "particles: {collar: {mass: m, position: r*cos(phi)*i + r*sin(phi)*j}}\n"
    )
    system = drawn(text, "A collar on an arm")
    start, end = (system.at(e) for e in system.problem.figure.shapes["arm"].ends)
    collar = system.pose.at(system.configuration.points[-1].position)
    assert math.hypot(*start) < 1e-9
    assert math.dist(start, collar) + math.dist(collar, end) == pytest.approx(math.dist(start, end))
    assert math.dist(collar, end) > 0.1


SPACE = (
    "parameters: {m: positive, h: positive, l: positive, alpha: acute, g: positive}\ncoordinates: [phi, theta]\n"
    "gravity: -g*k\nlet: {R: h*tan(alpha), A: 3/20*m*(R^2 + h^2/4), C: 3/10*m*R^2}\nbodies:\n"
    "  B: {mass: m, inertia: %s, position: %s*e3_B, orientation: {axes: 313, angles: [phi, theta, 0]}}\n"
)


def test_a_cone_has_its_tip_where_it_does_not_move() -> None:
    system = drawn(SPACE % ("[A, A, C]", "-3/4*h"), "A cone swings")
    shape = system.problem.figure.shapes["B"]
    assert shape.kind is Outline.CONE
    assert shape.axis is not None
    height, along = system.number(shape.lengths[1]), system.at(shape.axis)
    at = system.pose.at(system.configuration.points[0].position)
    assert math.hypot(*(x - 0.75 * height * e for x, e in zip(at, along, strict=True))) < 1e-9
    assert drawn(SPACE % ("[A, A, C]", "3/4*h"), "A body swings").problem.figure.shapes.get("B") is None


def test_a_body_without_a_moment_about_one_axis_is_a_rod_along_it() -> None:
    system = drawn(SPACE % ("[m*l^2/12, m*l^2/12, 0]", "l/2"), "A thing swings")
    shape = system.problem.figure.shapes["B"]
    assert shape.kind is Outline.ROD
    assert min(math.hypot(*system.at(end)) for end in shape.ends) < 1e-9


def test_a_spool_has_a_rim_around_the_axle_on_which_its_string_is() -> None:
    text = (
        "axes: {j: down}\nparameters: [m, I, r, g]\ncoordinates: [y, phi]\ngravity: g*j\n"
        "bodies: {yoyo: {mass: m, inertia: I, position: y*j, angle: phi}}\n"
        "constraints: {string: {equation: y = r*phi, reaction: T}}\n"
    )
    system = drawn(text, "A yo-yo")
    [radius] = system.problem.figure.shapes["yoyo"].lengths
    r = next(v for s, v in system.pose.values.items() if s.name == "r")
    assert system.number(radius) > 1.5 * r
