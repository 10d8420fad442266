"""Whose submission it is: the student from the name of a file, attempts, and which of them counts.

Platforms name the files that they give out. Moodle: `Anna Bell_12345_assignsubmission_file_answer.txt`, or a folder of
that name without the file's; Canvas: `bellanna_LATE_1001_2002_answer.txt`, with the numbers of the student and of the
file, and `LATE` after the due date. Elsewhere the student is the name without its extension, and without a final number
where attempts are counted: `anna-2.txt`, `anna attempt 2.tex`, `anna (2).md`.

The time at which a file was last changed does not tell when it was handed in: it is that of the download, or whatever
its author set. Only the platform knows: see `roster`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from enum import StrEnum

from lagrange.core.records import record
from lagsolve.grading.roster import Handed, Roster
from lagsolve.grading.table import TableRow

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
