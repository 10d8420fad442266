"""Whose submission it is: the student from the name of a file, attempts, and which of them counts.

Platforms name the files that they give out. Moodle: `Anna Bell_12345_assignsubmission_file_answer.txt`, or a folder of
that name without the file's; Canvas: `bellanna_LATE_1001_2002_answer.txt`, with the numbers of the student and of the
file, and `LATE` after the due date. Elsewhere the student is the name without its extension, and without a final number
where attempts are counted: `anna-2.txt`, `anna attempt 2.tex`, `anna (2).md`.

The time at which a file was last changed does not tell when it was handed in: it is that of the download, or whatever
its author set. Only the platform knows: see the roster below.

The roster of a course: who the students are, and when each submission was handed in.

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
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from datetime import UTC, datetime, timedelta
from enum import StrEnum
from pathlib import Path
from typing import Any

from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.printable import visible
from lagrange.core.records import record
from lagrange.problem.sources import read_source
from lagsolve.grading.table import TableRow
from lagsolve.limits import MOST_ROSTER_ROWS

_MOODLE = re.compile(r"(?P<who>.+)_(?P<id>[0-9]+)_assignsubmission_(?:file|onlinetext)(?:_(?P<rest>.*))?")
_CANVAS = re.compile(r"(?P<who>\w*?)(?P<late>_LATE)?_(?P<id>[0-9]+)_(?:(?P<file>[0-9]+)_)?(?P<rest>.+)")
_ATTEMPT = re.compile(
    r"(?P<who>.*?[^\s_.(-])(?:[-_. ]+(?:attempt|try|version|v)?[-_. ]*|\s*\()(?P<number>[0-9]{1,3})\)?", re.IGNORECASE
)
_EXTENSION = re.compile(r"\.[A-Za-z]{1,5}$")


class Attempts(StrEnum):
    """Which of several attempts counts."""

    BEST = "best"
    LAST = "last"


@record
class Identity:
    """What the name of a submission tells.

    student  the name to group by: the platform's number, or what the file is called
    order    later attempts have larger numbers
    late     whether the platform says that it is late
    """

    student: str
    order: int = 0
    late: bool = False


def identity(name: str, platform: str = "", with_attempts: bool = False) -> Identity:
    """What the name of a submission tells, on a platform (`moodle`, `canvas`) or elsewhere."""
    if platform == "moodle" and (moodle := _MOODLE.fullmatch(name)):
        return Identity(moodle["id"])
    if platform == "canvas" and (canvas := _CANVAS.fullmatch(name)):
        return Identity(canvas["id"], int(canvas["file"] or 0), canvas["late"] is not None)
    stem = _EXTENSION.sub("", name)
    if with_attempts and (attempt := _ATTEMPT.fullmatch(stem)):
        return Identity(attempt["who"], int(attempt["number"]))
    return Identity(stem)


def attributed(rows: Sequence[TableRow], roster: Roster, platform: str, attempts: Attempts | None) -> list[TableRow]:
    """The rows with their students, times and lateness, and, of several attempts at a problem, the one that counts."""
    handed = [_handed(row, roster, platform, attempts is not None) for row in rows]
    named = [
        replace(row, student=h.student, submitted=h.shown_time, late=h.late)
        for row, (h, _) in zip(rows, handed, strict=True)
    ]
    if attempts is None:
        return named
    groups: dict[tuple[str, str], list[int]] = {}
    for n, row in enumerate(named):
        groups.setdefault((row.student, row.problem), []).append(n)
    for group in groups.values():
        in_order = sorted(group, key=lambda n: (handed[n][0].sort_key, handed[n][1], rows[n].submission))
        counting = _counting([named[n] for n in in_order], attempts)
        for number, n in enumerate(in_order):
            named[n] = replace(named[n], attempt=number + 1, counts="yes" if number == counting else "")
    return named


def _handed(row: TableRow, roster: Roster, platform: str, with_attempts: bool) -> tuple[Handed, int]:
    """Who handed it in, and when; and the number in its name."""
    who = identity(row.submission, platform, with_attempts)
    handed = roster.of(row.submission, who.student)
    late = handed.late or ("yes" if who.late else "")
    return replace(handed, student=handed.student or who.student, late=late), who.order


def _counting(rows: Sequence[TableRow], attempts: Attempts) -> int:
    """The place of the attempt that counts; of several that are equally good, the first."""
    if attempts is Attempts.LAST:
        return len(rows) - 1
    return max(range(len(rows)), key=lambda n: (-1.0 if (points := rows[n].points) is None else points, -n))


def rows_that_count(rows: Iterable[TableRow]) -> list[TableRow]:
    """The rows that count: all of them where attempts are not counted."""
    return [row for row in rows if row.attempt is None or row.counts]


# Roster


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
    """The table in a file. Raises ProblemError if it is none, or too large."""
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
    """A time. Raises ProblemError if the text is none."""
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
