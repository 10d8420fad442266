"""All mistakes and notes of one reading, each told once, in the order of the file.

One mistake must not give ten messages: what is said of a place that is known to be wrong is dropped, a name that is not
declared is told at the first place where it stands with the lines of the others, and of a file that is wrong from end
to end the first hundred mistakes are told.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, TypeVar

from lagrange.core.diagnostics import Diagnostic, Level, ProblemError, Span

MOST_SHOWN = 100
MOST_FOUND = 300
_OF_A_NAME = ("unknown-symbol", "unknown-function")
"""What is wrong with a name, and as wrong wherever it stands."""

T = TypeVar("T")


class EnoughError(Exception):
    """So much is wrong with a file that reading it any further helps nobody."""


class Findings:
    """What has been found so far."""

    def __init__(self) -> None:
        self._found: list[Diagnostic] = []
        self._muted: list[tuple[Span, int]] = []

    def report(self, found: Diagnostic) -> None:
        """Notes one finding. Raises EnoughError where there are too many."""
        if len(self._found) >= MOST_FOUND:
            raise EnoughError
        self._found.append(found)

    def report_all(self, found: Iterable[Diagnostic]) -> None:
        """Notes several findings."""
        for one in found:
            self.report(one)

    def mute(self, span: Span) -> None:
        """Drops what is found from now on inside a place of which something was said already."""
        self._muted.append((span, len(self._found)))

    def attempt(self, read: Callable[[], T]) -> T | None:
        """What `read` returns, or None where it raised; its mistakes are noted."""
        try:
            return read()
        except ProblemError as error:
            self.report_all(error.diagnostics)
            return None

    def all_of(self, *reads: Callable[[], Any]) -> list[Any]:
        """What each of them returns. All are tried and their mistakes noted; then raises ProblemError if one failed."""
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
        """What is to be said of a file that could be read."""
        return _told(d for d in self._found if d.level is Level.NOTE)

    def stop_if_any(self) -> None:
        """Raises the mistakes found so far, if there are any."""
        errors = [(d, n) for n, d in enumerate(self._found) if d.level is Level.ERROR]
        if errors:
            told = _told(d for d, n in errors if not self._is_muted(d.span, n))
            raise ProblemError(_first_of(told, len(self._found) < MOST_FOUND))

    def _is_muted(self, span: Span | None, number: int) -> bool:
        if span is None:
            return False
        return any(m.start <= span.start and span.end <= m.end and number >= since for m, since in self._muted)


def _told(found: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """In the order of the file, each once; notes and unknown names with the lines where they are found again."""
    same: dict[tuple[str, str, int], list[Diagnostic]] = {}
    for d in sorted(found, key=_start):
        anywhere = d.level is Level.NOTE or d.code in _OF_A_NAME
        same.setdefault((d.code, d.message, -1 if anywhere else _start(d)), []).append(d)
    return tuple(_merged(group) for group in same.values())


def _start(found: Diagnostic) -> int:
    return found.span.start if found.span else -1


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


def _first_of(found: tuple[Diagnostic, ...], all_found: bool) -> list[Diagnostic]:
    shown = list(found[:MOST_SHOWN])
    if len(shown) < len(found) or not all_found:
        message = "more mistakes follow, which are not shown"
        shown.append(Diagnostic("more-mistakes", message, shown[-1].span, help="mend these first"))
    return shown
