"""Accelerations that parameters alone determine."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.rewriting.constant_accelerations import constant_accelerations
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

YO_YO = """
title: Yo-yo
parameters: [m, J, R, g]
coordinates: [y, phi]
bodies: {disc: {mass: m, inertia: J, position: y*j, angle: phi}}
constraints: {string: {equation: EQUATION, reaction: S, by: string}}
gravity: g*j
"""


@pytest.mark.parametrize("equation", ["y = R*phi", "R*phi' = y'"])
def test_constant_accelerations_with_dependent_coordinates(equation: str) -> None:
    """m y'' = m g − S, J phi'' = R S, y'' = R phi''."""
    solution = solve(read_problem(Source("yo-yo.yaml", YO_YO.replace("EQUATION", equation))), complete=False)
    values = {str(a): v for a, v in constant_accelerations(solution.chosen).items()}
    m, J, R, g = (next(s for v in values.values() for s in v.free_symbols if s.name == n) for n in ("m", "J", "R", "g"))
    assert sp.simplify(values["y''"] - m * g * R**2 / (m * R**2 + J)) == 0
    assert sp.simplify(values["phi''"] - m * g * R / (m * R**2 + J)) == 0


def test_a_swinging_yo_yo_has_no_constant_acceleration() -> None:
    text = YO_YO.replace("EQUATION", "y = R*phi").replace("position: y*j", "position: y*cos(phi)*j")
    solution = solve(read_problem(Source("yo-yo.yaml", text)), complete=False)
    assert constant_accelerations(solution.chosen) == {}
