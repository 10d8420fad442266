"""Bodies and circles as they are seen.

Shapes of bodies inferred from their moments of inertia.
"""

from __future__ import annotations

import math

import pytest
import sympy as sp

import lagrange
from lagrange.document.scene import StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.floats import inner, outer
from lagrange.pictures.solids import across, hull, ratio, with_implied_shapes
from lagrange.pictures.systems import SystemPicture, system_in_file
from lagrange.problem.keys import Outline
from tests.support.drawings import figures, lines_of


@pytest.mark.parametrize("axis", [(0.0, 0.0, 2.0), (1.0, 0.0, 0.0), (0.3, -0.5, 0.8)])
def test_two_vectors_across_an_axis(axis: tuple[float, float, float]) -> None:
    u, v = across(axis)
    assert math.isclose(inner(u, u), 1)
    assert math.isclose(inner(outer(u, v), axis), math.hypot(*axis))


def test_a_hull_leaves_out_what_is_inside() -> None:
    assert set(hull([(0, 0), (2, 0), (2, 2), (0, 2), (1, 1), (1, 0)])) == {(0, 0), (2, 0), (2, 2), (0, 2)}


def test_a_sphere_is_a_circle_whose_hidden_half_is_dashed() -> None:
    [scene, *_] = figures("rolling-ball")
    ball = max((line for line in lines_of(scene, StrokeKind.BODY)), key=lambda line: len(line.points))
    xs, ys = zip(*ball.points, strict=True)
    assert math.isclose(max(xs) - min(xs), max(ys) - min(ys), rel_tol=0.01)
    equator = [line for line in lines_of(scene, StrokeKind.REFERENCE) if len(line.points) > 10]
    assert equator


def test_the_disc_of_a_coin_touches_the_ground_at_its_contact() -> None:
    """The point Q, which the file gives, is on the rim that is drawn."""
    [scene, *_] = figures("rolling-coin")
    rim = max(lines_of(scene, StrokeKind.BODY), key=lambda line: len(line.points))
    [contact] = [d.at for d in scene.dots if min(math.dist(d.at, p) for p in rim.points) < 0.08]
    assert contact[1] == pytest.approx(min(p[1] for p in rim.points), abs=0.15)


# Implied shapes


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
