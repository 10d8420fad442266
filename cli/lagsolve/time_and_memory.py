"""The outer limits of one command: `--timeout` and `--memory`.

What solving may cost is counted in operations (`lagrange.core.effort`), so that every machine prints the same. In
addition, for running untrusted files, there are two limits where the system supports them: an alarm after so many
seconds of processor time, which gives up the running stage, and a bound on the address space beyond what is in use at
the start. What is known by then is still explained, in a quarter of the time. A limit on the clock would give up a
right answer when the machine is busy with something else.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType

from lagrange.core.diagnostics import ProblemError
from lagrange.core.effort import GivenUpError, allowed_for, spare_memory
from lagsolve.limits import LARGEST_CALL, SHARE_FOR_EXPLAINING, SPARE_MEMORY

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]


@contextmanager
def bounded(seconds: float | None, megabytes: int | None) -> Iterator[None]:
    """Limits for what is done within the block; None: no limit. Alarms are for the main thread only.

    Raises GaveUpError if not even what is known can be shown.
    """
    # The message is made when the limit of memory is lifted: it needs some.
    with allowed_for("reading or printing", float("inf")), _memory(megabytes), _time(seconds):
        yield


@contextmanager
def _time(seconds: float | None) -> Iterator[None]:
    if seconds is None or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(_: int, __: FrameType | None) -> None:
        signal.setitimer(signal.ITIMER_PROF, max(1, seconds * SHARE_FOR_EXPLAINING))
        raise GivenUpError(f"after {seconds:g} s")

    before = signal.signal(signal.SIGPROF, stop)
    remaining = signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    except RuntimeError as error:  # up to Python 3.11, of a class that was being made when the alarm went off
        if isinstance(error.__cause__, GivenUpError):
            raise error.__cause__ from None
        raise
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
        signal.setitimer(signal.ITIMER_PROF, *remaining)  # an alarm of whoever calls


@contextmanager
def _memory(megabytes: int | None) -> Iterator[None]:
    if megabytes is None or resource is None:
        yield
        return
    _grow_stack()
    spare_memory.append(bytearray(SPARE_MEMORY))
    before = resource.getrlimit(resource.RLIMIT_AS)
    limit = _address_space() + (megabytes << 20)
    hard = before[1]
    resource.setrlimit(resource.RLIMIT_AS, (limit if hard == resource.RLIM_INFINITY else min(limit, hard), hard))
    report = sys.unraisablehook

    def unless_of_memory(lost: sys.UnraisableHookArgs) -> None:  # in a callback, where Python can only print it
        if not isinstance(lost.exc_value, MemoryError):
            report(lost)

    sys.unraisablehook = unless_of_memory
    try:
        yield
    except Exception as error:
        if not isinstance(error, ProblemError) and _is_of_memory(error):
            raise MemoryError from None
        raise
    finally:
        spare_memory.clear()
        resource.setrlimit(resource.RLIMIT_AS, before)
        sys.unraisablehook = report


def _is_of_memory(error: BaseException | None) -> bool:
    """Whether a lack of memory is the cause; Python may lose its MemoryError (`error return without exception set`)."""
    while error is not None:
        if isinstance(error, MemoryError | SystemError):
            return True
        error = error.__context__
    return False


def _grow_stack() -> None:
    """Takes the stack that the deepest calls may need: the system kills a process whose stack cannot grow later."""

    def deeper(_: object) -> object:
        return min((None,), key=deeper)  # type: ignore[arg-type]  # by way of C, since calls of Python's own need none

    depth = sys.getrecursionlimit()
    sys.setrecursionlimit(LARGEST_CALL * depth)
    try:
        with suppress(RecursionError):
            deeper(None)
    finally:
        sys.setrecursionlimit(depth)


def _address_space() -> int:
    """Bytes of address space in use, where the system tells; a process that has loaded much can still begin."""
    try:
        pages = Path("/proc/self/statm").read_text(encoding="ascii").split()[0]
    except (OSError, IndexError):
        return 0
    return int(pages) * resource.getpagesize()
