"""The line on standard error that says which stage is running, where the work takes longer than two seconds.

The work announces its stages (`on_stage` of `solve`, `report` and `Examiner`); a thread that wakes up after two seconds
writes the latest of them until the work is done, and then takes the line away. Work that ends sooner costs one sleeping
thread, or nothing where standard error is not a terminal.
"""

from __future__ import annotations

import os
import shutil
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

PATIENCE, PERIOD = 2.0, 0.25
"""Seconds before the line appears, and between two updates."""

Wait = Callable[[float], bool]
"""Waits for so many seconds, or until the work is done; whether it is."""


@contextmanager
def stage_shown(first: str = "starting") -> Iterator[Callable[[str], None]]:
    """Yields `on_stage`, which takes the name of each stage as it begins; the line shows it while the block runs."""
    latest = deque([first], maxlen=1)
    if sys.stderr is None or not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        yield latest.append
        return
    done = threading.Event()
    thread = threading.Thread(target=_follow, args=(latest, done.wait, sys.stderr.write), daemon=True)
    thread.start()
    try:
        yield latest.append
    finally:
        done.set()
        thread.join()


def _follow(latest: Sequence[str], wait: Wait, write: Callable[[str], object]) -> None:
    """Writes the latest stage until the work is done; nothing if that is soon."""
    started = time.monotonic()
    if wait(PATIENCE):
        return
    while True:
        width = shutil.get_terminal_size().columns
        line = f"{latest[0]} ... {time.monotonic() - started:.0f} s"
        write(f"\r\x1b[K{line[: width - 1]}")
        sys.stderr.flush()
        if wait(PERIOD):
            break
    write("\r\x1b[K")
    sys.stderr.flush()
