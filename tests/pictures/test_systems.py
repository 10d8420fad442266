"""Rods, wheels and springs are drawn where they are."""

from __future__ import annotations

import math

import sympy as sp

from lagrange.document.scene import StrokeKind
from tests.support.drawings import evaluated, lines_of, near, scenes, system_of


def test_rods_end_at_their_particles() -> None:
    system = system_of("chapter6/ex03-double-pendulum")
    [scene, _] = scenes("chapter6/ex03-double-pendulum")
    x1, y1, x2, y2 = (evaluated(sp.Symbol(n, real=True), system) for n in ("x1", "y1", "x2", "y2"))
    scale = system.page.scale
    places = [(0.0, 0.0), (x1 * scale, -y1 * scale), (x2 * scale, -y2 * scale)]  # j points down
    upper, lower = lines_of(scene, StrokeKind.ROD)
    assert near(upper.points[0], places[0])
    assert near(upper.points[1], places[1])
    assert {True} == {any(near(p, q) for q in places[1:]) for p in lower.points}
    assert [any(near(d.at, p) for d in scene.dots) for p in places] == [True] * 3


def test_the_length_of_a_rod_is_that_of_its_parameter() -> None:
    system = system_of("statics/slider-crank")
    scene = scenes("statics/slider-crank")[0]
    _, rod = lines_of(scene, StrokeKind.ROD)  # after the crank
    length = evaluated(sp.Symbol("l", positive=True), system)
    assert math.isclose(math.dist(*rod.points), length * system.page.scale)


def test_the_clapper_hangs_from_the_bell() -> None:
    system = system_of("motion/bell-and-clapper")
    alpha, l = (evaluated(s, system) for s in (sp.Symbol("alpha", real=True), sp.Symbol("l", positive=True)))
    [pin] = system.joints["clapper"]
    assert near(pin[:2], (l * math.cos(alpha), l * math.sin(alpha)))
    assert len(system.joints["bell"]) == 2
