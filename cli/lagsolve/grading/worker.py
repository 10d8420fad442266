"""A process that runs one call after another and is stopped when a call exceeds its limits.

`multiprocessing` is not used: its pools break when a worker is killed, and its processes cannot be started from within
the workers of a cluster. A worker is a fresh interpreter with this process's module path, so that it can be started at
any time from any thread, and it has a session of its own, so that Ctrl-C at a terminal does not reach it.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from typing import Any, TypeVar

from lagrange.core.records import record
from lagsolve.grading.worker_process import read_object, write_frame

T = TypeVar("T")

PROGRAM = "import sys; sys.path[:] = {path!r}; from lagsolve.grading.worker_process import main; main()"


@record
class Limits:
    """The limits of one call: seconds of wall-clock time, and megabytes of address space of its process."""

    seconds: float
    megabytes: int


class CallStoppedError(Exception):
    """A call without a result. The message completes `it ...`."""


class TimeLimitError(CallStoppedError):
    """A call was stopped because it took too long."""


class MemoryLimitError(CallStoppedError):
    """A call ran out of memory."""


class LostError(CallStoppedError):
    """The process ended during a call: it was killed, or it crashed."""


class CallFailedError(CallStoppedError):
    """A call raised an exception."""


class SetupError(Exception):
    """The first call of a process cannot be done within the limits: no other will succeed."""


class Worker:
    """One process. It belongs to one thread at a time.

    idle  seconds without work after which the process ends by itself; 0: never
    """

    def __init__(self, limits: Limits, idle: float = 0) -> None:
        self.limits = limits
        self._idle, self._last = idle, time.monotonic()
        self._lock = threading.Lock()
        self._number = 0  # of calls that are done
        self._seconds = limits.seconds  # of the call that is going on
        self._expired = False
        self._process = subprocess.Popen(
            [sys.executable, "-P", "-c", PROGRAM.format(path=sys.path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=None if os.environ.get("LAGSOLVE_DEBUG") else subprocess.DEVNULL,
            start_new_session=True,
        )
        self._send((limits.megabytes, idle))

    @property
    def pid(self) -> int:
        """The id of the process."""
        return self._process.pid

    @property
    def is_fresh(self) -> bool:
        """Whether the process is waiting for work."""
        rested = self._idle and time.monotonic() - self._last > self._idle / 2
        return not rested and self._process.poll() is None

    def prepare(self, setup: Callable[[], object], seconds: float) -> None:
        """A call before any other, with a limit of its own. Raises SetupError, or LostError."""
        try:
            self.call(setup, seconds=seconds)
        except LostError:
            raise
        except CallStoppedError as error:
            raise SetupError(str(error)) from error

    def call(self, function: Callable[..., T], *arguments: Any, seconds: float | None = None) -> T:
        """The value that the function returns in the process, within the limits or another number of seconds.

        Raises StoppedError; after any but CallFailedError the process is gone.
        """
        self._seconds = seconds = self.limits.seconds if seconds is None else seconds
        watch = threading.Timer(seconds, self._expire, (self._number,))
        watch.daemon = True
        watch.start()
        try:
            self._send((function, arguments, seconds))
            outcome, result = self._received()
        finally:
            watch.cancel()
            with self._lock:
                self._number += 1
        self._last = time.monotonic()
        if outcome == "returned":
            return result  # type: ignore[no-any-return]
        if outcome == "raised":
            raise CallFailedError(": ".join(result))
        self.stop()
        raise MemoryLimitError(f"needs more than {self.limits.megabytes:,} MB of memory")

    def _expire(self, number: int) -> None:
        """Stops the call of that number, if it is still going on."""
        with self._lock:
            if number == self._number:
                self._expired = True
                self._process.kill()

    def _send(self, content: object) -> None:
        assert self._process.stdin is not None
        try:
            write_frame(self._process.stdin, content)
        except (OSError, ValueError):
            raise self._lost() from None

    def _received(self) -> Any:
        assert self._process.stdout is not None
        try:
            return read_object(self._process.stdout)
        except (EOFError, OSError, ValueError):  # ValueError: `stop` has closed it
            raise self._lost() from None

    def _lost(self) -> CallStoppedError:
        """The reason why the process does not answer."""
        self.stop()
        status = self._process.returncode
        by_system = hasattr(signal, "SIGXCPU") and status == -signal.SIGXCPU
        if self._expired or by_system:
            return TimeLimitError(f"takes longer than {self._seconds:g} s")
        how = f"was ended by signal {-status}" if status < 0 else f"ended with status {status}"
        return LostError(f"has lost its process, which {how}")

    def stop(self) -> None:
        """Ends the process. May be called from any thread, and more than once."""
        self._process.kill()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                try:
                    stream.close()
                except (OSError, ValueError):
                    continue  # what was not sent does not matter
