"""Tables of marks that Moodle and Canvas import.

Moodle, "Upload grading worksheet": the columns `Identifier` (`Participant 12345`), `Grade` and `Last modified
(grade)` must be there, `Feedback comments` may (mod/assign/feedback/offline/importgradeslib.php). Canvas, "Import" in
the gradebook: `Student`, `ID`, `SIS User ID`, `SIS Login ID`, `Section`, then assignments; a second row with `Points
Possible` (lib/gradebook_importer.rb).

Where the platform's own table is given as a roster its rows and columns are kept, and the marks are scaled to the
maximum that it states. A student whose answer needs a person's judgement gets no new mark, and keeps any
existing one.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Sequence
from html import escape

from lagrange.core.records import record
from lagsolve.grading.students import Roster, rows_that_count
from lagsolve.grading.table import TableRow, cell, number

CANVAS_HEADER = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")
MOODLE_HEADER = ("Identifier", "Full name", "Grade", "Maximum Grade", "Last modified (grade)", "Feedback comments")
_MOODLE_NAME = re.compile(r"(?P<who>.+)_[0-9]+_assignsubmission_.*")
_CANVAS_NAME = re.compile(r"(?P<who>\w*?)(?:_LATE)?_[0-9]+_.*")
_POINTS = "Points Possible"


@record
class Mark:
    """What a student gets: `score` is None if a person has to look at it."""

    student: str
    score: float | None
    out_of: float
    comment: str
    submission: str

    def scaled(self, maximum: float | None) -> str:
        """The mark, out of a maximum; empty if there is none yet."""
        if self.score is None:
            return ""
        return number(self.score if maximum is None else maximum * self.score / self.out_of)


def marks(rows: Sequence[TableRow]) -> dict[str, Mark]:
    """student -> mark: over all problems, of each the attempt that counts, or else the best."""
    best: dict[str, dict[str, TableRow]] = {}
    for row in rows_that_count(rows):
        of_student = best.setdefault(row.student, {})
        before = of_student.get(row.problem)
        if before is None or _worth(row) > _worth(before):
            of_student[row.problem] = row
    return {student: _mark(student, list(by_problem.values())) for student, by_problem in best.items()}


def _worth(row: TableRow) -> float:
    return -1.0 if row.points is None else row.points


def _mark(student: str, rows: Sequence[TableRow]) -> Mark:
    scores = [row.points for row in rows]
    known = [s for s in scores if s is not None]
    out_of = sum(row.possible or 1.0 for row in rows)
    late = next((f"Handed in late ({row.late})." for row in rows if row.late), "")
    said = [_said(row, len(rows) > 1) for row in rows]
    comment = "\n".join(filter(None, (*said, late)))
    return Mark(student, sum(known) if len(known) == len(scores) else None, out_of, comment, rows[0].submission)


def _said(row: TableRow, several: bool) -> str:
    about = f"{row.problem}: " if several else ""
    remark = f" {row.remark[0].upper()}{row.remark[1:]}" if row.remark else ""
    return f"{about}{'to be looked at' if row.points is None else row.points_of}, {row.verdict.value}.{remark}"


def moodle(rows: Sequence[TableRow], roster: Roster) -> str:
    """The grading worksheet with the marks."""
    marked = marks(rows)
    if roster.kind != "moodle":
        lines = [list(MOODLE_HEADER)]
        for mark in marked.values():
            named = _MOODLE_NAME.fullmatch(mark.submission)
            identifier = f"Participant {mark.student}" if named else mark.student
            name = named["who"] if named else mark.student
            lines.append([identifier, name, mark.scaled(None), number(mark.out_of), "-", _html(mark.comment)])
        return _csv(lines)
    header = [c.strip() for c in roster.lines[0]]
    lines = [header]
    for row in roster.lines[1:]:
        cells = [*row, *[""] * (len(header) - len(row))]
        digits = re.search(r"([0-9]+)\s*$", cells[header.index("Identifier")])
        of_row = marked.get(digits[1]) if digits else None
        if of_row is not None and of_row.score is not None:
            cells[header.index("Grade")] = of_row.scaled(_maximum(header, cells))
        if of_row is not None and "Feedback comments" in header:
            cells[header.index("Feedback comments")] = _html(of_row.comment)
        lines.append(cells)
    return _csv(lines)


def _maximum(header: Sequence[str], cells: Sequence[str]) -> float | None:
    """The maximum grade of a row of Moodle's worksheet."""
    column = next((n for n, name in enumerate(header) if name.lower() == "maximum grade"), None)
    return None if column is None else _float(cells[column])


def _float(text: str) -> float | None:
    plain = text.strip().replace(",", ".")
    return float(plain) if re.fullmatch(r"[0-9]{1,9}(?:\.[0-9]{1,9})?", plain) and float(plain) > 0 else None


def canvas(rows: Sequence[TableRow], roster: Roster, assignment: str) -> str:
    """The gradebook with a column for the assignment: that of the roster with its name, or a new one."""
    marked = marks(rows)
    most = max((m.out_of for m in marked.values()), default=1.0)
    if roster.kind != "canvas":
        lines = [[*CANVAS_HEADER, assignment], [f"    {_POINTS}", "", "", "", "", number(most)]]
        for mark in marked.values():
            named = _CANVAS_NAME.fullmatch(mark.submission)
            lines.append([named["who"] if named else mark.student, mark.student, "", "", "", mark.scaled(None)])
        return _csv(lines)
    header = [c.strip() for c in roster.lines[0]]
    students = list(range(header.index("Section") + 1))
    called = re.compile(rf"{re.escape(assignment)}(?: \([0-9]+\))?")
    column = next((n for n, name in enumerate(header) if n not in students and called.fullmatch(name)), None)
    title = assignment if column is None else header[column]
    lines, maximum = [[*(header[n] for n in students), title]], None
    for row in roster.lines[1:]:
        cells = [*row, *[""] * (len(header) - len(row))]
        before = "" if column is None else cells[column].strip()
        if _POINTS in cells[0]:
            maximum = _float(before)
            lines.append([*(cells[n] for n in students), before or number(most)])
            continue
        of_row = _of_student(marked, header, cells)
        lines.append([*(cells[n] for n in students), before if of_row is None else of_row.scaled(maximum) or before])
    return _csv(lines)


def _of_student(marked: dict[str, Mark], header: Sequence[str], cells: Sequence[str]) -> Mark | None:
    """The mark of a row of the gradebook, by Canvas' number, a number or login of the university, or the name."""
    for name in ("ID", "SIS User ID", "SIS Login ID", "Student"):
        if name in header and (key := cells[header.index(name)].strip()) in marked:
            return marked[key]
    return None


def _html(text: str) -> str:
    """A comment as Moodle keeps it."""
    return escape(text).replace("\n", "<br>")


def _csv(lines: Sequence[Sequence[str]]) -> str:
    text = io.StringIO()
    csv.writer(text).writerows([cell(value) for value in line] for line in lines)
    return text.getvalue()
