"""Texts that answer other questions than for equations of motion."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("damped-oscillator", ["x_max = F/sqrt((c - m*w^2)^2 + b^2*w^2)"], "equivalent"),
        ("disc-against-a-step", ["theta' = omega*(1 - 2*h/(3*R))"], "equivalent"),
        ("ex11-ideal-pendulum", ["theta'' = -g/l*sin(theta)"], "equivalent"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict
