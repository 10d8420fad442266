"""Who handed in what and when: names of platforms, attempts, times, what is late."""

from __future__ import annotations

import json
from datetime import datetime
from pathlib import Path

import pytest

from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import ProblemError
from lagsolve.grading.students import Attempts, Identity, Roster, attributed, identity, read_roster
from lagsolve.grading.table import TableRow


@pytest.mark.parametrize(
    ("name", "platform", "found"),
    [
        ("Anna Bell_12345_assignsubmission_file_answer.txt", "moodle", Identity("12345")),
        ("Anna_B Bell_12345_assignsubmission_onlinetext", "moodle", Identity("12345")),
        ("Anna Bell_12345_assignsubmission_file_", "moodle", Identity("12345")),
        ("bellanna_1001_2002_answer.txt", "canvas", Identity("1001", 2002)),
        ("bellanna_LATE_1001_2002_my_answer-1.txt", "canvas", Identity("1001", 2002, True)),
        ("bellanna_1001_text.html", "canvas", Identity("1001")),
        ("anna.txt", "canvas", Identity("anna")),
        ("bellanna_1001_2002_answer.txt", "", Identity("bellanna_1001_2002_answer")),
        ("anna.bell", "", Identity("anna")),
    ],
)
def test_the_names_that_platforms_give(name: str, platform: str, found: Identity) -> None:
    assert identity(name, platform) == found


@pytest.mark.parametrize(
    ("name", "student", "number"),
    [
        ("anna-2.txt", "anna", 2),
        ("anna attempt 12.tex", "anna", 12),
        ("anna (3).md", "anna", 3),
        ("anna_v2", "anna", 2),
        ("anna.txt", "anna", 0),
        ("anna2.txt", "anna2", 0),
        ("-2.txt", "-2", 0),
        ("2.txt", "2", 0),
    ],
)
def test_a_number_at_the_end_is_that_of_an_attempt(name: str, student: str, number: int) -> None:
    assert identity(name, with_attempts=True) == Identity(student, number)
    assert identity(name).order == 0


def row(name: str, points: float | None, problem: str = "") -> TableRow:
    verdict = Verdict.UNDECIDED if points is None else Verdict.EQUIVALENT
    return TableRow(name, verdict, None, None, None, "", 0.0, points=points, possible=2.0, problem=problem)


def roster(tmp_path: Path, text: str, due: str | None = None, name: str = "r.csv") -> Roster:
    (tmp_path / name).write_text(text, encoding="utf-8")
    return read_roster(tmp_path / name, None if due is None else datetime.fromisoformat(due))


def test_a_table_of_ones_own_says_when(tmp_path: Path) -> None:
    table = roster(
        tmp_path,
        "submission,student,time,due,seed\nx.txt,anna,2026-11-20T18:30+01:00,,s1\ny,anna,2026-11-20T10:00Z,,\n"
        "z.txt,ben,2026-11-21T18:00+01:00,2026-11-22T18:00+01:00,\n",
        "2026-11-20T18:00+01:00",
    )
    found = attributed([row("x.txt", 1), row("y.md", 1), row("z.txt", 1), row("q", 1)], table, "", Attempts.LAST)
    assert [(r.student, r.late, r.attempt, r.counts) for r in found] == [
        ("anna", "30 min", 2, "yes"),
        ("anna", "", 1, ""),
        ("ben", "", 1, "yes"),  # who has an extension
        ("q", "", 1, "yes"),
    ]
    assert [r.submitted for r in found] == [
        "2026-11-20T18:30:00+01:00",
        "2026-11-20T10:00:00+00:00",
        "2026-11-21T18:00:00+01:00",
        "",
    ]
    assert table.of("x.txt", "").seed == "s1"


MOODLE = (
    "Identifier,Full name,Status,Grade,Maximum Grade,Last modified (submission),Last modified (grade)\n"
    'Participant 7,Anna,Submitted for grading,,10,"Friday, 20 November 2026, 5:30 PM",-\n'
    'Participant 8,Ben,Submitted for grading - 2 hours 5 mins late,,10,"Friday, November 20, 2026, 8:05 PM",-\n'
    "Participant 9,C,No submission,,10,-,-\n"
)


def test_moodles_worksheet_says_when(tmp_path: Path) -> None:
    table = roster(tmp_path, MOODLE, "2026-11-20T17:00")
    assert table.kind == "moodle"
    assert (table.of("", "7").late, table.of("", "7").shown_time) == ("30 min", "2026-11-20T17:30:00")
    assert (table.of("", "8").late, table.of("", "8").shown_time) == ("2 hours 5 mins", "2026-11-20T20:05:00")
    assert table.of("", "9").time is None


METADATA = {  # the example of the documentation, shortened
    "id": 123456,
    "created_at": "2018-07-01T14:22:32.365935-07:00",
    "assignment": {"due_date": "2018-07-01T13:22:00.000000-07:00", "late_due_date": None, "total_points": "20.0"},
    "submission_method": "upload",
    "users": [{"email": "student@example.com", "id": 1234, "name": "Student User"}],
    "previous_submissions": [
        {"submission_time": "2017-04-06T14:24:48.087023-07:00", "score": 1.5, "results": {}},
        {"submission_time": "2017-04-07T14:24:48.087023-07:00", "score": None},
    ],
}


def test_gradescopes_metadata_say_when(tmp_path: Path) -> None:
    table = roster(tmp_path, json.dumps(METADATA), name="submission_metadata.json")
    assert (table.kind, table.previous) == ("gradescope", 1.5)
    assert (table.of("submission", "x").late, table.of("submission", "x").student) == ("1 h 1 min", "Student User")
    extended = METADATA | {"users": [{"name": "S", "assignment": {"due_date": "2018-07-02T00:00:00-07:00"}}]}
    assert roster(tmp_path, json.dumps(extended), name="m.json").of("s", "s").late == ""


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("a,b\n1,2\n", "bad-roster"),
        ("", "bad-roster"),
        ("{", "bad-roster"),
        ('{"created_at": 3}', "bad-time"),
        ('{"users": 3, "created_at": "2026-01-01"}', "bad-roster"),
        ("student,time\nanna,yesterday\n", "bad-time"),
        ("student,time\nanna,2026-11-20T18:00\n", "bad-time"),  # no zone, and the due date has one
        ('student,time\n"anna', "bad-roster"),
    ],
)
def test_a_table_that_cannot_be_used(text: str, code: str, tmp_path: Path) -> None:
    with pytest.raises(ProblemError) as error:
        roster(tmp_path, text, "2026-11-20T18:00+01:00")
    assert [d.code for d in error.value.diagnostics] == [code]
