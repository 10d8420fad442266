"""What is said of wrong answers that were derived from wrong models."""

from __future__ import annotations

import pytest

from lagrange.answers.models.table import MODELS
from lagrange.answers.verdicts import Verdict
from tests.answers.models.slips import WrongAnswer, helps, judged, wrong_answers, wrong_parts

ANSWERS: dict[str, list[WrongAnswer]] = {}
for wrong in wrong_answers():
    ANSWERS.setdefault(wrong.problem, []).append(wrong)

UNEXPLAINED = {
    "cylinder-in-cylinder: R for R - r",
    "swinging-yo-yo: offset r left out",
}
"""Where another cause, or none, is named."""


def test_there_are_enough_answers() -> None:
    assert len(ANSWERS) >= 25
    assert sum(map(len, ANSWERS.values())) >= 70
    names = {m.name for m in MODELS}
    assert len(names) == len(MODELS)


@pytest.mark.parametrize("problem", ANSWERS)
def test_the_cause_is_named(problem: str) -> None:
    for answer in ANSWERS[problem]:
        judgement = judged(answer)
        assert judgement.verdict is Verdict.WRONG, answer.mistake
        parts = wrong_parts(judgement)
        assert all(part.diagnosis for part in parts)
        if answer.expected and f"{answer.problem}: {answer.mistake}" not in UNEXPLAINED:
            assert helps(answer, judgement), (answer.mistake, [part.diagnosis for part in parts])
