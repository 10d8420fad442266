"""Tables that Moodle and Canvas import: the columns that their importers look for, and nothing that a spreadsheet runs."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest

from lagrange.answers.verdicts import Verdict
from lagsolve.grading.students import Roster, read_roster
from lagsolve.grading.table import TableRow
from lagsolve.platforms import marks
from tests.command.grading.test_students import MOODLE


def row(student: str, points: float | None, name: str = "", **more: object) -> TableRow:
    verdict = Verdict.UNDECIDED if points is None else Verdict.EQUIVALENT if points == 2 else Verdict.WRONG
    shared = {"points": points, "possible": 2.0, "student": student} | more
    return TableRow(name or student, verdict, None, None, None, "no <b>", 0.0, **shared)  # type: ignore[arg-type]


def lines(text: str) -> list[list[str]]:
    return list(csv.reader(io.StringIO(text)))


def read(tmp_path: Path, text: str) -> Roster:
    (tmp_path / "r.csv").write_text(text)
    return read_roster(tmp_path / "r.csv", None)


def is_header_of_canvas(row: list[str]) -> bool:
    """`row_has_student_headers?`, `update_column_count` and `last_student_info_column` of lib/gradebook_importer.rb."""
    if not (len(row) > 3 and "Student" in row[0] and "ID" in row[1]):
        return False
    columns = 3
    if "SIS Login ID" in row[2]:
        columns += 1
    elif "SIS User ID" in row[2] and "SIS Login ID" in row[3]:
        columns += 2 + ("Integration ID" in row[4])
        columns += "Root Account" in row[columns]
    return "Section" in row[columns - 1]


CANVAS = """Student,ID,SIS User ID,SIS Login ID,Section,Homework 1 (77),Pendulum (78)
    Points Possible,,,,,5,10
"Bell, Anna",1001,s1,ab1,S1,3,
"Cox, Ben",1002,s2,cb1,S1,4,7
"=cmd()",1003,s3,@e,S1,,2
"""


def test_canvas_with_its_gradebook(tmp_path: Path) -> None:
    table = read(tmp_path, CANVAS)
    rows = [row("1001", 1), row("cb1", None), row("nobody", 2)]
    header, possible, *students = lines(marks.canvas(rows, table, "Pendulum"))
    assert header == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Pendulum (78)"]
    assert is_header_of_canvas(header)
    assert "Points Possible" in possible[0]
    assert possible[5] == "10"
    assert students == [
        ["Bell, Anna", "1001", "s1", "ab1", "S1", "5"],  # 1 of 2, of the 10 that Canvas has
        ["Cox, Ben", "1002", "s2", "cb1", "S1", "7"],  # undecided: the mark that there is stays
        ["'=cmd()", "1003", "s3", "'@e", "S1", "2"],
    ]


def test_canvas_without_a_gradebook() -> None:
    header, possible, *students = lines(marks.canvas([row("1001", 2, "bellanna_1001_5_a.txt")], Roster(), "=Pendulum"))
    assert is_header_of_canvas(header)
    assert header[5] == "'=Pendulum"
    assert possible == ["    Points Possible", "", "", "", "", "2"]
    assert students == [["bellanna", "1001", "", "", "", "2"]]


def test_moodle_with_its_worksheet(tmp_path: Path) -> None:
    header, anna, ben, other = lines(marks.moodle([row("7", 1), row("8", None)], read(tmp_path, MOODLE)))
    assert header == MOODLE.split("\n")[0].split(",")
    assert dict(zip(header, anna, strict=True))["Grade"] == "5"
    assert (anna[0], anna[5]) == ("Participant 7", "Friday, 20 November 2026, 5:30 PM")
    assert ben[3] == other[3] == ""


def test_moodle_gets_comments_where_it_has_a_column_for_them(tmp_path: Path) -> None:
    worksheet = "Identifier,Grade,Last modified (grade),Feedback comments\nParticipant 7,,,\n"
    [_, anna] = lines(marks.moodle([row("7", 1, late="2 h")], read(tmp_path, worksheet)))
    assert anna == ["Participant 7", "1", "", "1/2, wrong. No &lt;b&gt;<br>Handed in late (2 h)."]


def test_moodle_without_a_worksheet() -> None:
    header, anna = lines(marks.moodle([row("7", 2, "Anna Bell_7_assignsubmission_file_a.txt")], Roster()))
    assert {"Identifier", "Grade", "Last modified (grade)"} <= set(header)  # what the importer needs
    assert anna[:3] == ["Participant 7", "Anna Bell", "2"]


def test_marks_are_over_all_problems_and_of_the_attempt_that_counts() -> None:
    rows = [
        row("a", 1, "a-1", problem="p", attempt=1),
        row("a", 2, "a-2", problem="p", attempt=2, counts="yes"),
        row("a", 1, "a-1", problem="q", attempt=1, counts="yes"),
        row("b", 1, "b-x", problem="p"),
        row("b", 2, "b-y", problem="p"),
    ]
    found = marks.marks(rows)
    assert {m.student: (m.score, m.out_of) for m in found.values()} == {"a": (3, 4), "b": (2, 2)}
    assert found["a"].comment.startswith("p: 2/2, equivalent.")
    assert marks.marks([row("a", None), row("a", 1, problem="q")])["a"].score is None


@pytest.mark.parametrize("cell", ["=1+1", "+1", "-1", "@x", "\t=1"])
def test_no_cell_is_a_formula(cell: str, tmp_path: Path) -> None:
    quoted = cell.replace('"', '""')
    canvas = read(tmp_path, f'Student,ID,SIS User ID,SIS Login ID,Section\n"{quoted}",1,"{quoted}",x,y\n')
    moodle = read(tmp_path, f'Identifier,Full name,Grade,Last modified (grade)\nParticipant 7,"{quoted}",,\n')
    for text in (
        marks.canvas([row("1", 1)], canvas, cell),
        marks.moodle([row("7", 1)], moodle),
        marks.moodle([row(cell, 1)], Roster()),
    ):
        for value in (v for line in lines(text) for v in line):
            assert not value.strip().startswith(("=", "+", "-", "@")), value
