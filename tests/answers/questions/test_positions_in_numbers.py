"""Positions of equilibrium stated as numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
import sympy as sp

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from lagrange.explain.report import report
from lagrange.mechanics.nearby.rest_in_numbers import RestInNumbers
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render.json import as_object

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
