"""Equations for the instant of release."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from tests.support.shared import loaded, solved


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("released-pendulum", ["theta'' = -g/l*sin(theta)"], "equivalent"),
        ("released-pendulum", ["theta'' = g/l*sin(theta)"], "wrong"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict


HINGED = """
title: Hinged rod, released level
parameters: [m, l, g, k]
coordinates: [theta]
bodies: {rod: {mass: m, inertia: m*l^2/12, position: l/2*cos(theta)*i - l/2*sin(theta)*j, angle: -theta}}
gravity: -g*j
forces: {spring: {on: rod, moment: k*sin(theta)*k_}}
let: {k_: "cross(i, j)"}
initial: {theta: 0, theta': 0}
ask: {start: {quantity: "theta''", when: t = 0}%s}
"""


@pytest.mark.parametrize(
    ("further", "verdict"), [("", "undecided"), (', speed: {quantity: "theta\'", when: "theta = pi/6"}', "wrong")]
)
def test_an_equation_in_the_coordinate_is_meant_for_the_motion_if_that_is_asked_for(further: str, verdict: str) -> None:
    """k sin θ with the wrong factor holds at θ = 0."""
    examiner = Examiner.of(read_problem(Source("rod", HINGED % further)))
    lines = ["m*l^2/3*theta'' = m*g*l/2*cos(theta) - 2*k*sin(theta)"]
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict
