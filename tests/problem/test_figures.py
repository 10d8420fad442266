"""What a file adds to its figure, and its mistakes."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.problem.limits import MOST_DRAWN
from lagrange.problem.model import Drawn, Outline, Problem

BASE = """
title: t
parameters: [m, l, R]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j, shape: {box: [R, 2*R]}}, Q: {position: 0*i}}
constraints: {rod: x^2 + y^2 = l^2}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
figure:
  %s
"""


def test_places_are_particles_points_and_vectors(problem: Callable[[str], Problem]) -> None:
    figure = problem(BASE % "points: {A: l*i}\n  rods: [[P, A, O, '[0, l]']]").figure
    [line] = figure.lines
    x, y, l = sp.Symbol("x", real=True), sp.Symbol("y", real=True), sp.Symbol("l", positive=True)
    assert line.kind is Drawn.RODS
    assert [p.components for p in line.places] == [(x, y, 0), (l, 0, 0), (0, 0, 0), (0, l, 0)]  # type: ignore[union-attr]


def test_shapes_positions_and_curves_are_read(problem: Callable[[str], Problem]) -> None:
    text = (
        BASE % "at: {theta: 30 deg}\n  curves: [{point: s*i, along: s, from: 0, to: l, as: ground}]\n  hide: [x, rod]"
    )
    figure = problem(text).figure
    assert figure.at == {"theta": sp.pi / 6}
    assert figure.shapes["P"].kind is Outline.BOX
    assert figure.curves[0].kind is Drawn.GROUND
    assert figure.hidden == {"x", "rod"}


def test_a_label_may_be_a_coordinate_of_a_choice(problem: Callable[[str], Problem]) -> None:
    [mark] = problem(BASE % "angles: {theta: [O, j, r_P]}").figure.marks
    assert mark.label == sp.Symbol("theta", real=True)


WRONG = {
    "at: {z: 1}": "unknown-name",
    "at: {x: y}": "not-a-number",
    "rods: [[P]]": "wrong-kind",
    "rods: [[P, B]]": "unknown-symbol",
    "hide: [rope]": "unknown-name",
    "angles: {l: [O, P]}": "wrong-kind",
    "circles: [{centre: P}]": "missing-key",
    "circles: [{centre: P, radius: R, as: disk}]": "figure-word",
    "curves: [{point: s*i, along: [s, u], from: 0, to: 1}]": "wrong-kind",
    'curves: [{point: "x\'*i", along: s, from: 0, to: 1}]': "not-allowed-here",
    "wheel: [[P, i]]": "unknown-key",
    "lines: [" + ", ".join(["[P, O]"] * (MOST_DRAWN + 1)) + "]": "figure-too-large",
}


@pytest.mark.parametrize("section", WRONG)
def test_mistakes_have_a_place(section: str, problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as caught:
        problem(BASE % section)
    [finding] = caught.value.diagnostics
    assert finding.code == WRONG[section]
    assert finding.span is not None
    assert finding.help


def test_a_shape_is_one_of_the_known_ones(problem: Callable[[str], Problem]) -> None:
    for wrong in ("{}", "{disc: R, box: [R, R]}", "{box: R}", "{rod: [P]}"):
        with pytest.raises(ProblemError):
            problem((BASE % "at: {x: 1}").replace("{box: [R, 2*R]}", wrong))
