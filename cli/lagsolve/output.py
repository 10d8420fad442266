"""Where a result goes and in what form: format, destination, width, colour."""

from __future__ import annotations

import os
import shutil
import sys
import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from lagrange.core.records import record
from lagsolve.stages import stage_shown

if TYPE_CHECKING:
    from lagrange.answers.verdicts import CheckedAnswer
    from lagrange.core.diagnostics import ProblemError
    from lagrange.explain.report import Report
    from lagrange.problem.model import Problem
    from lagsolve.grading.rows import Row

ENDINGS = {".tex": "latex", ".md": "markdown", ".html": "html", ".json": "json", ".txt": "pretty"}
NARROWEST = 20
PIPED = 80


@record
class Destination:
    """What was asked on the command line; `path` is None for standard output."""

    format: str
    path: Path | None
    fragment: bool
    detail: str
    vectors: str = "bold"

    @classmethod
    def of(
        cls, format_: str | None, output: str | None, fragment: bool, detail: str, vectors: str | None = None
    ) -> Destination:
        """Settles the format from the options. Raises a usage error where they do not fit together."""
        path = Path(output) if output not in (None, "-") else None
        if path and path.is_dir():
            raise click.UsageError(f"{path} is a folder; -o names a file")
        by_ending = ENDINGS.get(path.suffix.lower()) if path else None
        if path and not format_ and not by_ending:
            endings = " ".join(ENDINGS)
            raise click.UsageError(f"{path} does not tell the format; use --format, or one of the endings {endings}")
        chosen = format_ or by_ending or ("latex" if fragment else "pretty")
        if fragment and chosen != "latex":
            raise click.UsageError("--fragment goes with --format latex")
        if vectors and chosen not in ("latex", "markdown"):
            raise click.UsageError("--vectors goes with --format latex or markdown")
        return cls(chosen, path, fragment, detail, vectors or "bold")

    @property
    def is_complete(self) -> bool:
        """Whether what is long, and not printed unasked, is wanted too."""
        return self.format == "json" or self.detail == "full"

    def spare(self, problems: Sequence[str]) -> None:
        """Refuses to write over a file that is about to be read."""
        if self.path is None or not self.path.exists():
            return
        if any(os.path.exists(p) and os.path.samefile(p, self.path) for p in problems):
            raise click.UsageError(f"-o {self.path} would write over the problem file")

    def write(self, reports: Sequence[Report | None]) -> None:
        """Prints the reports, or writes them to the file. None stands for a problem that could not be solved."""
        with stage_shown():
            text = self._text(reports)
        if self.path is None:
            put(text)
            return
        try:
            self.path.write_text(text, encoding="utf-8", newline="\n")
        except OSError as error:
            raise _unwritable(str(self.path), error.strerror) from None

    def _text(self, reports: Sequence[Report | None]) -> str:
        from lagrange.document.derivation import Detail
        from lagrange.render.letters_of_vectors import Vectors

        detail = Detail[self.detail.upper()]
        solved = [(r.derivation, r.notation) for r in reports if r is not None]
        if self.format == "json":
            from lagrange.render import json

            return json.render(reports)
        if self.format == "latex":
            from lagrange.render import latex

            return latex.render(solved, self.fragment, detail, Vectors(self.vectors))
        if self.format == "markdown":
            from lagrange.render import markdown

            return markdown.render(solved, detail, Vectors(self.vectors))
        if self.format == "html":
            from lagrange.render import html

            return html.render(solved, detail)
        from lagrange.render import terminal as pretty

        if self.path is None:
            return "\n".join(pretty.coloured(d, n, terminal_width(), detail) for d, n in solved)
        return "\n".join(pretty.text(d, n, PIPED, detail) for d, n in solved)


def write_verdict(answer: CheckedAnswer, problem: Problem, format_: str, revealed: Sequence[Any] = ()) -> None:
    """Prints what is to be said of an answer to a problem, and the derived equations that are to be revealed."""
    from lagrange.render import verdict

    if format_ == "json":
        import json

        put(json.dumps(verdict.as_object(answer, problem, revealed), ensure_ascii=False, indent=1) + "\n")
    else:
        put(verdict.text(answer, problem, terminal_width(), revealed))


def write_rows(rows: Sequence[Row], as_csv: bool) -> None:
    """Prints the rows of a batch: the table, or CSV."""
    from lagsolve.grading.rows import csv_text, table_text

    on_terminal = sys.stdout is not None and sys.stdout.isatty()
    put(csv_text(rows) if as_csv else table_text(rows, terminal_width(), on_terminal))


def wrapped(line: str, width: int, indent: str) -> str:
    """A line, broken at blanks where it is too wide."""
    if len(line) <= width:
        return line
    return textwrap.fill(line, width, subsequent_indent=indent, break_on_hyphens=False)


def terminal_width() -> int:
    """The width to print at: the terminal's, or what COLUMNS says; 80 where there is neither."""
    return max(NARROWEST, shutil.get_terminal_size().columns) if _has_width() else PIPED


def styled() -> bool:
    """Whether standard output shows bold letters: a terminal does, unless it says that it is dumb."""
    return sys.stdout is not None and sys.stdout.isatty() and os.environ.get("TERM") != "dumb"


def _has_width() -> bool:
    return os.environ.get("COLUMNS", "").isdigit() or (sys.stdout is not None and sys.stdout.isatty())


def put(text: str) -> None:
    """Writes to standard output, at once.

    Raises BrokenPipeError where nobody reads on, and an error with a message where it cannot be written.
    """
    if sys.stdout is None:
        raise _unwritable("standard output", "it is closed")
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        _abandon()
        if isinstance(error, BrokenPipeError):
            raise
        raise _unwritable("standard output", error.strerror) from None


def _unwritable(what: str, reason: str | None) -> ProblemError:
    from lagrange.core.diagnostics import Diagnostic, ProblemError

    return ProblemError(Diagnostic("cannot-write", f"{what} cannot be written: {reason}"))


def _abandon() -> None:
    """Sends what is left in the buffer nowhere, so that Python does not complain about it at its end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
