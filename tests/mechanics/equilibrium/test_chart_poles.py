"""Poles of a chart: the azimuth at the pole of a sphere moves nothing."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Prose
from lagrange.explain.rest.statics import explain_virtual_work
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.statics_texts import CHAIN, CROSS_WIND, POLES_OF_A_CHOICE

CYLINDRICAL = """
title: A force in cylindrical coordinates
parameters: [F, k]
coordinates: [rho, phi]
particles: {P: {mass: 1, position: rho*cos(phi)*i + rho*sin(phi)*j}}
forces:
  centre: {potential: k*rho^2/2}
  push: {on: P, vector: F*i}
find: equilibrium
"""
SPHERICAL = """
title: Spherical pendulum
parameters: [m, g, l]
coordinates: [theta, phi]
particles: {P: {mass: m, position: l*sin(theta)*cos(phi)*i + l*sin(theta)*sin(phi)*j - l*cos(theta)*k}}
gravity: -g*k
find: equilibrium
"""
CRANK = """
title: Crank and slider pushed towards the axis
parameters: [F, l, r]
coordinates: [phi, psi]
particles:
  A: {position: l*cos(phi)*i}
  B: {position: r*cos(psi)*i}
forces: {push: {on: A, vector: -F*i}, pull: {on: B, vector: F*i}}
"""


def idle(text: str) -> list[str]:
    e = solve(read_problem(Source("problem.yaml", text))).own.equilibrium
    assert e is not None
    return [" ".join(map(str, names)) for names in e.idle]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        (CYLINDRICAL, ["phi", "phi", "", ""]),  # ρ = 0 with φ = ±π/2; then ρ = ±F/k
        (SPHERICAL, ["phi", "phi"]),
        (CROSS_WIND, ["phi", "phi", "", ""]),
        (CHAIN, [""]),
        (CRANK, ["", "", "", ""]),  # dead centres: δφ moves nothing at φ = 0, but φ has a position of its own
    ],
)
def test_coordinates_that_move_nothing(text: str, names: list[str]) -> None:
    assert idle(text) == names


def words(text: str) -> str:
    e = solve(read_problem(Source("problem.yaml", text))).own.equilibrium
    assert e is not None
    blocks = explain_virtual_work(e, None).body
    return " ".join(p for b in blocks if isinstance(b, Prose) for p in b.parts if isinstance(p, str))


def test_it_is_said() -> None:
    """Without a horizontal force every φ serves at the pole; with one the pole is no equilibrium of a free particle."""
    assert "the coordinates are singular there" in words(SPHERICAL)
    assert "fixed by other means" not in words(SPHERICAL)
    assert "fixed by other means" in words(CYLINDRICAL)
    assert "singular" not in words(CHAIN)


def test_the_poles_of_a_choice_are_no_equilibria_where_the_forces_do_not_balance() -> None:
    """At θ = 0, φ = ±π/2 Q_θ and Q_φ vanish, but nothing balances the force along i."""
    solution = solve(read_problem(Source("problem.yaml", POLES_OF_A_CHOICE)))
    [choice] = solution.choices
    e = choice.equilibrium
    assert e is not None
    assert [len(e.branches), len(e.poles)] == [2, 4]
    assert all(r.lhs.has(sp.tan) or r.lhs.name == "phi" for b in e.branches for r in b.relations)
    assert solution.holds
    said = " ".join(
        p for b in explain_virtual_work(e, None).body if isinstance(b, Prose) for p in b.parts if isinstance(p, str)
    )
    assert "it is no equilibrium" in said


def test_without_a_horizontal_force_the_poles_of_a_choice_are_equilibria() -> None:
    text = POLES_OF_A_CHOICE.replace("vector: F*i", "vector: -F*k")
    [choice] = solve(read_problem(Source("problem.yaml", text))).choices
    assert choice.equilibrium is not None
    assert [len(choice.equilibrium.branches), len(choice.equilibrium.poles)] == [2, 0]
