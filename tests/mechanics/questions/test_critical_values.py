"""The load at which a column buckles, asked for like any other quantity."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.questions.results import Route
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]
COLUMN = """title: Column of two bars
parameters: [P, K, l]
coordinates: [theta_1, theta_2]
particles: {C: {position: "l*(sin(theta_1) + sin(theta_2))*i + l*(cos(theta_1) + cos(theta_2))*j"}}
forces:
  load: {on: C, vector: -P*j}
  springs: {potential: K*theta_1^2/2 + K*(theta_2 - theta_1)^2/2}
find: equilibrium
"""
PENDULUM = """title: Inverted pendulum between springs
parameters: [m, g, l, k]
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}
gravity: -g*j
forces: {spring: {potential: k*l^2*sin(theta)^2/2}}
find: equilibrium
"""


def test_a_column_buckles_under_the_lowest_load(problem: Read) -> None:
    """The other root of the determinant, (3 + √5) K/(2 l), is no limit of stability."""
    asked = "ask: {load: {quantity: P, when: [theta_1 = 0, theta_2 = 0]}}\n"
    [answer] = solve(problem(COLUMN + asked)).asked
    [branch] = answer.branches
    expected = (3 - sp.sqrt(5)) / 2 * sp.Symbol("K", positive=True) / sp.Symbol("l", positive=True)
    assert answer.route is Route.STABILITY
    assert sp.simplify(branch.rhs - expected) == 0


@pytest.mark.parametrize(("place", "found"), [("0", "g*m/l"), ("pi", None)])
def test_a_stiffness_is_critical_where_stability_depends_on_it(problem: Read, place: str, found: str | None) -> None:
    text = f"{PENDULUM}ask: {{stiffness: {{quantity: k, when: theta = {place}}}}}\n"
    if found is None:  # hanging, it is stable with any spring
        with pytest.raises(ProblemError, match="not determined"):
            solve(problem(text))
        return
    [answer] = solve(problem(text)).asked
    assert str(answer.branches[0].rhs) == found
