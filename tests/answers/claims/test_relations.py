"""Relations under a condition."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import answer_to
from lagrange.core.diagnostics import Source
from tests.support.shared import loaded, solved

SPRING = "m r'' = m r phi'^2 - c (r - l) + m g cos(phi)\nr phi'' + 2 r' phi' = -g sin(phi)\nomega_1 = sqrt(c/m)\nomega_2 = sqrt(g/(l + m g/c))\n"


def verdict_on(name: str, text: str) -> str:
    examiner = Examiner(loaded(name), solved(name))
    return examiner.check(answer_to(examiner, Source("answer", text), ".txt")).verdict.value


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("omega_1 = 2 omega_2 if c l = 3 m g", "equivalent"),
        ("omega_1 = 2 omega_2 if c l = 4 m g", "wrong"),
        ("If c = 3 m g/l, then omega_1 = 2 omega_2", "equivalent"),
        ("If l = 2 m g/c, then omega_1 = 2 omega_2", "wrong"),
    ],
)
def test_a_relation_is_tried_under_its_condition(claim: str, verdict: str) -> None:
    """c/m = 4 g/(l + m g/c) is c l + m g = 4 m g."""
    assert verdict_on("spring-pendulum", SPRING + claim) == verdict
