"""Verdicts on values that are stated by name."""

from __future__ import annotations

from lagrange.answers.questions.named_values import check_each
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError


def judged(name: str, fragment: Fragment) -> tuple[Verdict, str]:
    if name == "bad":
        raise ProblemError(Diagnostic("unknown-symbol", "no such name", fragment.span(0, 1)))
    return (Verdict.EQUIVALENT, "") if fragment.text == "1" else (Verdict.WRONG, "it is 1")


def test_the_worst_verdict_counts() -> None:
    stated = {"a": Fragment.of("1"), "b": Fragment.of("2")}
    found = check_each("ask", stated, judged)
    assert found.verdict is Verdict.WRONG
    assert [e.verdict for e in found.equations] == [Verdict.EQUIVALENT, Verdict.WRONG]
    unreadable = check_each("ask", {**stated, "bad": Fragment.of("?")}, judged)
    assert unreadable.verdict is Verdict.UNREADABLE
    assert [d.code for d in unreadable.unreadable] == ["unknown-symbol"]
