"""Contacts that constraints keep from slipping: their friction is the reaction of these constraints, and no second one."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import NotCoveredError
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

HEMISPHERE = """title: A hemisphere on a rough slope
parameters: {m: positive, g: positive, r: positive, alpha: acute, mu: positive}
coordinates: {s: along the slope, y: from the slope, theta: {range: [-90 deg, 90 deg]}}
bodies: {cup: {mass: m, position: "s*i + y*j + 3/8*r*(sin(alpha - theta)*i - cos(alpha - theta)*j)", angle: -theta}}
constraints:
  slope: {equation: y >= r, reaction: N}
  rolling: {equation: "s' = r*theta'", reaction: F}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
forces: {rub: {friction: mu, static: mu, constraint: slope, on: cup, at: s*i + (y - r)*j}}
find: equilibrium
answers:
  equilibrium: ["sin(theta) = 8/3*sin(alpha)", "y = r"]
  reactions: {N: m*g*cos(alpha), F: -m*g*sin(alpha)}
  rest: ["tan(alpha) <= mu"]
"""
WHEEL_AND_BLOCK = """title: A wheel that rolls against a block
parameters: [m, M, g, R, mu, P]
coordinates: [x, y, theta, s, z]
bodies: {wheel: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: -theta}}
particles: {block: {mass: M, position: s*i + z*j}}
constraints:
  floor: {equation: y >= R, reaction: N}
  rolling: {equation: "x' = R*theta'", reaction: F}
  ground: {equation: z >= 0, reaction: N_b}
  rod: {equation: s - x = 3*R, reaction: T}
gravity: -g*j
forces:
  motor: {on: wheel, moment: -P*R*k}
  rub: {static: mu, friction: mu, constraint: floor, on: wheel, at: r_wheel - R*j}
  drag: {static: mu, friction: mu, constraint: ground, on: block}
find: equilibrium
answers: {rest: ["mu >= P/(m*g)", "mu >= P/(M*g)"]}
"""


def test_what_rolls_is_in_equilibrium_and_stable(problem: Read) -> None:
    """V = −m g (r θ sin α + 3/8 r cos θ): sin θ = 8/3 sin α, V'' > 0, and |F| ≤ μ N."""
    solution = solve(problem(HEMISPHERE))
    assert all(c.passed for c in solution.checks)
    assert [a.verdict.value for a in compared_answers(solution)] == ["equivalent"] * 3
    assert solution.own.at_rest is None
    assert solution.own.stability is not None
    [verdict] = solution.own.stability.verdicts
    assert verdict is not None
    assert verdict.verdict in (StabilityVerdict.STABLE, StabilityVerdict.CONDITIONAL)


def test_the_reaction_of_rolling_is_the_friction(problem: Read) -> None:
    """Wheel: F = P, T = −P; block: friction −P. Two forces at the contact made the bound on the wheel disappear."""
    solution = solve(problem(WHEEL_AND_BLOCK))
    [answer] = compared_answers(solution)
    assert answer.verdict.value == "equivalent"
    rest = solution.own.at_rest
    assert rest is not None
    assert rest.verified
    assert rest.open == ()
    assert rest.forces[sp.Symbol("F", real=True)] == sp.Symbol("P", positive=True)


def test_slip_cannot_impend_where_a_constraint_prevents_it(problem: Read) -> None:
    with pytest.raises(NotCoveredError, match="impending slip where the constraint `rolling` keeps"):
        solve(problem(HEMISPHERE.replace("find: equilibrium", "find: impending")))
