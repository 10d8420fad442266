"""Positions of equilibrium stated as numbers."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.explain.report import report
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
