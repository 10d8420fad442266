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
from lagsolve.command_group import abandon_stdout
from lagsolve.limits import NARROWEST, PIPED_WIDTH, WIDEST
from lagsolve.progress_line import stage_shown

if TYPE_CHECKING:
    from lagrange.answers.points import Score
    from lagrange.answers.verdicts import Judgement
    from lagrange.core.diagnostics import ProblemError
    from lagrange.document.derivation import Derivation
    from lagrange.document.names import Notation
    from lagrange.explain.report import Report
    from lagrange.render.markdown import Sheet
    from lagrange.render.svg import Figures
    from lagsolve.grading.table import TableRow

ENDINGS = {".tex": "latex", ".md": "markdown", ".html": "html", ".json": "json", ".txt": "pretty"}


@record
class Layout:
    """What a page is made for: a worksheet, its solution, a talk, for which reader; `static`: nothing moves on it."""

    worksheet: bool = False
    solution: bool = False
    beamer: bool = False
    reader: str = "github"
    static: bool = False

    @property
    def is_exercise(self) -> bool:
        """Whether a worksheet or its solution is wanted."""
        return self.worksheet or self.solution

    @property
    def format(self) -> str | None:
        """The format, where neither `--format` nor the output says it."""
        return "latex" if self.beamer else "markdown" if self.reader != "github" else None

    def check(self, format_: str, detail: str) -> None:
        """Raises a usage error where the options contradict one another."""
        if self.beamer and format_ != "latex":
            raise click.UsageError("--beamer goes with --format latex: frames are LaTeX")
        if self.reader != "github" and format_ != "markdown":
            raise click.UsageError(f"--for {self.reader} goes with --format markdown")
        if self.static and format_ != "html":
            raise click.UsageError("--static goes with --format html")
        if self.is_exercise and format_ == "json":
            raise click.UsageError("--worksheet and --solution are pages to be read: JSON has all of it")
        if (self.is_exercise or self.beamer) and detail != "steps":
            raise click.UsageError(f"--detail {detail} does not go with --worksheet, --solution or --beamer")

    def derivations(self, reports: Sequence[Report]) -> list[tuple[Derivation, Notation]]:
        """What is written, one after the other."""
        if not self.is_exercise:
            return [(r.derivation, r.notation) for r in reports]
        sheets = [(self.sheet(r), r.notation) for r in reports]
        return [(d, notation) for s, notation in sheets for d in (s.exercise, s.solution) if d is not None]

    def sheet(self, report: Report) -> Sheet:
        """The worksheet of a problem, its solution, or both."""
        from lagrange.explain.page.worksheets import worked_solution, worksheet
        from lagrange.render.markdown import Sheet

        both = report.solution, report.derivation
        exercise = worksheet(*both) if self.worksheet else None
        return Sheet(exercise, worked_solution(*both) if self.solution else None, report.notation)


@record
class Destination:
    """Format and destination, as the command line asks; `path` is None for standard output."""

    format: str
    path: Path | None
    fragment: bool
    detail: str
    vectors: str = "bold"
    layout: Layout = Layout()

    @classmethod
    def of(
        cls,
        format_: str | None,
        output: str | None,
        fragment: bool,
        detail: str,
        vectors: str | None = None,
        layout: Layout | None = None,
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
        layout = layout or Layout()
        chosen = format_ or by_extension or layout.format or ("latex" if fragment else "pretty")
        if fragment and chosen != "latex":
            raise click.UsageError("--fragment goes with --format latex")
        if vectors and chosen not in ("latex", "markdown"):
            raise click.UsageError("--vectors goes with --format latex or markdown")
        layout.check(chosen, detail)
        return cls(chosen, path, fragment, detail, vectors or "bold", layout)

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
        if self.path is None:
            with stage_shown("writing the page"):
                text = self._text(reports)
            write_stdout(text)
            return
        from lagsolve.written_files import write_figures, write_file

        figures = self._figures()
        with stage_shown("writing the page"):
            text = self._text(reports, figures)
        if figures is not None:
            write_figures(self.path.parent, figures.files)
        write_file(self.path, text)

    def _figures(self) -> Figures | None:
        """The pictures of a page of Markdown, which are files beside it."""
        if self.format != "markdown" or self.path is None or not self.path.suffix:
            return None
        from lagrange.render.svg import Figures

        return Figures(self.path.stem)

    def _text(self, reports: Sequence[Report | None], figures: Figures | None = None) -> str:
        from lagrange.document.derivation import Detail

        detail = Detail[self.detail.upper()]
        solved = self.layout.derivations([r for r in reports if r is not None])
        if self.format == "json":
            from lagrange.render import json

            return json.render(reports)
        if self.format == "latex":
            from lagrange.render import latex
            from lagrange.render.tex_layout import Vectors

            if self.layout.beamer:
                from lagrange.render import frames

                return frames.render(solved, self.fragment, Vectors(self.vectors))
            apart = "\n\\clearpage\n" if self.layout.is_exercise else "\n"
            return latex.render(solved, self.fragment, detail, Vectors(self.vectors), apart)
        if self.format == "markdown":
            from lagrange.render import markdown
            from lagrange.render.flavours import Flavour
            from lagrange.render.tex_layout import Vectors

            flavour, vectors = Flavour(self.layout.reader), Vectors(self.vectors)
            if self.layout.is_exercise and flavour.labels:
                from lagrange.render import markdown

                sheets = [self.layout.sheet(r) for r in reports if r is not None]
                return markdown.with_exercises(sheets, vectors, flavour, figures)
            return markdown.render(solved, detail, vectors, flavour, figures)
        if self.format == "html":
            from lagrange.animation.moving import moving_figure
            from lagrange.render import html

            still = self.layout.static or self.layout.is_exercise
            return html.render(solved, detail, () if still else [moving_figure(r.solution) for r in reports if r])
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
        below = "\n" + "".join(f"{line}\n" for line in score.lines()) if score is not None else ""
        write_stdout(answer.text(terminal_width(), revealed) + below)


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

    Raises BrokenPipeError if the reader has gone, ProblemError where standard output cannot be written.
    """
    if sys.stdout is None:
        raise _unwritable("standard output", "it is closed")
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        abandon_stdout()
        if isinstance(error, BrokenPipeError):
            raise
        raise _unwritable("standard output", error.strerror) from None


def _unwritable(what: str, reason: str | None) -> ProblemError:
    from lagrange.core.diagnostics import Diagnostic, ProblemError

    return ProblemError(Diagnostic("cannot-write", f"{what} cannot be written: {reason}"))
