"""Words on stability beside positions."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved

NAME = "inverted-pendulum-springs"


@pytest.mark.parametrize(
    ("stable", "verdict"),
    [
        ("stable for W > c*l*10^9", "wrong"),
        ("stable for 10*W*l < 11*c*b^2", "wrong"),  # near: it is tried beside its limit
        ("stable for W*l < c*b^2", "incomplete"),
    ],
)
def test_a_wrong_claim_makes_a_right_position_wrong(stable: str, verdict: str) -> None:
    examiner = Examiner(loaded(NAME), solved(NAME))
    alone = examiner.check((Fragment.of("theta = 0"),)).verdict.value
    claimed = examiner.check((Fragment.of(f"theta = 0, {stable}"),)).verdict.value
    assert alone in ("incomplete", "equivalent")
    assert claimed == verdict
