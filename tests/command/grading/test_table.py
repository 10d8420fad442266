"""The table of a course."""

from __future__ import annotations

import csv
import io
import re
from dataclasses import replace

import pytest
from rich.cells import cell_len

from lagrange.answers.equations import EquationVerdict, Verdict
from lagrange.answers.submissions import Graded, Submission
from lagsolve.grading.submissions import printable_name
from lagsolve.grading.table import HEADER, TableRow, csv_text, harmless, table_text


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("Zoë 日本.txt", "Zoë 日本.txt"),
        ("a\nb\x1b[2J", "a\\x0ab\\x1b[2J"),
        ("\u202etxt.exe\u2028", "\\u202etxt.exe\\u2028"),
        ("caf\udce9", "caf\\xe9"),
        ("a\\x0ab", "a\\\\x0ab"),
        ("\U000e0041", "\\U000e0041"),
    ],
)
def test_names_are_shown_without_what_cannot_be_seen(name: str, text: str) -> None:
    assert printable_name(name) == text
    text.encode()


def row(name: str = "a.txt", remark: str = "", **more: object) -> TableRow:
    return replace(TableRow(name, Verdict.WRONG, 1, 2, 1, remark, 0.5, "a.md"), **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "text",
    [
        "=1+1",
        "+1",
        "-1",
        "@SUM(A1)",
        '=HYPERLINK("http://x","a")',
        "\t=1",
        "  =1",
        "＝1",
        "x;=1",
        'x;"=1',
        "x\t@a",
        "\r=1",
    ],
)
def test_no_cell_is_a_formula(text: str) -> None:
    for cell in re.split(r"[;\t]", harmless(text)):
        assert not re.match(r"[\s\"']*[=+\-@＝]", cell.replace("'", "x"))
    [_, cells] = list(csv.reader(io.StringIO(csv_text([row(name=text, remark=text)]))))
    assert cells[0] == cells[5] == harmless(text)


def test_plain_cells_stay_as_they_are() -> None:
    for text in ("a.txt", "it is -1 times the right one", "x = 1", "a, b", 'say "yes"', "a; b"):
        assert harmless(text) == text


def test_the_csv_file() -> None:
    text = csv_text([row("ä,1", 'a "b"'), row("b", right=None, required=None, missing=None)])
    assert text.split("\r\n") == [
        "submission,verdict,right,required,missing,remark,seconds,feedback,mistakes,points,possible,"
        "problem,student,attempt,counts,submitted,late",
        '"ä,1",wrong,1,2,1,"a ""b""",0.5,a.md,,,,,,,,,',
        "b,wrong,,,,,0.5,a.md,,,,,,,,,",
        "",
    ]


def test_points_have_columns() -> None:
    rows = [row("a", points=2.5, possible=4), row("b", points=None, possible=4)]
    assert [cells[9:11] for cells in csv.reader(io.StringIO(csv_text(rows)))] == [
        ["points", "possible"],
        ["2.5", "4"],
        ["", "4"],
    ]
    table = table_text(rows, 80, False).splitlines()
    assert [line.split() for line in table[:4]] == [
        ["submission", "verdict", "right", "points"],
        [table[1]],
        ["a", "wrong", "1/2", "2.5/4"],
        ["b", "wrong", "1/2", "?/4"],
    ]
    assert "points" not in table_text([row("a")], 80, False)


def test_a_csv_file_is_known_by_its_header() -> None:
    assert csv_text([]).encode().startswith(HEADER)


def test_a_remark_is_one_line_and_not_long() -> None:
    graded = Graded(Verdict.WRONG, "wrong: no", (EquationVerdict("x", Verdict.WRONG, "first\n" + "y" * 1000),))
    assert TableRow.of("a", graded).remark == "first " + "y" * 294 + "..."


@pytest.mark.parametrize("width", [30, 60, 80, 120])
def test_the_table_fits_and_says_everything(width: int) -> None:
    rows = [
        row("anna_" * 20, "it does not follow from the equations of motion"),
        row("[bold]日本語[/bold].txt", "", verdict=Verdict.EQUIVALENT),
        row("c", "", right=None),
    ]
    text = table_text(rows, width, on_terminal=False)
    table, _, summary = text.strip().rpartition("\n\n")
    assert max(cell_len(line) for line in text.splitlines()) <= width
    assert " ".join(summary.split()) == "3 submissions: 1 equivalent, 2 wrong"
    assert "1/2" in text
    if width >= 80:
        assert "[bold]日本語[/bold].txt" in text
    assert re.sub(r"\s", "", table).count("anna_") + table.count("equivalent") >= 1
    assert "\x1b" not in text


def submission(name: str = "a", content: bytes = b"x", file: str = "f") -> Submission:
    return Submission(name, ((file, content),))
