"""The parameters that are loads."""

from __future__ import annotations

import sympy as sp

import lagrange
from lagrange.algebra.closed_forms.conditions import further_conditions
from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.mechanics.equilibrium.loads import load_parameters, potential_of_all, solved_for
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


def test_critical_loads() -> None:
    """Two bars with equal springs: λ = P l/k with λ² − 3 λ + 1 > 0 and λ < 2."""
    c, k, l, P = sp.symbols("c k l P", positive=True)
    found = further_conditions(
        [SignCondition(2 * k, ">", l * P), SignCondition(k**2 + l**2 * P**2, ">", 3 * k * l * P)]
    )
    assert found is not None
    [critical] = solved_for(found, [P])
    assert (critical.lhs, critical.relation) == (P, "<")
    assert sp.simplify(critical.rhs - (3 - sp.sqrt(5)) * k / (2 * l)) == 0
    [linear] = solved_for([SignCondition(c + k * l**2, ">", l * P)], [P])
    assert (linear.lhs, linear.relation, linear.rhs) == (P, "<", c / l + k * l)


def test_a_condition_on_several_loads_has_each_on_one_side() -> None:
    """b (4a P + b Q) > 2P (a² + b²) is b² Q > 2P (a − b)²; what is quadratic in the loads stays as it is."""
    a, b, P, Q = sp.symbols("a b P Q", positive=True)
    [bars] = solved_for([SignCondition(b * (4 * a * P + b * Q), ">", 2 * P * (a**2 + b**2))], [P, Q])
    assert (bars.lhs, bars.relation, bars.rhs) == (b**2 * Q, ">", 2 * P * (a - b) ** 2)
    square = SignCondition(P * Q + P, ">", Q)
    assert solved_for([square], [P, Q]) == (square,)
