"""The outcome of a batch: a row for each submission, as a CSV file and as a table on the terminal.

A spreadsheet runs a cell that begins with `=`, `+`, `-` or `@` as a formula. What comes from submissions is made text
by an apostrophe in front, also after a semicolon or a tab, where a spreadsheet of another country begins a new cell.
"""

from __future__ import annotations

import csv
import io
import re
import textwrap
from collections import Counter
from collections.abc import Sequence
from dataclasses import fields

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from lagrange.answers.points import as_number
from lagrange.answers.submissions import Graded
from lagrange.answers.verdicts import Verdict
from lagrange.core.printable import visible
from lagrange.core.records import record
from lagsolve.limits import LONGEST_REMARK, MOST_CLUSTERS

FORMULA = re.compile(r"(^\s*|[;\t]\s*[\"']*)(?=[=+\-@＝＋－＠\t\r])")
COLOURS = {Verdict.EQUIVALENT: "green", Verdict.WRONG: "red", Verdict.UNDECIDED: "magenta"}


@record
class TableRow:
    """One submission; the fields are the columns of the CSV file. Unknown values are None.

    points, possible  only where the problem file gives weights
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

    @classmethod
    def of(cls, name: str, graded: Graded, feedback: str = "") -> TableRow:
        """The row of a submission; `feedback` is the name of its page."""
        right, required = graded.right, graded.required
        missing = None if right is None or required is None else required - right
        remark = visible(" ".join(graded.remark.split()))
        if len(remark) > LONGEST_REMARK:
            remark = f"{remark[:LONGEST_REMARK]}..."
        causes = dict.fromkeys(visible(e.cause) for e in graded.equations if e.cause)
        mistakes, seconds = "; ".join(causes)[:LONGEST_REMARK], round(graded.seconds, 3)
        points = possible = None
        if graded.score is not None and graded.score.weighed:
            points = as_number(graded.score.points) if graded.score.settled else None
            possible = as_number(graded.score.possible)
        counts = right, required, missing
        return cls(visible(name), graded.verdict, *counts, remark, seconds, feedback, mistakes, points, possible)

    @property
    def score(self) -> str:
        """`1/2`: one of two equations is right."""
        return "" if self.right is None or self.required is None else f"{self.right}/{self.required}"

    @property
    def points_of(self) -> str:
        """`7.5/10`, or `?/10` where something is undecided; empty where there are no weights."""
        points = "?" if self.points is None else f"{self.points:g}"
        return "" if self.possible is None else f"{points}/{self.possible:g}"


HEADER = b"submission,verdict,right,required,"
"""The first bytes of a CSV file of grades."""


def csv_text(rows: Sequence[TableRow]) -> str:
    """The rows as CSV (RFC 4180), with a line of column names."""
    names = [f.name for f in fields(TableRow)]
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(names)
    writer.writerows([_cell(getattr(row, name)) for name in names] for row in rows)
    return text.getvalue()


def _cell(value: object) -> str:
    return harmless(value) if isinstance(value, str) else "" if value is None else str(value)


def harmless(text: str) -> str:
    """The text, changed so that no spreadsheet takes it for a formula."""
    return FORMULA.sub(r"\1'", text)


def table_text(rows: Sequence[TableRow], width: int, on_terminal: bool) -> str:
    """The table for a terminal, and below it how many submissions have each verdict."""
    remarks = any(r.remark for r in rows)
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    table.add_column("submission", overflow="fold", max_width=max(12, width // 3))
    table.add_column("verdict", no_wrap=True)
    table.add_column("right", no_wrap=True, justify="right")
    if points := any(r.possible is not None for r in rows):
        table.add_column("points", no_wrap=True, justify="right")
    if remarks:
        table.add_column("remark", overflow="fold")
    for row in rows:
        cells = [Text(row.submission), Text(row.verdict.value, COLOURS.get(row.verdict, "")), Text(row.score)]
        cells += [Text(row.points_of)] if points else []
        table.add_row(*cells, *([Text(row.remark)] if remarks else []))
    file = io.StringIO()
    Console(file=file, width=width, height=len(rows), force_terminal=on_terminal or None).print(table)
    lines = [line.rstrip() for line in file.getvalue().splitlines()]
    below = [_summary(rows), *_clusters(rows)]
    return "\n".join([*lines, "", *(textwrap.fill(line, width, subsequent_indent="  ") for line in below), ""])


def _summary(rows: Sequence[TableRow]) -> str:
    count = Counter(row.verdict for row in rows)
    listed = ", ".join(f"{count[v]:,} {v.value}" for v in ORDER if count[v])
    return f"{len(rows):,} submission{'s' if len(rows) != 1 else ''}: {listed}"


def _clusters(rows: Sequence[TableRow]) -> list[str]:
    """The mistakes that several made, the most frequent first: `14 of 60: without the weight of `bob``."""
    count = Counter(mistake for row in rows for mistake in row.mistakes.split("; ") if mistake)
    common = [(mistake, n) for mistake, n in count.most_common(MOST_CLUSTERS) if n > 1]
    return [f"{n:,} of {len(rows):,}: {mistake}" for mistake, n in common]


ORDER = (
    Verdict.EQUIVALENT,
    Verdict.INCOMPLETE,
    Verdict.TRIVIAL,
    Verdict.WRONG,
    Verdict.UNREADABLE,
    Verdict.UNDECIDED,
)
