"""Child processes that end: each has a time limit, and sees Ctrl-C.

A shell that starts `make test &` lets it ignore SIGINT, and so does whatever that starts, down to the process that a test
interrupts: it would wait for ever. `started` gives SIGINT back to the child.
"""

from __future__ import annotations

import os
import signal
import subprocess
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from typing import Any

PATIENCE = 240
"""Seconds after which a process is killed. The slowest needs a tenth of that on an idle machine."""


@contextmanager
def interruptible() -> Iterator[None]:
    """What is started here has the system's way with SIGINT, even if this process ignores it."""
    before = signal.getsignal(signal.SIGINT)
    if before is not signal.SIG_IGN:
        yield
        return
    # A handler of Python is replaced by the system's when the child's program begins; `preexec_fn` would do the same, but
    # Python warns of it where there are threads, as in a worker of xdist.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def started(command: Sequence[str], patience: float = PATIENCE, **options: Any) -> Iterator[subprocess.Popen[Any]]:
    """A process that is killed when its time is over, however one waits for it, and when the test fails before it ends."""
    with interruptible():
        process = subprocess.Popen(command, **options)

    def kill() -> None:
        if process.poll() is None:
            if options.get("start_new_session"):
                os.killpg(process.pid, signal.SIGKILL)
            else:
                process.kill()

    watch = threading.Timer(patience, kill)
    watch.daemon = True
    watch.start()
    try:
        yield process
        process.wait(patience)
    finally:
        kill()
        watch.cancel()
        process.wait(10)
        for stream in (process.stdin, process.stdout, process.stderr):
            if stream is not None:
                with suppress(OSError):  # what it did not read is of no interest
                    stream.close()
