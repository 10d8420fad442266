"""The parameters that are loads."""

from __future__ import annotations

import sympy as sp

import lagrange
from lagrange.mechanics.equilibrium.loads import load_parameters, potential_of_all
from lagrange.mechanics.solution import solve

COLUMN = """
title: Bar on a spring
parameters: [l, c, P]
coordinates: [theta]
particles: {top: {position: l*sin(theta)*i + l*cos(theta)*j}}
forces: {load: {on: top, vector: -P*j}, spring: {potential: c*theta^2/2}}
find: equilibrium
"""


def test_the_size_of_a_force_and_no_stiffness() -> None:
    configuration = solve(lagrange.loads(COLUMN), complete=False).own.configuration
    assert [s.name for s in load_parameters(configuration)] == ["P"]


def test_a_given_lagrangian_has_no_accelerations_at_rest() -> None:
    text = "title: T\nparameters: [m, l, g]\ncoordinates: [q]\nfind: equilibrium\n"
    solution = solve(lagrange.loads(text + 'lagrangian: "m*l^2*q\'^2/2 + m*g*l*cos(q)"\n'), complete=False)
    assert solution.own.equilibrium is not None
    branches = solution.own.equilibrium.branches
    assert [[str(r.rhs) for r in b.relations] for b in branches] == [["0"], ["pi"]]
    assert all(c.passed for c in solution.checks)


def test_the_potential_of_all_forces() -> None:
    """c θ²/2 + P l cos θ."""
    rest = solve(lagrange.loads(COLUMN), complete=False).own.equilibrium
    assert rest is not None
    whole = potential_of_all(rest.configuration, rest.independent_forces[0])
    assert whole is not None
    values = {"c": 2, "P": 3, "l": 5, "theta": 0}
    assert whole.xreplace({s: sp.Integer(values[s.name]) for s in whole.free_symbols}) == 15


def test_no_potential_of_a_follower() -> None:
    text = COLUMN.replace("vector: -P*j", "vector: -P*(sin(theta)*i + cos(theta)*j)")
    rest = solve(lagrange.loads(text), complete=False).own.equilibrium
    assert rest is not None
    assert potential_of_all(rest.configuration, rest.independent_forces[0]) is None
