"""The outcome of a batch: a row for each submission, as a CSV file and as a table on the terminal.

A spreadsheet runs a cell that begins with `=`, `+`, `-` or `@` as a formula. Text from submissions gets an apostrophe
in front, also after a semicolon or a tab, where spreadsheets in some locales begin a new cell.
"""

from __future__ import annotations

import csv
import io
import re
import textwrap
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import fields

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from lagrange.answers.submissions import Graded
from lagrange.answers.verdicts import Verdict
from lagrange.core.printable import visible
from lagrange.core.records import record
from lagsolve.limits import LONGEST_REMARK, MOST_CLUSTERS

FORMULA = re.compile(r"(^\s*|[;\t]\s*[\"']*)(?=[=+\-@＝＋－＠\t\r])")
COLOURS = {Verdict.EQUIVALENT: "green", Verdict.WRONG: "red", Verdict.UNDECIDED: "magenta"}


@record
class TableRow:
    """One submission to one problem; the fields are the columns of the CSV file. Unknown values are None.

    points, possible  by the weights of the problem file, or one for each independent equation; points are None where
                      a person has to look at it
    """

    submission: str
    verdict: Verdict
    right: int | None
    required: int | None
    missing: int | None
    remark: str
    seconds: float
    feedback: str = ""
    mistakes: str = ""
    points: float | None = None
    possible: float | None = None
    problem: str = ""
    student: str = ""
    attempt: int | None = None
    counts: str = ""
    submitted: str = ""
    late: str = ""

    @classmethod
    def of(cls, name: str, graded: Graded, feedback: str = "", problem: str = "", hint: int = 3) -> TableRow:
        """The row of a submission; `feedback` is the name of its page, `hint` says how much the remark may tell."""
        right, required = graded.right, graded.required
        missing = None if right is None or required is None else required - right
        remark = visible(" ".join(graded.at_hint_level(hint).remark.split()))
        if len(remark) > LONGEST_REMARK:
            remark = f"{remark[:LONGEST_REMARK]}..."
        all_causes = [e.cause for e in graded.equations] + [cause for a in graded.others for cause in a.causes]
        causes = dict.fromkeys(visible(cause).replace("; ", ", ") for cause in all_causes if cause)
        mistakes, seconds = "; ".join(causes)[:LONGEST_REMARK], round(graded.seconds, 3)
        common = visible(name), graded.verdict, right, required, missing, remark, seconds, feedback, mistakes
        return cls(*common, graded.points, graded.possible, visible(problem))

    @property
    def counted(self) -> str:
        """`1/2`: one of two equations is right."""
        return "" if self.right is None or self.required is None else f"{self.right}/{self.required}"

    @property
    def is_weighed(self) -> bool:
        """Whether the points are not simply the number of right equations."""
        if self.possible is None:
            return False
        return self.possible != (self.required or 1) or (self.right is not None and self.points != self.right)

    @property
    def points_of(self) -> str:
        """`7.5/10`, or `?/10` where something is undecided; empty if nothing is asked for."""
        points = "?" if self.points is None else f"{self.points:g}"
        return "" if self.possible is None else f"{points}/{self.possible:g}"


def number(value: float) -> str:
    """A number of points, without zeros at its end and with two decimals at most."""
    return f"{value:.2f}".rstrip("0").rstrip(".")


HEADER = b"submission,verdict,right,required,"
"""The first bytes of a CSV file of grades."""


def csv_text(rows: Sequence[TableRow]) -> str:
    """The rows as CSV (RFC 4180), with a line of column names."""
    names = [f.name for f in fields(TableRow)]
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(names)
    writer.writerows([cell(getattr(row, name)) for name in names] for row in rows)
    return text.getvalue()


def cell(value: object) -> str:
    """A value as the text of a cell, which no spreadsheet takes for a formula."""
    if isinstance(value, float):
        return f"{value:.10g}"
    return harmless(value) if isinstance(value, str) else "" if value is None else str(value)


def harmless(text: str) -> str:
    """The text, changed so that no spreadsheet takes it for a formula."""
    return FORMULA.sub(r"\1'", text)


def table_text(rows: Sequence[TableRow], width: int, on_terminal: bool) -> str:
    """The table for a terminal, and below it how many submissions have each verdict."""
    remarks = any(r.remark for r in rows)
    further = _further(rows)
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    table.add_column("submission", overflow="fold", max_width=max(12, width // 3))
    table.add_column("verdict", no_wrap=True)
    table.add_column("right", no_wrap=True, justify="right")
    for name in further:
        table.add_column(name, overflow="fold")
    if remarks:
        table.add_column("remark", overflow="fold")
    for row in rows:
        cells = [Text(row.submission), Text(row.verdict.value, COLOURS.get(row.verdict, "")), Text(row.counted)]
        cells += [Text(shown(row)) for shown in further.values()]
        table.add_row(*cells, *([Text(row.remark)] if remarks else []))
    file = io.StringIO()
    Console(file=file, width=width, height=len(rows), force_terminal=on_terminal or None).print(table)
    lines = [line.rstrip() for line in file.getvalue().splitlines()]
    below = [_summary(rows), *_clusters(rows)]
    return "\n".join([*lines, "", *(textwrap.fill(line, width, subsequent_indent="  ") for line in below), ""])


def _further(rows: Sequence[TableRow]) -> dict[str, Callable[[TableRow], str]]:
    """name -> text: the columns that only some batches have."""
    columns: dict[str, Callable[[TableRow], str]] = {}
    if len({row.problem for row in rows}) > 1:
        columns["problem"] = lambda row: row.problem
    if any(row.is_weighed for row in rows):
        columns["points"] = lambda row: row.points_of
    if any(row.attempt for row in rows):
        columns["attempt"] = lambda row: f"{row.attempt}{' *' if row.counts else ''}"
    if any(row.late for row in rows):
        columns["late"] = lambda row: row.late
    return columns


def _summary(rows: Sequence[TableRow]) -> str:
    count = Counter(row.verdict for row in rows)
    listed = ", ".join(f"{count[v]:,} {v.value}" for v in ORDER if count[v])
    submissions, problems = len({row.submission for row in rows}), len({row.problem for row in rows})
    to = f" to {problems} problems" if problems > 1 else ""
    return f"{submissions:,} submission{'s' if submissions != 1 else ''}{to}: {listed}"


def clusters(rows: Sequence[TableRow]) -> list[tuple[str, int]]:
    """The mistakes that several made and how many, the most frequent first."""
    count = Counter(mistake for row in rows for mistake in row.mistakes.split("; ") if mistake)
    return [(mistake, n) for mistake, n in count.most_common(MOST_CLUSTERS) if n > 1]


def _clusters(rows: Sequence[TableRow]) -> list[str]:
    """`14 of 60: without the weight of `bob``; of several problems, how many answered the one it is about."""
    lines = []
    for problem in dict.fromkeys(row.problem for row in rows):
        asked = [row for row in rows if row.problem == problem]
        where = f"{problem}: " if len(asked) < len(rows) else ""
        lines += [f"{where}{n:,} of {len(asked):,}: {mistake}" for mistake, n in clusters(asked)]
    return lines


ORDER = (
    Verdict.EQUIVALENT,
    Verdict.INCOMPLETE,
    Verdict.TRIVIAL,
    Verdict.WRONG,
    Verdict.UNREADABLE,
    Verdict.UNDECIDED,
)
