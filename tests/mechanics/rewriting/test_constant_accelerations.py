"""Accelerations that parameters alone determine.

Forces from single laws, one after another, against the general solution and a law by hand.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.rewriting.constant_accelerations import constant_accelerations, forces_in_turn
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.shared import solved

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


# Forces in turn


@pytest.mark.parametrize("name", ["planetary-gear"])
def test_tooth_forces(name: str) -> None:
    solution = solved(name, complete=False)
    view = solution.chosen
    accelerations = constant_accelerations(view)
    assert solution.law is not None
    forces = forces_in_turn(solution.law, solution.own, view, accelerations)
    assert forces is not None
    said = {s.name: e for s, e in forces.items()}
    names = {s.name: s for e in said.values() for s in e.free_symbols}
    moment = names["M_0"] - names["J_0"] * names["alpha''"]
    assert sp.expand(said["F_1"] * names["r"] - moment) == 0  # of the sun wheel: J₀ α'' = M₀ − r F₁
    turning = names["J_1"] * names["psi''"] - names["s"] * (said["F_2"] - names["F_1"])
    assert sp.expand(turning) == 0  # of the planet: J₁ ψ'' = s (F₂ − F₁)


@pytest.mark.parametrize("name", ["planetary-gear"])
def test_wrong_accelerations_are_noticed(name: str) -> None:
    solution = solved(name, complete=False)
    wrong = {a: 2 * e for a, e in constant_accelerations(solution.chosen).items()}
    assert solution.law is not None
    assert forces_in_turn(solution.law, solution.own, solution.chosen, wrong) is None


def test_one_acceleration_that_the_equation_does_not_say() -> None:
    """Atwood's machine with a pulley, by hand; a stone that falls says it already."""
    text = """
title: Atwood's machine
parameters: [m_1, m_2, I, R, g]
coordinates: [x]
particles: {A: {mass: m_1, position: x*j}, B: {mass: m_2, position: R*i - x*j}}
bodies: {pulley: {inertia: I, position: 0*i, angle: x/R}}
gravity: g*j
"""
    [value] = constant_accelerations(solve(read_problem(Source("a.yaml", text))).own).values()
    m_1, m_2, I, R, g = (next(s for s in value.free_symbols if s.name == n) for n in ("m_1", "m_2", "I", "R", "g"))
    assert sp.cancel(value - (m_1 - m_2) * g / (m_1 + m_2 + I / R**2)) == 0
    stone = (
        "title: Stone\nparameters: [m, g]\ncoordinates: [x]\nparticles: {A: {mass: m, position: x*j}}\ngravity: g*j\n"
    )
    assert constant_accelerations(solve(read_problem(Source("b.yaml", stone))).own) == {}
