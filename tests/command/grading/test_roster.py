"""Who handed in what, and when."""

from __future__ import annotations

from datetime import datetime

import pytest

from lagsolve.grading.students import Attempts, Roster, attributed, late_by
from lagsolve.grading.table import TableRow
from tests.command.grading.test_students import row


def counted(rows: list[TableRow], attempts: Attempts) -> list[str]:
    return [r.submission for r in attributed(rows, Roster(), "", attempts) if r.counts]


def test_the_best_attempt_counts_or_the_last() -> None:
    rows = [row("anna-1", 1), row("anna-2", 2), row("anna-3", 2), row("anna-10", 0), row("ben", None), row("ben-2", 0)]
    assert counted(rows, Attempts.BEST) == ["anna-2", "ben-2"]
    assert counted(rows, Attempts.LAST) == ["anna-10", "ben-2"]
    assert [r.attempt for r in attributed(rows, Roster(), "", Attempts.BEST)] == [1, 2, 3, 4, 1, 2]
    assert [r.attempt for r in attributed(rows, Roster(), "", None)] == [None] * 6


def test_attempts_are_counted_for_each_problem() -> None:
    rows = [row("a-1", 1, "p"), row("a-1", 0, "q"), row("a-2", 0, "p"), row("a-2", 2, "q")]
    found = attributed(rows, Roster(), "", Attempts.BEST)
    assert [(r.submission, r.problem) for r in found if r.counts] == [("a-1", "p"), ("a-2", "q")]


@pytest.mark.parametrize(
    ("late", "said"), [("18:00:00", ""), ("17:59", ""), ("18:00:20", "1 min"), ("19:00", "1 h"), ("20:05", "2 h 5 min")]
)
def test_how_late(late: str, said: str) -> None:
    assert late_by(datetime.fromisoformat(f"2026-11-20T{late}"), datetime.fromisoformat("2026-11-20T18:00")) == said
