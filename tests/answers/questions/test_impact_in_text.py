"""An impact as it is worked out on paper."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.impact_in_text import with_losses
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("disc-against-a-step", ["theta' = omega*(1 - 2*h/(3*R))"], "equivalent"),
        ("disc-against-a-step", ["theta' = omega*(1 - h/R)"], "wrong"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict


def test_lines_that_state_the_energy_lost() -> None:
    lines = ["E_lost = m*v^2/4", "x' = v/2"]
    assert [lost for _, lost in with_losses([Fragment.of(t) for t in lines])] == [True, False]
