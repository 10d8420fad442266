"""The progress of a batch on standard error: a line that changes on a terminal, otherwise a line now and then."""

from __future__ import annotations

import sys
import time

from lagsolve.limits import PROGRESS_ELSEWHERE, PROGRESS_ON_TERMINAL


class Progress:
    """Counts submissions; prints nothing if a batch is short."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._terminal = sys.stderr is not None and sys.stderr.isatty()
        self._start = self._last = time.monotonic()
        self._first: tuple[float, int] | None = None  # when the first was graded, and how many were done by then

    def step(self, done: int, graded: bool) -> None:
        """Updates the number of submissions that are done; `graded`: one has just been graded."""
        now = time.monotonic()
        if graded and self._first is None:
            self._first = now, done
        if sys.stderr is None or now - self._last < (PROGRESS_ON_TERMINAL if self._terminal else PROGRESS_ELSEWHERE):
            return
        self._last = now
        line = f"{done:,} of {self._total:,} graded, {now - self._start:.0f} s{self._left(now, done)}"
        sys.stderr.write(f"\r\x1b[K{line}" if self._terminal else f"{line}\n")
        sys.stderr.flush()

    def _left(self, now: float, done: int) -> str:
        """The time that remains, estimated from the time since the processes were ready."""
        if self._first is None or done == self._first[1]:
            return ""
        since, before = self._first
        return f", about {(now - since) * (self._total - done) / (done - before):.0f} s more"

    def end(self) -> None:
        """Removes the line."""
        if self._terminal:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
