"""The points about which bodies turn, and the chains that lead to them."""

from __future__ import annotations

import math

import sympy as sp

import lagrange
from lagrange.core.vectors import Vector
from lagrange.document.scene import StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.joints import swinging_joints, turning_point
from lagrange.pictures.systems import SystemPicture, system_in_file
from tests.support.drawings import lines_of, sketched

HUNG = (
    "axes: {i: right, j: down}\ngravity: g*j\nparameters: [m, l, b, g]\ncoordinates: [phi, theta]\n"
    "let: {A: b*sin(phi)*i + b*cos(phi)*j}\n"
    "bodies: {rod: {mass: m, inertia: m*l^2/12, position: A + l/2*(sin(theta)*i + cos(theta)*j), angle: -theta}}\n"
)
COLUMN = (
    "axes: {i: right, j: up}\nparameters: [a, P, K]\ncoordinates: [alpha, beta]\n"
    "particles: {top: {position: a*(sin(alpha) + sin(beta))*i + a*(cos(alpha) + cos(beta))*j}}\n"
    "forces: {load: {on: top, vector: -P*j}, foot: {potential: K*alpha^2/2}}\n"
)


def system(text: str) -> SystemPicture:
    found = system_in_file(kinematics_and_law(lagrange.loads(f"title: A rod\n{text}")))
    assert found is not None
    return found


def test_a_point_turns_about_what_is_left_of_it() -> None:
    q, a, b = sp.symbols("q a b", real=True)
    zero = sp.S.Zero
    assert turning_point(Vector((a + b * sp.cos(q), b * sp.sin(q), zero)), q).components == (a, 0, 0)


def test_the_joint_of_a_hanging_rod_swings_about_the_fixed_place() -> None:
    found = system(HUNG)
    [joint] = swinging_joints(found.configuration, found.pose)
    values = {s.name: v for s, v in found.pose.values.items()}
    assert math.hypot(*joint.mark.centre) < 1e-9
    assert math.dist(joint.mark.point, (0.0, 0.0, 0.0)) - values["b"] < 1e-9
    assert joint.coordinate.name == "phi"


def test_a_rod_hung_by_a_string_has_its_string() -> None:
    assert len(lines_of(sketched("A rod hung by a string", HUNG), StrokeKind.STRING)) == 1
    assert lines_of(sketched("A body", HUNG), StrokeKind.STRING) == []


def test_two_bars_stand_one_on_the_other_in_the_order_of_their_coordinates() -> None:
    scene = sketched("A column of two rigid bars", COLUMN)
    rods = [line.points for line in lines_of(scene, StrokeKind.ROD)]
    assert len(rods) == 2
    assert rods[0][1] == rods[1][0]
    alpha = next(v for s, v in system(COLUMN).pose.values.items() if s.name == "alpha")
    (x, y), (u, v) = rods[0]
    assert abs(math.atan2(u - x, v - y) - alpha) < 1e-6


def test_a_rod_that_strikes_upright_hangs_from_its_hinge() -> None:
    text = (
        "gravity: -g*j\nparameters: [m, L, g]\ncoordinates: [theta]\nfigure: {at: {theta: 0}}\n"
        "bodies: {rod: {mass: m, inertia: m*L^2/12, position: L/2*sin(theta)*i - L/2*cos(theta)*j, angle: theta}}\n"
    )
    found = system(text)
    [joint] = found.joints["rod"]
    assert math.hypot(*joint) < 1e-9
