"""Positions of equilibrium in a text: relative to what moves, within a range, rounded."""

from __future__ import annotations

from functools import cache

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem

IN_A_CAR = """title: Pendulum in a car
coordinates: [theta]
parameters: {m: {assume: positive}, l: {assume: positive}, g: {assume: positive}, a: {assume: positive}}
particles: {P: {mass: m, position: "(a*t^2/2 + l*sin(theta))*i - l*cos(theta)*j"}}
gravity: -g*j
find: linearization
"""


DOWN_A_SLOPE = """title: Pendulum on a carriage that slides down
coordinates: [s, theta]
parameters: {M: {assume: positive}, m: {assume: positive}, l: {assume: positive}, g: {assume: positive}, alpha: {assume: acute}}
particles:
  C: {mass: M, position: "s*cos(alpha)*i - s*sin(alpha)*j"}
  P: {mass: m, position: "(s*cos(alpha) + l*sin(theta))*i + (-s*sin(alpha) - l*cos(theta))*j"}
gravity: -g*j
find: linearization
"""


LEVEL = """title: A weight on a torsion spring
coordinates: {theta: {meaning: angle, range: [0, 90 deg]}}
parameters: {W: {value: 2 N}, l: {value: 1 m}, M: {value: 1 N m}}
forces: {weight: {potential: W*l*sin(theta)}, turn: {potential: -M*theta}}
find: equilibrium
"""


@cache
def examiner(text: str) -> Examiner:
    return Examiner.of(read_problem(Source("problem.yaml", text)))


def verdict(text: str, *lines: str) -> str:
    return examiner(text).check(tuple(Fragment.of(e) for e in lines)).verdict.value


def test_rest_relative_to_what_moves() -> None:
    assert verdict(IN_A_CAR, "tan(theta) = -a/g") == "equivalent"
    wrong = examiner(IN_A_CAR).check((Fragment.of("tan(theta) = a/g"),))
    assert wrong.verdict.value == "wrong"
    assert "equilibrium" in wrong.others[0].equations[0].diagnosis


def test_a_place_where_nothing_derived_compares() -> None:
    assert verdict(DOWN_A_SLOPE, "theta = -alpha") == "undecided"


def test_the_root_within_the_range_and_a_rounded_angle() -> None:
    assert verdict(LEVEL, "theta = pi/3") == "equivalent"
    assert verdict(LEVEL, "theta = 60.0 deg") == "equivalent"
    assert verdict(LEVEL, "theta = 61.0 deg") == "wrong"
