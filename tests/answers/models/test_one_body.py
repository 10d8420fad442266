"""A stated force of a constraint that is that of one body by itself is named as such."""

from __future__ import annotations

import pytest

from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.answers.models.slips import examiner


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("ex10-double-pendulum", "T2 = m*g*cos(theta2) + m*l*theta2'^2", "of `B` by itself, as if `A` were not acc"),
        ("ex10-double-pendulum", "T1 = m*g*cos(theta1) + m*l*theta1'^2", "without the reaction of `lower_rod`"),
        ("swinging-atwood", "F = m*(g*cos(theta) + r*theta'^2)", "of `swing` by itself, as if `weight` were not acc"),
    ],
)
def test_the_body_is_named(problem: str, stated: str, said: str) -> None:
    judgement = examiner(problem).check((Fragment.of(stated),))
    assert judgement.verdict is Verdict.WRONG
    assert said in judgement.each[0].diagnosis


def test_another_wrong_force_is_not_called_so() -> None:
    judgement = examiner("ex10-double-pendulum").check((Fragment.of("T2 = m*g*cos(theta2) + 3*m*l*theta2'^2"),))
    assert judgement.verdict is Verdict.WRONG
    assert "by itself" not in judgement.each[0].diagnosis
