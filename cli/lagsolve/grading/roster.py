"""The roster of a course: who the students are, and when each submission was handed in.

It is one of

    your own CSV             columns `submission` or `student` or both, and `time`, `due`, `seed` as you like
    Moodle's worksheet       "Download grading worksheet": Identifier, ..., Status, Last modified (submission), Grade
    Canvas' gradebook        "Export": Student, ID, SIS User ID, SIS Login ID, Section, assignments
    Gradescope's metadata    submission_metadata.json: created_at, assignment, previous_submissions

Times are ISO 8601 (`2026-11-20T18:00+01:00`), or as Moodle writes them in English. Late submissions are marked with how
late they are; no points are taken off. A time without a zone is compared with one without, and never with one that has
it.

Moodle's columns are those that its importer looks for (mod/assign/feedback/offline/importgradeslib.php), Canvas'
those of lib/gradebook_importer.rb, Gradescope's keys those of
https://gradescope-autograders.readthedocs.io/en/latest/submission_metadata/.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import field
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.printable import visible
from lagrange.core.records import record
from lagrange.problem.sources import read_source
from lagsolve.limits import MOST_ROSTER_ROWS

_MOODLE_TIMES = ("%A, %d %B %Y, %I:%M %p", "%A, %B %d, %Y, %I:%M %p", "%A, %d %B %Y, %H:%M")
_MOODLE_LATE = re.compile(r"(?P<by>[0-9][\w ]*?)\s+late\b")
_NUMBER_AT_END = re.compile(r"([0-9]+)\s*$")
MOODLE = ("Identifier", "Grade", "Last modified (grade)")
CANVAS = ("Student", "ID", "Section")
_HELP = "it has the columns `submission` or `student`, and `time`: or it is the table that Moodle or Canvas gives out"


@record
class Handed:
    """One thing handed in: by whom, when, and how late; empty texts where that is not known."""

    student: str = ""
    time: datetime | None = None
    late: str = ""
    seed: str = ""

    @property
    def shown_time(self) -> str:
        """The time as ISO 8601."""
        return "" if self.time is None else self.time.isoformat(timespec="seconds")

    @property
    def sort_key(self) -> float:
        """Earlier ones have smaller keys; 0 where the time is not known."""
        if self.time is None:
            return 0.0
        return (self.time if self.time.tzinfo else self.time.replace(tzinfo=UTC)).timestamp()


@record
class Roster:
    """The table, read.

    kind      `own`, `moodle`, `canvas`, `gradescope`; empty if there is none
    lines     header and rows, as in the file
    previous  the best score of earlier attempts, where the platform tells it
    """

    kind: str = ""
    lines: tuple[tuple[str, ...], ...] = ()
    handed: Mapping[str, Handed] = field(default_factory=dict)
    previous: float | None = None

    def of(self, submission: str, student: str) -> Handed:
        """What it says of a submission, by its name with or without the extension, or by its student."""
        for key in (submission, submission.rpartition(".")[0], student, _ONLY):
            if key and key in self.handed:
                return self.handed[key]
        return Handed()


_ONLY = "\0"
"""The key of the only submission that Gradescope's metadata are about."""


def read_roster(path: Path, due: datetime | None) -> Roster:
    """The table in a file. Raises ProblemError where it is none, or too large."""
    text = read_source(path).text
    if text.lstrip().startswith("{"):
        return _gradescope(path, text, due)
    lines = _lines(path, text)
    header = [cell.strip() for cell in lines[0]]
    if all(name in header for name in MOODLE):
        return Roster("moodle", lines, _of_moodle(header, lines[1:], due))
    if all(name in header for name in CANVAS):
        return Roster("canvas", lines)
    return Roster("own", lines, _own(path, [cell.lower() for cell in header], lines[1:], due))


def _lines(path: Path, text: str) -> tuple[tuple[str, ...], ...]:
    """Header and rows, separated by commas, or by semicolons where the header has them."""
    first = text.split("\n", 1)[0]
    separator = ";" if first.count(";") > first.count(",") else ","
    try:
        lines = [tuple(row) for row in csv.reader(io.StringIO(text), delimiter=separator, strict=True) if any(row)]
    except csv.Error as error:
        raise _bad(path, f"is no CSV file: {error}") from None
    if not lines or len(lines) > MOST_ROSTER_ROWS:
        raise _bad(path, "is empty" if not lines else f"has more than {MOST_ROSTER_ROWS:,} rows")
    return tuple(lines)


def _own(path: Path, header: Sequence[str], rows: Sequence[Sequence[str]], due: datetime | None) -> dict[str, Handed]:
    if "submission" not in header and "student" not in header:
        raise _bad(path, "is not a table of students")
    handed: dict[str, Handed] = {}
    for number, row in enumerate(rows, start=2):
        cells = dict(zip(header, (cell.strip() for cell in row), strict=False))
        student, submission = cells.get("student", ""), cells.get("submission", "")
        own_due = cells.get("due", "")
        limit = time_of(own_due, f"{path.name}, row {number}") if own_due else due
        time = time_of(cells["time"], f"{path.name}, row {number}") if cells.get("time") else None
        entry = Handed(visible(student), time, late_by(time, limit), cells.get("seed", ""))
        for key in (submission, student):
            if key:
                handed.setdefault(key, entry)
    return handed


def _of_moodle(header: Sequence[str], rows: Sequence[Sequence[str]], due: datetime | None) -> dict[str, Handed]:
    handed = {}
    for row in rows:
        cells = dict(zip(header, row, strict=False))
        number = _NUMBER_AT_END.search(cells.get("Identifier", ""))
        if number is None:
            continue
        time = _moodle_time(cells.get("Last modified (submission)", ""))
        said = _MOODLE_LATE.search(cells.get("Status", ""))
        handed[number[1]] = Handed(number[1], time, said["by"] if said else late_by(time, due))
    return handed


def _moodle_time(text: str) -> datetime | None:
    for form in _MOODLE_TIMES:
        try:
            return datetime.strptime(" ".join(text.split()), form)
        except ValueError:
            continue
    return None


def _gradescope(path: Path, text: str, due: datetime | None) -> Roster:
    """submission_metadata.json. A user's own due date, an extension, comes before that of the assignment."""
    try:
        data: Any = json.loads(text)
        users = [u for u in data.get("users") or () if isinstance(u, dict)]
        assignment = data.get("assignment") or {}
        extended = [a["due_date"] for u in users if isinstance(a := u.get("assignment"), dict) and a.get("due_date")]
        limits = [*extended, assignment.get("due_date")]
        limit = due or next((time_of(str(t), path.name) for t in limits if t), None)
        time = time_of(str(data["created_at"]), path.name)
        earlier = [float(p["score"]) for p in data.get("previous_submissions") or () if p.get("score") is not None]
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise _bad(path, "is not Gradescope's submission_metadata.json") from None
    student = visible(", ".join(str(u.get("name", "")) for u in users))
    return Roster("gradescope", (), {_ONLY: Handed(student, time, late_by(time, limit))}, max(earlier, default=None))


def time_of(text: str, where: str) -> datetime:
    """A time. Raises ProblemError where the text is none."""
    try:
        return datetime.fromisoformat(text.strip())
    except ValueError:
        message = f"{where}: `{visible(text[:60])}` is not a time"
        help_ = "write a date and time such as `2026-11-20T18:00` or `2026-11-20T18:00+01:00`"
        raise ProblemError(Diagnostic("bad-time", message, help=help_)) from None


def late_by(time: datetime | None, due: datetime | None) -> str:
    """How much later than due: `2 h 5 min`; empty if in time, or not known. Raises ProblemError if one has no zone."""
    if time is None or due is None:
        return ""
    if (time.tzinfo is None) != (due.tzinfo is None):
        message = f"the times {time.isoformat()} and {due.isoformat()} cannot be compared: one of them has no time zone"
        raise ProblemError(Diagnostic("bad-time", message, help="add the zone of both: `2026-11-20T18:00+01:00`"))
    return _duration(time - due) if time > due else ""


def _duration(late: timedelta) -> str:
    minutes = max(1, round(late.total_seconds() / 60))
    days, hours, rest = minutes // 1440, minutes // 60 % 24, minutes % 60
    parts = [f"{n} {unit}" for n, unit in ((days, "d"), (hours, "h"), (rest, "min")) if n]
    return " ".join(parts)


def _bad(path: Path, what: str) -> ProblemError:
    return ProblemError(Diagnostic("bad-roster", f"{path} {what}", help=_HELP))
