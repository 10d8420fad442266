"""Diagnostics: what is wrong with a text, where, and what to do about it.

A `Diagnostic` is one finding: a stable code, one sentence, the place, and a suggestion. A `Fragment` is a piece of text
that remembers its position in the file, so that an error inside an expression inside a YAML scalar points at the exact
characters. `ProblemError` holds all the findings of one read and can print itself.

Wording: messages begin with a lower-case letter and have no full stop; names are in backticks; the label under the
caret makes sense without the message; each mistake is reported once.
"""

from __future__ import annotations

import unicodedata
from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import field, replace
from enum import StrEnum
from functools import cached_property

from lagrange.core.printable import one_line, visible
from lagrange.core.records import record


class Severity(StrEnum):
    """Whether a finding is an error or a note."""

    ERROR = "error"
    NOTE = "note"


@record
class Source:
    """A text as it was read, with its name (a path, `<stdin>`, `answer 1`).

    original  as it was written, where it was put into usual signs first
    """

    name: str
    text: str
    original: str = ""

    @cached_property
    def _starts(self) -> list[int]:
        """The offsets of the lines, computed once: a file may have a thousand findings."""
        return [0, *(n + 1 for n, c in enumerate(self.text) if c == "\n")]

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column of an offset, both counted from 1."""
        number = bisect_right(self._starts, offset)
        return number, offset - self._starts[number - 1] + 1

    def line(self, number: int) -> str:
        """Line `number`, counted from 1, without its end."""
        if number > len(self._starts):
            return ""
        start = self._starts[number - 1]
        end = self.text.find("\n", start)
        return self.text[start : end if end >= 0 else None].rstrip("\r")


@record
class Span:
    """Characters `start` to `end` (exclusive) of a source."""

    source: Source
    start: int
    end: int


@record
class Fragment:
    """A piece of a source that is read on its own: an expression.

    start  where the text begins in the source, if it occurs there character for character; None if it does not (an
           escaped or folded YAML scalar): every finding then points at `whole`
    """

    text: str
    whole: Span
    start: int | None = None

    @classmethod
    def of(cls, text: str, name: str = "expression") -> Fragment:
        """A text that is its own source."""
        return cls(text, Span(Source(name, text), 0, len(text)), 0)

    def span(self, start: int, end: int) -> Span:
        """The place of characters `start` to `end` in the source."""
        if self.start is None:
            return self.whole
        return Span(self.whole.source, self.start + start, self.start + end)


@record
class Diagnostic:
    """One finding: `level[code]: message`, the place with a label under it, and what to do.

    about  the name that is not declared
    """

    code: str
    message: str
    span: Span | None = None
    label: str = ""
    help: str = ""
    level: Severity = field(default=Severity.ERROR)
    about: str = field(default="", compare=False)

    def as_note(self) -> Diagnostic:
        """The same finding as a note."""
        return replace(self, level=Severity.NOTE)

    def __str__(self) -> str:
        head = f"{self.level}[{self.code}]: {one_line(self.message)}"
        lines = [head, *_window(self.span, self.label)] if self.span else [head]
        if self.help:
            gutter = " " * _gutter(self.span)
            lines.append(f"{gutter} = help: {one_line(self.help)}")
        return "\n".join(lines)


class ProblemError(Exception):
    """The error for a text that cannot be used, with everything that is wrong with it."""

    def __init__(self, diagnostics: Diagnostic | Iterable[Diagnostic]) -> None:
        findings = (diagnostics,) if isinstance(diagnostics, Diagnostic) else tuple(diagnostics)
        super().__init__("; ".join(d.message for d in findings))
        self.diagnostics: tuple[Diagnostic, ...] = findings

    def show(self) -> str:
        """All findings in file order, separated by blank lines."""
        ordered = sorted(self.diagnostics, key=lambda d: d.span.start if d.span else -1)
        return "\n\n".join(str(d) for d in ordered)

    def __str__(self) -> str:
        return self.show()  # so that Python prints under a traceback what the command prints


class UndecidedError(ProblemError):
    """The error for a question that the derivation depends on and that could not be decided."""

    def __init__(self, question: str, span: Span | None = None) -> None:
        help_ = "nothing is guessed: simplify the expressions, or choose other coordinates"
        super().__init__(Diagnostic("undecided", f"it could not be decided {question}", span, help=help_))


class GaveUpError(UndecidedError):
    """The error for a problem of which nothing is known within the work, time or memory that is allowed."""

    def __init__(self, place: str) -> None:
        """place  the stage, and why it was given up."""
        help_ = "a smaller system, or shorter expressions, may be solved"
        self.place = place
        ProblemError.__init__(self, Diagnostic("given-up", f"given up at: {place}", help=help_))


class NotCoveredError(ProblemError):
    """The error for something that the format allows and the program cannot do yet."""

    def __init__(self, what: str, span: Span | None = None, cure: str = "") -> None:
        super().__init__(Diagnostic("not-covered", f"not supported yet: {what.rstrip(',')}", span, help=cure))


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name closest to `name`, if any is close: one that differs in case first, then in spelling."""
    names = sorted(set(known))
    for candidate in names:
        if candidate.casefold() == name.casefold():
            return candidate
    import difflib

    close = difflib.get_close_matches(name, names, n=1, cutoff=0.6)
    return close[0] if close else None


def suggestion(name: str, known: Sequence[str], what: str = "names") -> str:
    """`did you mean ...?`, or the list of known names."""
    near = nearest(name, known)
    if near:
        return f"did you mean `{near}`?"
    listed = ", ".join(f"`{k}`" for k in list(known)[:30])
    return f"known {what}: {listed}" if listed else f"there are no {what} here"


def _gutter(span: Span | None) -> int:
    return len(str(span.source.position(span.start)[0])) if span else 0


def _window(span: Span, label: str) -> list[str]:
    number, column = span.source.position(span.start)
    gutter = " " * len(str(number))
    line = span.source.line(number)
    shown, column_shown = _around(line, column - 1)
    before = "".join("\t" if c == "\t" else " " * _cells(c) for c in shown[:column_shown])
    marked = shown[column_shown : column_shown + max(1, span.end - span.start)]
    carets = "^" * max(1, sum(_cells(c) for c in marked))
    return [
        f"{gutter}--> {one_line(span.source.name)}:{number}:{column}",
        f"{gutter} |",
        f"{number} | {visible(shown)}",
        f"{gutter} | {before}{carets}{' ' + one_line(label) if label else ''}",
    ]


def _around(line: str, column: int, width: int = 100) -> tuple[str, int]:
    """The part of a long line around a column, and the column in that part."""
    if len(line) <= width:
        return line, column
    start = max(0, min(column - width // 3, len(line) - width))
    head = "..." if start else ""
    tail = "..." if start + width < len(line) else ""
    return head + line[start : start + width] + tail, column - start + len(head)


def _cells(char: str) -> int:
    if unicodedata.combining(char):
        return 0
    return 2 if unicodedata.east_asian_width(char) in "WF" else 1
