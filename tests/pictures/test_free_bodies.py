"""Arrows of the forces on a free body."""

from __future__ import annotations

import math

import pytest
import sympy as sp

import lagrange
from lagrange.document.derivation import Picture, Rule
from lagrange.document.math_writer import UNICODE, Writer
from lagrange.document.scene import Polyline, Scene, StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.free_bodies import free_body_scene
from lagrange.pictures.loads import acting_on
from tests.support.drawings import CLOSE, evaluated, lines_of, near, system_of
from tests.support.figure_sheet import figures_of
from tests.support.shared import reported


def labelled_tip(scene: Scene, label: str, notation) -> Polyline:
    """The arrow whose tip is nearest to a label."""
    write = Writer(UNICODE, notation)
    [found] = [x for x in scene.labels if not isinstance(x.content, str) and write.plain(x.content) == label]
    tips = [line for line in scene.lines if line.tip]
    return min(tips, key=lambda line: math.dist(line.points[-1], found.at))


def test_arrows_of_a_pendulum() -> None:
    name = "chapter6/ex11-ideal-pendulum"
    system, notation = system_of(name), reported(name).notation
    scene = free_body_scene(system, notation)
    assert scene is not None
    x, y = (evaluated(sp.Symbol(n, real=True), system) for n in "xy")
    (a, b), (c, d) = (labelled_tip(scene, label, notation).points for label in ("m g", "T_rod"))
    weight, pull = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    assert abs(weight[0]) < CLOSE
    assert weight[1] < 0
    length = math.hypot(*pull)
    assert near((pull[0] / length, pull[1] / length), (-x / math.hypot(x, y), y / math.hypot(x, y)))


def test_a_ladder_is_held_at_its_ends_and_a_hoop_is_a_wheel() -> None:
    ladder = system_of("motion/sliding-ladder")
    half = evaluated(sp.Symbol("l", positive=True), ladder)
    held = sorted(ladder.shapes["ladder"].held)
    assert near(held[0], (-half, 0))
    assert near(held[1], (half, 0))
    hoop = system_of("motion/hoop-on-incline")
    assert math.isclose(hoop.shapes["hoop"].radius, evaluated(sp.Symbol("R", positive=True), hoop))


def outline(name: str) -> list[tuple[float, float]]:
    """The first closed and filled line of a free body."""
    scene = free_body_scene(system_of(name), reported(name).notation)
    assert scene is not None
    return next([*line.points] for line in scene.lines if line.closed and line.shade)


def test_free_bodies_have_the_shape_that_the_file_gives() -> None:
    box = outline("motion/trolley-on-three-wheels")
    assert len(box) == 4
    assert near((math.dist(box[0], box[1]) / math.dist(box[1], box[2]), 0.0), (3 / 0.7, 0.0))


def test_friction_at_rest_acts_where_the_body_touches() -> None:
    system = system_of("statics/ladder-on-rough-ground")
    body = system.newton.bodies[0]
    acting = {str(a.label): a for a in acting_on(system, body)}
    below, above = acting["F_below"], acting["F_above"]
    assert below.vector == pytest.approx((-1, 0, 0))
    assert above.vector == pytest.approx((0, 1, 0))
    assert acting["N_A"].offset == pytest.approx(below.offset)  # both at the foot
    assert below.offset[1] < 0 < above.offset[1]


@pytest.mark.parametrize("name", ["motion/conical-pendulum", "motion/coupled-pendulums", "motion/ball-on-turntable"])
def test_no_free_body_without_the_forces_that_the_coordinates_hide(name: str) -> None:
    """Rods pull and a table pushes, though no constraint represents them: a free body without these forces would be wrong."""
    assert system_of(name).configuration.has_forces_built_in
    assert free_body_scene(system_of(name), reported(name).notation) is None
    assert not system_of("chapter6/ex11-ideal-pendulum").configuration.has_forces_built_in


def test_a_rod_on_two_supports_has_its_normal_forces() -> None:
    page = reported("chapter6/ex16-rod-on-two-planes").derivation.page
    [picture] = [b for s in page if s.rule is Rule.WORKLESS for b in s.body if isinstance(b, Picture)]
    scene = picture.draw()
    assert scene is not None
    assert {"N_A", "N_B", "W"} <= {str(label.content) for label in scene.labels}
    assert len(lines_of(scene, StrokeKind.REACTION)) == 2


def test_the_weights_of_two_particles_above_each_other_act_on_them() -> None:
    text = (
        "title: Two weights\ndescription: They hang from a string over a pulley.\naxes: {i: right, j: down}\n"
        "gravity: g*j\nparameters: [m, M, L, g]\ncoordinates: [x, y]\n"
        "particles: {A: {mass: m, position: x*j}, B: {mass: M, position: y*j}}\nconstraints: {string: x + y = L}\n"
    )
    _, bodies = figures_of(kinematics_and_law(lagrange.loads(text)))
    arrows = [line for line in bodies.lines if line.kind in (StrokeKind.FORCE, StrokeKind.REACTION)]
    assert len(arrows) == 4
    outlines = [line.points for line in bodies.lines if line.kind is StrokeKind.BODY]
    for arrow in arrows:
        assert min(math.dist(arrow.points[0], p) for points in outlines for p in points) < 0.3
