"""Shapes of bodies that the moments of inertia tell."""

from __future__ import annotations

import math

import pytest
import sympy as sp

import lagrange
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.implied_shapes import ratio, with_implied_shapes
from lagrange.pictures.systems import SystemPicture, system_in_file
from lagrange.problem.model import Outline

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
