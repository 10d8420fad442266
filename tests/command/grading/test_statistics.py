"""The page about a class: numbers, and nothing about anybody."""

from __future__ import annotations

import csv
import io
import re
import xml.etree.ElementTree as ET

from lagrange.answers.verdicts import Verdict
from lagsolve.grading.statistics import mistakes, page, table
from lagsolve.grading.table import TableRow

TITLES = {"p": "Pendulum <b>", "q": "Bead"}


def row(student: str, points: float | None, causes: str = "", problem: str = "p", late: str = "") -> TableRow:
    verdict = Verdict.UNDECIDED if points is None else Verdict.EQUIVALENT if points == 2 else Verdict.WRONG
    given = {
        "mistakes": causes,
        "points": points,
        "possible": 2.0,
        "problem": problem,
        "student": student,
        "late": late,
    }
    return TableRow(f"{student}.txt", verdict, None, 2, None, f"remark on {student}", 0.1, f"{student}.md", **given)  # type: ignore[arg-type]


ROWS = [
    row("anna", 2),
    row("ben", 0, "without gravity; a sign"),
    row("carla", 1, "without gravity"),
    row("dora", 0, "=a mistake of her own", late="2 h"),
    row("emil", None),
    row("anna", 2, problem="q"),
]


def test_mistakes_of_one_alone_are_counted_and_not_told() -> None:
    assert mistakes(ROWS) == ([("without gravity", 2)], 2)
    shown = page(TITLES, ROWS)
    assert "without gravity" in shown
    assert "her own" not in shown + table(TITLES, ROWS)
    assert "2 other mistakes were made by one person each" in shown


def test_nothing_is_about_one_person() -> None:
    for text in (page(TITLES, ROWS), table(TITLES, ROWS)):
        assert not re.search("anna|ben|carla|dora|emil|remark", text)


def test_the_page_needs_nothing_else() -> None:
    shown = page(TITLES, ROWS)
    assert "<script" not in shown
    assert "Pendulum &lt;b&gt;" in shown
    assert not re.search(r"(?:src|href|url)\s*[=(]", shown)
    pictures = re.findall(r"<svg.*?</svg>", shown, re.DOTALL)
    assert len(pictures) == 4  # verdicts and points of two problems
    for picture in pictures:
        ET.fromstring(picture)
    assert "5 people handed something in." in shown
    assert "1 of 5 were handed in late." in shown
    assert "Mean 38 % of the points." in shown


def test_the_table_has_the_same_numbers() -> None:
    header, *lines = csv.reader(io.StringIO(table(TITLES, ROWS)))
    assert header == ["problem", "what", "which", "number", "of"]
    found = {(line[0], line[1], line[2]): (line[3], line[4]) for line in lines}
    assert found["p", "verdict", "wrong"] == ("3", "5")
    assert found["p", "points", "50 to 60 %"] == ("1", "5")
    assert found["p", "points", "90 to 100 %"] == ("1", "5")
    assert found["p", "mistake", "without gravity"] == ("2", "5")
    assert found["p", "late", ""] == ("1", "5")
    assert found["q", "verdict", "equivalent"] == ("1", "1")


def test_nobody_handed_anything_in() -> None:
    assert "Nobody answered it" in page(TITLES, [])
    assert len(table(TITLES, []).splitlines()) == 1
