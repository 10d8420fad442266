"""Arrows of forces, and the curves along which something moves."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.core.symbols import VectorSymbol
from lagrange.document.scene import StrokeKind
from lagrange.explain.report import report
from lagrange.pictures.free_bodies import free_body_scene
from lagrange.pictures.loads import acting_on
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import SystemPicture, system_in_file
from tests.support.drawings import CLOSE, evaluated, figures, lines_of, system_of
from tests.support.paths import PROBLEMS
from tests.support.shared import reported

SHIPPED = sorted(p.relative_to(PROBLEMS).with_suffix("").as_posix() for p in PROBLEMS.glob("*/*.yaml"))


@pytest.mark.parametrize("name", SHIPPED)
def test_the_arrows_add_up_to_what_acts(name: str) -> None:
    """Each label times the direction of its arrow; the sum is the right side of Newton's law."""
    system = system_in_file(reported(name).solution)
    if system is None or not system.newton.bodies or free_body_scene(system, reported(name).notation) is None:
        return
    at_rest = {f for c in system.contacts for f in c.components}  # friction, unknown as it is, is in no law of motion
    for body in system.newton.bodies:
        drawn = acting_on(system, body)
        pushing = [a for a in drawn if not a.is_moment and a.label not in at_rest]
        reactions = [v * r.force for r, v in body.reactions]
        total = [sum((v.fixed().components[n] for v in (body.applied, *reactions)), sp.S.Zero) for n in range(3)]
        labels = [a.label for a in pushing]
        if any(isinstance(x, str | VectorSymbol) for x in labels) or not _sizes_are_written(system, body, pushing):
            continue
        symbols = sorted(set().union(*(sp.sympify(e).free_symbols for e in (*total, *labels))), key=str)
        known = dict(system.pose.values) | {
            s: 0.7 + 0.2 * n for n, s in enumerate(symbols) if s not in system.pose.values
        }
        named = {
            r.symbol: r.single.factor * r.multiplier for r, _ in body.reactions if r.single and r.symbol and not r.named
        }
        for n in range(3):
            parts = []
            for a in pushing:
                size = sp.sympify(a.label).xreplace(named).subs(known)
                parts.append(float(size) * a.vector[n] / math.hypot(*a.vector))
            expected = float(sp.sympify(total[n]).subs(known))
            assert math.isclose(math.fsum(parts), expected, abs_tol=1e-7), (name, body.name)


def _sizes_are_written(system: SystemPicture, body, pushing) -> bool:
    """Whether every label is a size: not where a reaction λ∇f is labelled λ alone."""
    for r, v in body.reactions:
        if r.rod is not None and r.tension is not None:
            continue
        length = math.sqrt(sum(evaluated(c, system) ** 2 for c in v.fixed().components)) if _is_static(system, v) else 0
        if abs(length - 1) > CLOSE:
            return False
    return bool(pushing)


def _is_static(system: SystemPicture, v) -> bool:
    return all(c.free_symbols <= set(system.pose.values) for c in v.fixed().components)


def test_a_damper_pulls_towards_its_other_end() -> None:
    """The force of the damper on the body of the suspension is b(z1' − z2') downwards: its work is −b(z1' − z2')²."""
    system = system_of("motion/wheel-suspension")
    body = next(b for b in system.newton.bodies or () if b.name == "body")
    [damper] = [a for a in acting_on(system, body) if sp.Symbol("b", positive=True) in sp.sympify(a.label).free_symbols]
    z1, z2, b = sp.Symbol("z1'", real=True), sp.Symbol("z2'", real=True), sp.Symbol("b", positive=True)
    assert damper.vector[0] < 0
    assert sp.expand(damper.label - b * (z1 - z2)) == 0


def test_a_curve_is_where_its_constraint_holds(problem) -> None:
    text = """
title: Bead on a wire
axes: {i: right, j: up}
parameters: [m, g, a]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {wire: a*y = x^2}
gravity: -g*j
"""
    found = report(problem(text))
    system = system_in_file(found.solution)
    assert system is not None
    scene = configuration_scene(system, found.notation, with_loads=False)
    assert scene is not None
    [curve] = lines_of(scene, StrokeKind.CURVE)
    a = system.pose.values[sp.Symbol("a", positive=True)]
    assert len(curve.points) > 20
    for u, v in curve.points:
        x, y = u / system.page.scale, v / system.page.scale
        assert abs(a * y - x**2) < 1e-7


# -- Arrows in pictures of systems -------------------------------------------------------------------------------------


def test_a_blow_ends_where_it_strikes_in_the_position_before_it() -> None:
    """The rod hangs from its hinge, and J strikes it at right angles, from the left."""
    scene = figures("centre-of-percussion")[0]
    [blow] = [line for line in lines_of(scene, StrokeKind.FORCE) if abs(line.points[0][1] - line.points[1][1]) < 1e-6]
    assert blow.points[1][0] == pytest.approx(0, abs=1e-6)  # on the rod, below the hinge
    assert blow.points[0][0] < 0
    assert blow.points[1][1] < 0
