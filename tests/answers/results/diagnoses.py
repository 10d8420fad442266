"""Feedback on wrong stated results, with the problems that several tests share."""

from __future__ import annotations

import json

from lagrange.answers.examiner import Examiner
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Source
from lagrange.problem.stated_answers import read_answers
from tests.support.shared import loaded, solved

LADDER = "ladder-on-rough-ground"
Row = tuple[str, str, object, str]
"""A problem, a key of its answers, what is stated there, and a part of what is said of it."""


def diagnoses(problem: str, answers: object) -> tuple[Verdict, str]:
    """The verdict on answers, with all feedback."""
    read = read_answers(Source("answers", json.dumps(answers)), loaded(problem))
    [other] = Examiner(loaded(problem), solved(problem, complete=False)).check_answers(read).others
    return other.verdict, "; ".join([other.diagnosis, *(e.diagnosis for e in other.equations)])


def assert_explained(problem: str, key: str, stated: object, said: str) -> None:
    """The stated result is wrong, and the feedback contains this text."""
    verdict, diagnosis = diagnoses(problem, {key: stated})
    assert verdict in (Verdict.WRONG, Verdict.INCOMPLETE) if key == "rest" else verdict is Verdict.WRONG
    assert said in diagnosis
