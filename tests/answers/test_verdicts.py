"""Verdicts as JSON, and as exit statuses."""

from __future__ import annotations

from dataclasses import replace

from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Judgement, Verdict
from lagrange.core.diagnostics import Diagnostic, Severity
from tests.answers.test_equations import (
    INCOMPLETE,
    TABLE,
    solved_reference,
    verdict_on,
)
from tests.support.shared import loaded


def test_the_shape_of_json() -> None:
    found = verdict_on(TABLE["16"][1], solved_reference("spherical")).as_json()
    assert found["verdict"] == INCOMPLETE
    assert found["missing"] == 1
    equation = found["equations"][0]  # type: ignore[index]
    assert set(equation) == {"text", "verdict", "diagnosis", "remarks"}
    assert equation["text"] == TABLE["16"][1]


def test_what_another_question_judges_is_not_said_to_be_unjudged() -> None:
    def note(text: str) -> Diagnostic:
        return Diagnostic("not-judged", f"`{text}` is working, and is not judged", level=Severity.NOTE)

    motion = AnswerVerdict(Verdict.EQUIVALENT, notes=(note("A = F/k"), note("E = const")))
    response = AnswerVerdict(Verdict.WRONG, (EquationVerdict("A = F/k", Verdict.WRONG),), name="response")
    judgement = Judgement(motion, (response,), problem=loaded("damped-oscillator"))
    assert [m.message for m in judgement.messages] == [note("E = const").message]
    unread = replace(response, equations=(EquationVerdict("A = F/k", Verdict.UNREADABLE),))
    assert len(replace(judgement, others=(unread,)).messages) == 2
