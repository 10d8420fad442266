"""Collects the errors and notes of one read, without duplicates, in file order.

One mistake must not give ten messages: whatever is reported inside a place that is known to be wrong is dropped, an
undeclared name is reported where it first occurs together with the other lines that use it, and of a file that is wrong
from beginning to end only the first hundred errors are shown.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, TypeVar

from lagrange.core.diagnostics import Diagnostic, ProblemError, Severity, Span
from lagrange.problem.limits import MOST_COLLECTED, MOST_SHOWN

_OF_A_NAME = ("unknown-symbol", "unknown-function")
"""Errors that belong to a name, wherever it is used."""

T = TypeVar("T")


class EnoughError(Exception):
    """So much is wrong with a file that reading on is pointless."""


class Diagnostics:
    """The errors and notes collected so far."""

    def __init__(self) -> None:
        self._collected: list[Diagnostic] = []
        self._muted: list[tuple[Span, int]] = []

    def report(self, diagnostic: Diagnostic) -> None:
        """Adds a diagnostic. Raises EnoughError if there are too many."""
        if len(self._collected) >= MOST_COLLECTED:
            raise EnoughError
        self._collected.append(diagnostic)

    def report_all(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Adds several diagnostics."""
        for diagnostic in diagnostics:
            self.report(diagnostic)

    def mute(self, span: Span) -> None:
        """Drops whatever is reported from now on inside a place whose mistake is known."""
        self._muted.append((span, len(self._collected)))

    def attempt(self, read: Callable[[], T]) -> T | None:
        """What `read` returns, or None if it raises ProblemError; its diagnostics are added."""
        try:
            return read()
        except ProblemError as error:
            self.report_all(error.diagnostics)
            return None

    def all_of(self, *reads: Callable[[], Any]) -> list[Any]:
        """What each of them returns. All are tried, their diagnostics added; raises ProblemError if one has failed."""
        values, failed = [], False
        for read in reads:
            try:
                values.append(read())
            except ProblemError as error:
                self.report_all(error.diagnostics)
                failed = True
        if failed:
            raise ProblemError(())
        return values

    def notes(self) -> tuple[Diagnostic, ...]:
        """The notes on a file that could be read."""
        return _without_duplicates(d for d in self._collected if d.level is Severity.NOTE)

    def stop_if_any(self) -> None:
        """Raises ProblemError with the errors collected so far, if there are any."""
        errors = [(d, n) for n, d in enumerate(self._collected) if d.level is Severity.ERROR]
        if errors:
            distinct = _without_duplicates(d for d, n in errors if not self._is_muted(d.span, n))
            raise ProblemError(_first_of(distinct, complete=len(self._collected) < MOST_COLLECTED))

    def _is_muted(self, span: Span | None, number: int) -> bool:
        if span is None:
            return False
        return any(m.start <= span.start and span.end <= m.end and number >= since for m, since in self._muted)


def _without_duplicates(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """In file order, each once; notes and unknown names with the other lines to which they apply."""
    same: dict[tuple[str, str, int], list[Diagnostic]] = {}
    for d in sorted(diagnostics, key=_start):
        anywhere = d.level is Severity.NOTE or d.code in _OF_A_NAME
        same.setdefault((d.code, d.message, -1 if anywhere else _start(d)), []).append(d)
    return tuple(_merged(group) for group in same.values())


def _start(diagnostic: Diagnostic) -> int:
    return diagnostic.span.start if diagnostic.span else -1


def _merged(same: list[Diagnostic]) -> Diagnostic:
    first, *others = same
    if first.span is None:
        return first
    line, _ = first.span.source.position(first.span.start)
    lines = {d.span.source.position(d.span.start)[0] for d in others if d.span} - {line}
    if not lines:
        return first
    shown = [str(n) for n in sorted(lines)[:5]] + (["..."] if len(lines) > 5 else [])
    again = f"also on line{'s' if len(lines) > 1 else ''} {', '.join(shown)}"
    return replace(first, label=f"{first.label}; {again}" if first.label else again)


def _first_of(errors: tuple[Diagnostic, ...], *, complete: bool) -> list[Diagnostic]:
    """As many errors as are shown; `complete`: the file was read to its end."""
    shown = list(errors[:MOST_SHOWN])
    if len(shown) < len(errors) or not complete:
        message = "more mistakes follow that are not shown"
        shown.append(Diagnostic("more-mistakes", message, shown[-1].span, help="fix these first"))
    return shown
