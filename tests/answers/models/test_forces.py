"""Mistakes in the applied forces are named."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, feedback_on, name_of, wrong_parts


@pytest.mark.parametrize("answer", answers_by("forces"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)


CART = """
title: Cart on a spring with a pendulum
axes: {i: right, j: down}
parameters: [M, m, l, k, g]
coordinates: [x, theta]
particles:
  cart: {mass: M, position: x*i}
  bob: {mass: m, position: "(x + l*sin(theta))*i + l*cos(theta)*j"}
gravity: g*j
forces:
  spring: {potential: k*x^2/2}
"""


def test_a_spring_on_what_is_carried() -> None:
    """V = k (x + l sin(theta))²/2."""
    judgement = Examiner.of(read_problem(Source("problem.yaml", CART))).check(
        (
            Fragment.of("(M + m)*x'' + m*l*(theta''*cos(theta) - theta'^2*sin(theta)) + k*(x + l*sin(theta)) = 0"),
            Fragment.of(
                "m*l*theta'' + m*x''*cos(theta) + m*g*sin(theta) + k*cos(theta)*(x + l*sin(theta)) = 0",
            ),
        )
    )
    assert [e.model for e in wrong_parts(judgement)] == ["force on what is carried"] * 2


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (
            "rough-wedge",
            "M*X'' = -m*(g*cos(alpha) + X''*sin(alpha))*sin(alpha); s'' + X''*cos(alpha) = g*sin(alpha) - mu*(g*cos(alpha) + X''*sin(alpha))",
            "without the friction `drag`",
        ),
        (
            "wheel-suspension",
            "M*z1'' + b*(z1' - z2') + c*(z1 - z2) = 0; m*z2'' + c_T*(z2 - u) = 0",
            "`suspension` and `damper` acting on `body` only",
        ),
        (
            "three-link-chain",
            "3*alpha'' + 2*beta''*cos(alpha - beta) + gamma''*cos(alpha - gamma) + 2*beta'^2*sin(alpha - beta) + gamma'^2*sin(alpha - gamma) + g/l*sin(alpha) = 0",
            "without the weights of `B`, `C`",
        ),
    ],
)
def test_reactions_of_forces_on_other_bodies(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
