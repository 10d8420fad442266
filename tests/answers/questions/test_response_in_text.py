"""A steady state as it is worked out on paper."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.response_in_text import without_hats
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("damped-oscillator", ["X = F/sqrt((c - m*w^2)^2 + b^2*w^2)"], "equivalent"),
        ("damped-oscillator", ["X = F/sqrt((c + m*w^2)^2 + b^2*w^2)"], "wrong"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict


def test_a_hat_is_an_amplitude_here() -> None:
    assert without_hats(Fragment.of(r"\hat{x} = F/c")).text == r"x_{max} = F/c"
    assert without_hats(Fragment.of("x = F/c")).text == "x = F/c"
