"""How far a batch has come, on standard error: a line that changes on a terminal, else a line now and then."""

from __future__ import annotations

import sys
import time

ON_TERMINAL, ELSEWHERE = 0.2, 15.0
"""Seconds between two lines."""


class Progress:
    """Counts submissions; says nothing where a batch is short."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._terminal = sys.stderr is not None and sys.stderr.isatty()
        self._start = self._last = time.monotonic()
        self._first: tuple[float, int] | None = None  # when the first was graded, and how many were done by then

    def step(self, done: int, graded: bool) -> None:
        """So many are done, and whether one has just been graded."""
        now = time.monotonic()
        if graded and self._first is None:
            self._first = now, done
        if sys.stderr is None or now - self._last < (ON_TERMINAL if self._terminal else ELSEWHERE):
            return
        self._last = now
        said = f"{done:,} of {self._total:,} graded, {now - self._start:.0f} s{self._left(now, done)}"
        sys.stderr.write(f"\r\x1b[K{said}" if self._terminal else f"{said}\n")
        sys.stderr.flush()

    def _left(self, now: float, done: int) -> str:
        """How long it may still take, from what it took since the processes were ready."""
        if self._first is None or done == self._first[1]:
            return ""
        since, before = self._first
        return f", about {(now - since) * (self._total - done) / (done - before):.0f} s more"

    def end(self) -> None:
        """Takes the line away."""
        if self._terminal:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
