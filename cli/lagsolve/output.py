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
from lagsolve.limits import NARROWEST, PIPED_WIDTH, WIDEST
from lagsolve.progress_line import stage_shown

if TYPE_CHECKING:
    from lagrange.answers.points import Score
    from lagrange.answers.verdicts import Judgement
    from lagrange.core.diagnostics import ProblemError
    from lagrange.explain.report import Report
    from lagsolve.grading.table import TableRow

ENDINGS = {".tex": "latex", ".md": "markdown", ".html": "html", ".json": "json", ".txt": "pretty"}


@record
class Destination:
    """Format and destination, as the command line asks; `path` is None for standard output."""

    format: str
    path: Path | None
    fragment: bool
    detail: str
    vectors: str = "bold"

    @classmethod
    def of(
        cls, format_: str | None, output: str | None, fragment: bool, detail: str, vectors: str | None = None
    ) -> Destination:
        """The destination that the options describe. Raises a usage error where they contradict one another."""
        path = Path(output) if output not in (None, "-") else None
        if path and path.is_dir():
            raise click.UsageError(f"{path} is a folder; -o names a file")
        by_extension = ENDINGS.get(path.suffix.lower()) if path else None
        if path and not format_ and not by_extension:
            extensions = " ".join(ENDINGS)
            raise click.UsageError(
                f"the extension of {path} does not determine the format; use --format, or one of {extensions}"
            )
        chosen = format_ or by_extension or ("latex" if fragment else "pretty")
        if fragment and chosen != "latex":
            raise click.UsageError("--fragment goes with --format latex")
        if vectors and chosen not in ("latex", "markdown"):
            raise click.UsageError("--vectors goes with --format latex or markdown")
        return cls(chosen, path, fragment, detail, vectors or "bold")

    @property
    def is_complete(self) -> bool:
        """Whether long results that are not printed by default are wanted too."""
        return self.format == "json" or self.detail == "full"

    def refuse_overwrite(self, problems: Sequence[str]) -> None:
        """Raises a usage error where the output would overwrite a problem file."""
        if self.path is None or not self.path.exists():
            return
        if any(os.path.exists(p) and os.path.samefile(p, self.path) for p in problems):
            raise click.UsageError(f"-o {self.path} would overwrite the problem file")

    def write(self, reports: Sequence[Report | None]) -> None:
        """Prints the reports, or writes them to the file. None stands for a problem that could not be solved."""
        with stage_shown("writing the page"):
            text = self._text(reports)
        if self.path is None:
            write_stdout(text)
            return
        from lagsolve.written_files import write_file

        write_file(self.path, text)

    def _text(self, reports: Sequence[Report | None]) -> str:
        from lagrange.document.derivation import Detail
        from lagrange.render.tex_layout import Vectors

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
        from lagrange.render import terminal

        if self.path is None:
            return "\n".join(terminal.coloured(d, n, terminal_width(), detail) for d, n in solved)
        return "\n".join(terminal.text(d, n, PIPED_WIDTH, detail) for d, n in solved)


def write_verdict(answer: Judgement, format_: str, revealed: Sequence[Any] = (), score: Score | None = None) -> None:
    """Prints the verdict on an answer to a problem, the derived equations to be revealed, and the points."""
    if format_ == "json":
        from lagrange.core.printable import json_text

        more = {"points": score.as_json()} if score is not None else {}
        write_stdout(json_text({**answer.as_json(revealed), **more}, indent=1) + "\n")
    else:
        points = "\n" + "".join(f"{line}\n" for line in score.lines()) if score is not None else ""
        write_stdout(answer.text(terminal_width(), revealed) + points)


def write_rows(rows: Sequence[TableRow], as_csv: bool) -> None:
    """Prints the rows of a batch as a table or as CSV."""
    from lagsolve.grading.table import csv_text, table_text

    on_terminal = sys.stdout is not None and sys.stdout.isatty()
    write_stdout(csv_text(rows) if as_csv else table_text(rows, terminal_width(), on_terminal))


def wrapped(line: str, width: int, indent: str) -> str:
    """A line, broken at blanks if it is too wide."""
    if len(line) <= width:
        return line
    return textwrap.fill(line, width, subsequent_indent=indent, break_on_hyphens=False)


def terminal_width() -> int:
    """The width to print at: that of the terminal, or COLUMNS; 80 where there is neither."""
    return min(max(NARROWEST, shutil.get_terminal_size().columns), WIDEST) if _has_width() else PIPED_WIDTH


def styled() -> bool:
    """Whether standard output shows bold letters: a terminal does, unless TERM is `dumb`."""
    return sys.stdout is not None and sys.stdout.isatty() and os.environ.get("TERM") != "dumb"


def _has_width() -> bool:
    return os.environ.get("COLUMNS", "").isdecimal() or (sys.stdout is not None and sys.stdout.isatty())


def write_stdout(text: str) -> None:
    """Writes to standard output, at once.

    Raises BrokenPipeError where the reader has gone, ProblemError where standard output cannot be written.
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
    """Discards what is left in the buffer, so that Python does not complain about it when it exits."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
