"""Positions of equilibrium in a text: relative to what moves, within a range, rounded.

Positions of equilibrium stated as numbers.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import pytest
import sympy as sp

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment, Source
from lagrange.explain.report import report
from lagrange.mechanics.nearby.one_state import RestInNumbers
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.render.json import as_object

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


# Positions in numbers


RIM = """title: Block on the rim of a disc held by a spring
axes: {i: right, j: up}
parameters: {m: {value: 10 kg}, k: {value: 4 kN/m}, a: {value: 80 mm}, b: {value: 300 mm}, g: {value: 9.81 m/s^2}}
coordinates: {theta: {range: [0, 90 deg]}}
particles: {W: {mass: m, position: "b*sin(theta)*i + b*cos(theta)*j"}}
gravity: -g*j
forces: {spring: {potential: "k*a^2*theta^2/2"}}
find: equilibrium
answers: {equilibrium: %s}
"""


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ('[["theta = 0"], ["theta = 0.902"]]', "equivalent"),  # sin θ = 0.8699 θ, Beer and Johnston's 51.7°
        ('["theta = 0.902"]', "incomplete"),
        ('[["theta = 0"], ["theta = 0.903"]]', "wrong"),
    ],
)
def test_positions_found_numerically(problem: Callable[[str], Problem], stated: str, verdict: str) -> None:
    [answer] = as_object(report(problem(RIM % stated)))["answers"]
    assert answer["verdict"] == verdict


PUSHED = """title: t
parameters: {m: {value: 2}, l: {value: 3}, g: {value: 10}}
coordinates: [x, y]
particles: {P: {mass: m, position: "[x, y]"}}
constraints: {rod: x^2 + y^2 = l^2}
find: constraints
answers: {equilibrium: ["y = 2.40"]}
"""


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        (["x = 1.8", "y = 2.40"], "equivalent"),
        (["y = 2.4"], "equivalent"),
        (["y = 12/5"], "equivalent"),
        (["y = 2.41"], "undecided"),  # there may be another position, which was not looked for
        (["x = 1.8", "y = -2.4"], "undecided"),
        (["x + y = 4.2"], "undecided"),
        (["y ="], "unreadable"),
    ],
)
def test_one_position_of_a_large_system(problem: Callable[[str], Problem], stated: list[str], verdict: str) -> None:
    of_rod = problem(PUSHED)
    x, y = of_rod.slots.coordinates
    rest = RestInNumbers({x: sp.Float(1.8, 14), y: sp.Float(2.4, 14)}, {}, True, True)
    examiner = Examiner(of_rod, replace(solve(of_rod), rest_in_numbers=rest))
    assert examiner.check(tuple(map(Fragment.of, stated))).verdict.value == verdict
    assert examiner.check_own().verdict.value == "equivalent"
