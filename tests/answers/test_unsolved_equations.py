"""Products in answers about equilibria that have no closed form: every factor counts."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

GATE = """title: Gate held by a torsion spring
parameters: [k, W, l, theta_0]
coordinates: [theta]
particles: {P: {position: l*cos(theta)*i + l*sin(theta)*j}}
forces:
  weight: {on: P, vector: -W*j}
  spring: {potential: k*(theta - theta_0)^2/2}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("factor", "verdict"),
    [
        ("1", "equivalent"),
        ("k*l", "equivalent"),
        ("(theta^2 + 1)", "equivalent"),
        ("(2 + sin(theta))", "equivalent"),
        ("(k*(theta - theta_0) + W*l*cos(theta))", "equivalent"),
        ("theta", "wrong"),
        ("(theta - theta_0)", "wrong"),
        ("cos(theta)", "wrong"),
        ("(W*sin(theta) - k)", "undecided"),  # it has roots for some parameters only
    ],
)
def test_a_factor_that_vanishes_where_nothing_balances_makes_an_answer_wrong(
    problem: Callable[[str], Problem], factor: str, verdict: str
) -> None:
    stated = f"(k*(theta - theta_0) + W*l*cos(theta))*{factor} = 0"
    [answer] = compared_answers(solve(problem(f'{GATE}answers: {{equilibrium: ["{stated}"]}}\n')))
    assert answer.verdict.value == verdict
