"""The forces of two smooth supports."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.texts.supports import supports_of
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("N_A = W/(2*cos(alpha))", Verdict.EQUIVALENT),  # both planes rise at alpha: N_A = N_B, 2 N_A cos(alpha) = W
        ("N_B*cos(alpha) + N_A*cos(alpha) = W", Verdict.EQUIVALENT),
        ("N_A = W/2", Verdict.WRONG),
        ("N_A = W/(2*sin(alpha))", Verdict.WRONG),
        ("N_B = k*W/cos(alpha)", Verdict.WRONG),
    ],
)
def test_a_force_of_a_support_of_ex_16_is_judged_and_the_other_line_left(line: str, verdict: Verdict) -> None:
    judged = supports_of([Fragment.of(line), Fragment.of("theta = 0")], solved("ex16-rod-on-two-planes"))
    assert judged is not None
    answer, rest = judged
    assert [(e.text, e.verdict) for e in answer.equations] == [(line, verdict)]
    assert answer.verdict is verdict
    assert [f.text for f in rest] == ["theta = 0"]


def test_an_answer_without_such_forces_and_a_system_without_supports_have_no_verdict() -> None:
    assert supports_of([Fragment.of("theta = 0")], solved("ex16-rod-on-two-planes")) is None
    assert supports_of([Fragment.of("N_A = W/2")], solved("roberval-balance")) is None
