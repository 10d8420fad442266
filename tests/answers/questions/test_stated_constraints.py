"""Answers about constraints."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.stated_constraints import about_constraints
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved

NAME = "rolling-coin"


def test_a_problem_that_asks_for_constraints_alone() -> None:
    assert not about_constraints(solved("ex11-ideal-pendulum"))
    assert not about_constraints(None)


@pytest.mark.parametrize(("text", "verdict"), [("x*dx + y*dy = 0", "incomplete"), ("x*dy + y*dx = 0", "wrong")])
def test_forms_of_a_pendulum(text: str, verdict: str) -> None:
    examiner = Examiner(loaded("ex11-ideal-pendulum"), solved("ex11-ideal-pendulum"))
    assert examiner.check((Fragment.of(text),)).verdict.value == verdict
