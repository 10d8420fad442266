"""Equations of small oscillations as an answer."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.texts.linearized import check_linearized
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.support.shared import solved

FIRST = "m*l*theta1'' + m*g*theta1 + c*l*(theta1 - theta2) = 0"


@pytest.mark.parametrize(
    ("second", "verdict"),
    [
        ("m*l*theta2'' + m*g*theta2 + c*l*(theta2 - theta1) = 0", Verdict.EQUIVALENT),
        ("m*l*(theta1'' + theta2'') + m*g*(theta1 + theta2) = 0", Verdict.EQUIVALENT),  # their sum
        ("m*l*theta2'' + m*g*theta2 + c*l*(theta2 + theta1) = 0", Verdict.WRONG),
        ("m*l*theta2'' - m*g*theta2 + c*l*(theta2 - theta1) = 0", Verdict.WRONG),
    ],
)
def test_coupled_pendulums(second: str, verdict: Verdict) -> None:
    lines = [Fragment.of(f"for small angles: {e}") for e in (FIRST, second)]
    answer = check_linearized(lines, solved("coupled-pendulums"))
    assert answer is not None
    assert [e.verdict for e in answer.equations] == [Verdict.EQUIVALENT, verdict]


def test_equations_that_are_not_marked_are_those_of_the_motion() -> None:
    assert check_linearized([Fragment.of(FIRST)], solved("coupled-pendulums")) is None
