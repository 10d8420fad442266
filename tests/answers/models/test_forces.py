"""Mistakes in the applied forces are named."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, name_of, wrong_parts


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
