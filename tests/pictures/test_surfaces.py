"""Surfaces that are not specified: a generic one, with its normal and displacements.

Surfaces and curves in space that constraints give.
"""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
import sympy as sp

import lagrange
from lagrange.core.symbols import UnitVector, VectorSymbol, differential, t
from lagrange.document.scene import Scene, StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.floats import FloatVector
from lagrange.pictures.implied.body_shapes import with_implied_shapes
from lagrange.pictures.surfaces import InSpace, constraints_in_space, surface
from lagrange.pictures.systems import system_in_file
from tests.support.drawings import figures, lines_of

FIXED = ("ex02-fixed-surface", "ex08-displacements-on-a-surface", "ex12-smooth-surface", "ex15-rough-surface")
GRADIENT, VIRTUAL, POSSIBLE = (VectorSymbol(f"{d}") for d in ("nabla(f)", "delta(r_P)", "d(r_P)"))
MOVING = ("ex09-moving-surface", "ex13-moving-surface")


def written(scene: Scene) -> set[sp.Expr | str]:
    return {label.content for label in scene.labels}


@pytest.mark.parametrize("name", FIXED)
def test_a_fixed_surface_has_its_normal_and_a_virtual_displacement(name: str) -> None:
    [scene, *_] = figures(name)
    assert {GRADIENT, VIRTUAL} <= written(scene)
    assert POSSIBLE not in written(scene)
    assert len({line.shade for line in lines_of(scene, StrokeKind.FACE)}) == 1, "a border of shades is a staircase"
    assert len(lines_of(scene, StrokeKind.FACE)) > 100


@pytest.mark.parametrize("name", MOVING)
def test_on_a_moving_surface_a_possible_displacement_has_another_part(name: str) -> None:
    [scene, *_] = figures(name)
    carrying = sp.Symbol("u", real=True) * differential(t)
    assert {GRADIENT, VIRTUAL, POSSIBLE, carrying} <= written(scene)
    virtual, possible = (line.points for line in lines_of(scene, StrokeKind.FORCE))
    [carried] = [line.points for line in lines_of(scene, StrokeKind.AXIS) if line.points[0] == virtual[0]]
    total = [virtual[1][n] + carried[1][n] - virtual[0][n] for n in (0, 1)]
    assert math.dist(total, possible[1]) < 1e-9


def test_friction_is_against_the_velocity() -> None:
    [_, body] = figures("ex15-rough-surface")
    assert {"friction", "velocity"} <= written(body)
    [velocity] = [line.points for line in lines_of(body, StrokeKind.REFERENCE)]
    way = [velocity[1][n] - velocity[0][n] for n in (0, 1)]
    pulls = [[b[n] - a[n] for n in (0, 1)] for a, b in (line.points for line in lines_of(body, StrokeKind.FORCE))]
    cosines = [(p[0] * way[0] + p[1] * way[1]) / math.hypot(*p) / math.hypot(*way) for p in pulls]
    assert min(cosines) == pytest.approx(-1, abs=0.02)


def test_a_wire_of_any_form_has_its_normal_too() -> None:
    [scene, body] = figures("bead-on-any-wire")
    assert {GRADIENT, VectorSymbol("delta(r_bead)")} <= written(scene)
    assert {"R", "F"} <= {getattr(w, "name", str(w))[0] for w in written(body)}  # the reaction, and all that is applied


# Space


HERE = (0.6, 0.8, 1.0)


def bowl(p: FloatVector) -> float:
    return p[0] ** 2 + p[1] ** 2 - p[2]


def cone(p: FloatVector) -> float:
    return p[0] ** 2 + p[1] ** 2 - p[2] ** 2


def saddle(p: FloatVector) -> float:
    return p[0] * p[1] - 0.48 * p[2]


@pytest.mark.parametrize("f", [bowl, cone])
def test_a_surface_of_revolution_is_drawn_from_its_axis_to_above_the_particle(f) -> None:  # type: ignore[no-untyped-def]
    grid = surface(f, HERE)
    assert max(abs(f(p)) for row in grid[1:-1] for p in row) < 1e-6
    radii = [math.hypot(row[0][0], row[0][1]) for row in (grid[0], grid[-1])]
    assert min(radii) < 0.05
    assert 1.0 < max(radii) < 1.5


def test_any_other_surface_is_a_patch_around_the_particle() -> None:
    grid = surface(saddle, HERE)
    assert max(abs(saddle(p)) for row in grid for p in row) < 1e-6
    assert min(math.dist(p, HERE) for row in grid for p in row) < 1e-6


def in_space(text: str) -> InSpace:
    system = system_in_file(kinematics_and_law(lagrange.loads(f"title: Curves\n{text}")))
    assert system is not None
    return constraints_in_space(with_implied_shapes(system))


POINT = "parameters: [m, a, b]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: x*i + y*j + z*k}}\n"


def test_two_surfaces_leave_a_closed_curve() -> None:
    [points] = in_space(f"{POINT}constraints: {{bowl: z = x^2/a + y^2/a, sphere: x^2 + y^2 + z^2 = 2*a^2}}\n").curves
    assert points[0] == points[-1]
    heights = [z for _, _, z in points]
    assert max(heights) - min(heights) < 1e-6  # a circle
    assert max(math.dist(a, b) for a, b in pairwise(points)) < 0.1


def test_a_helix_in_cylindrical_coordinates_winds_more_than_once() -> None:
    [points] = in_space(
        "parameters: [m, a, b]\nframe: {type: cylindrical, coordinates: [rho, phi, z]}\ncoordinates: [rho, phi, z]\n"
        "particles: {P: {mass: m, position: rho*e_rho + z*k}}\nconstraints: {radius: rho = a, pitch: z = b*phi}\n"
    ).curves
    turned = sum(
        math.remainder(math.atan2(q[1], q[0]) - math.atan2(p[1], p[0]), 2 * math.pi) for p, q in pairwise(points)
    )
    assert abs(turned) > 2 * math.pi
    assert (points[-1][2] - points[0][2]) / turned == pytest.approx(
        (points[9][2] - points[0][2])
        / sum(
            math.remainder(math.atan2(q[1], q[0]) - math.atan2(p[1], p[0]), 2 * math.pi)
            for p, q in pairwise(points[:10])
        )
    )


def test_a_torus_is_closed() -> None:
    [grid] = in_space(f"{POINT}constraints: {{torus: (sqrt(x^2 + y^2) - a)^2 + z^2 = b^2}}\n").grids
    assert all(math.dist(p, q) < 1e-9 for p, q in zip(grid[0], grid[-1], strict=True))
    heights = [row[0][2] for row in grid]
    assert max(heights) == pytest.approx(-min(heights), rel=0.05)


def test_what_rolls_on_a_floor_in_space_has_a_floor_at_its_lowest_point() -> None:
    text = (
        "parameters: [m, R]\ncoordinates: [x, y, phi, theta, psi]\nbodies:\n  ball: {mass: m, "
        "inertia: [2/5*m*R^2, 2/5*m*R^2, 2/5*m*R^2], position: x*i + y*j + 3*R*k, "
        "orientation: {axes: 313, angles: [phi, theta, psi]}}\n"
    )
    [floor] = in_space(f"description: It rolls on the floor.\n{text}").tables
    assert len({z for _, _, z in floor}) == 1
    assert floor[0][2] > 1  # 2 R
    assert in_space(f"description: It turns.\n{text}").tables == ()


def test_a_cone_in_cylindrical_coordinates_is_drawn() -> None:
    text = (
        "title: Funnel\nparameters: {m: positive, g: positive, alpha: acute}\ngravity: -g*k\n"
        "frame: {type: cylindrical, coordinates: [rho, phi, z]}\ncoordinates: [rho, phi, z]\n"
        "particles: {P: {mass: m, position: rho*e_rho + z*k}}\nconstraints: {cone: rho = z*tan(alpha)}\n"
    )
    system = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert system is not None
    [grid] = constraints_in_space(system).grids
    assert len(grid[0]) == 25  # all around the axis


def test_a_surface_that_moves_along_an_unnamed_axis_moves_to_the_right() -> None:
    [scene, *_] = figures("ex13-moving-surface")
    [axis] = [label for label in scene.labels if label.content == UnitVector("i")]
    assert axis.at[0] > 2 * abs(axis.at[1])
