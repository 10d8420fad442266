"""Mistakes that several made, below the table of a batch."""

from __future__ import annotations

from lagrange.answers.submissions import Graded
from lagrange.answers.verdicts import EquationVerdict, Verdict
from lagsolve.grading.table import TableRow, table_text


def row(name: str, *causes: str) -> TableRow:
    equations = tuple(EquationVerdict("x'' = 0", Verdict.WRONG, cause=c) for c in causes)
    return TableRow.of(name, Graded(Verdict.WRONG, "wrong", equations=equations))


def test_identical_mistakes_are_counted_once_a_submission() -> None:
    coriolis, weight = "without the Coriolis terms", "without the weight of `bob`"
    rows = [row("a", coriolis, coriolis), row("b", coriolis), row("c", weight), row("d", coriolis, weight), row("e")]
    below = table_text(rows, 80, False).splitlines()[-4:]
    assert "3 of 5: without the Coriolis terms" in below
    assert "2 of 5: without the weight of `bob`" in below


def test_what_one_alone_did_is_not_listed() -> None:
    assert "of 2" not in table_text([row("a", "without gravity"), row("b")], 80, False)
