"""How far a batch has come, on standard error: a line that changes on a terminal, else a line now and then."""

from __future__ import annotations

import sys
import time

ON_TERMINAL, ELSEWHERE = 0.2, 15.0
"""Seconds between two lines."""


class Progress:
    """Counts submissions; says nothing where a batch is short."""

    def __init__(self, total: int) -> None:
        self.done = 0
        self._total = total
        self._terminal = sys.stderr is not None and sys.stderr.isatty()
        self._start = self._last = time.monotonic()

    def step(self, done: int) -> None:
        """So many are done."""
        self.done = done
        now = time.monotonic()
        if sys.stderr is None or now - self._last < (ON_TERMINAL if self._terminal else ELSEWHERE):
            return
        self._last = now
        said = f"{self.done:,} of {self._total:,} graded, {self._left(now - self._start)}"
        sys.stderr.write(f"\r\x1b[K{said}" if self._terminal else f"{said}\n")
        sys.stderr.flush()

    def _left(self, passed: float) -> str:
        if not self.done:
            return f"{passed:.0f} s"
        return f"{passed:.0f} s, about {passed * (self._total - self.done) / self.done:.0f} s more"

    def end(self) -> None:
        """Takes the line away."""
        if self._terminal:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
