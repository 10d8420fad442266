"""Answers to questions among the lines of a text."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("leaving-a-sphere", ["cos(theta) = 2/3"], "incomplete"),
        ("leaving-a-sphere", ["cos(theta) = 1/3"], "wrong"),
        ("thrown-stone", ["range = v^2*sin(2*alpha)/g"], "incomplete"),
        ("thrown-stone", ["height = v^2*sin(alpha)^2/2 g"], "incomplete"),
        ("thrown-stone", ["height = v^2*sin(alpha)^2/3 g"], "wrong"),
        ("governor", ["omega = phi'", "omega^2 = (M + m)*g/(m*l*cos(theta))"], "equivalent"),
        ("governor", ["omega = phi'", "omega^2 = M*g/(m*l*cos(theta))"], "wrong"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict
