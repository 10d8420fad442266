"""The other end of a `Worker`: calls arrive on standard input, results leave by standard output.

A frame is its length, eight bytes, and a pickle. The process limits itself: memory by RLIMIT_AS, and processor time, in
case the parent's clock should fail. Where a system has no such limits, there is only that clock. When the parent is
gone, the process ends, whatever it is doing.
"""

from __future__ import annotations

import gc
import os
import pickle
import struct
import sys
import threading
import time
from typing import IO, Any

from lagsolve.limits import MAX_FRAME, PARENT_SECONDS, SPARE_SECONDS

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]

HEAD = struct.Struct(">Q")


def write_frame(stream: IO[bytes], content: object) -> None:
    """Sends an object."""
    data = pickle.dumps(content)
    stream.write(HEAD.pack(len(data)) + data)
    stream.flush()


def read_object(stream: IO[bytes]) -> Any:
    """The next object. Raises EOFError if there is none, or only a part of one."""
    head = stream.read(HEAD.size)
    size = HEAD.unpack(head)[0] if len(head) == HEAD.size else MAX_FRAME + 1
    data = stream.read(size) if size <= MAX_FRAME else b""
    if not data or len(data) < size:
        raise EOFError
    return pickle.loads(data)


def nothing() -> None:
    """A call that does nothing: its answer means that the process is ready."""


def main() -> None:
    """Answers calls until standard input ends."""
    calls, results = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a call prints is not a result
    memory, idle = read_object(calls)
    _limit_memory(memory)
    threading.Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    while True:
        patience = _patience(idle)
        try:
            function, arguments, seconds = read_object(calls)
        except EOFError:
            os._exit(0)
        finally:
            patience.cancel()
        _limit_time(seconds)
        write_frame(results, _outcome(function, arguments))
        gc.set_threshold(200_000, 20, 50)  # the modules that the first call imported stay anyway


def _outcome(function: Any, arguments: tuple[Any, ...]) -> tuple[str, Any]:
    """The outcome of a call, as something that can be sent."""
    try:
        result = ("returned", function(*arguments))
        pickle.dumps(result)
    except MemoryError:
        return "no memory", None
    except BaseException as error:
        return "raised", (type(error).__name__, str(error)[:1000])
    return result


def _end_with(parent: int) -> None:
    """Ends the process when its parent has gone, on systems where the parent's id then changes."""
    while os.getppid() == parent:
        time.sleep(PARENT_SECONDS)
    os._exit(0)


def _patience(idle: float) -> threading.Timer:
    """A timer that ends the process after `idle` seconds without work; never if `idle` is 0."""
    timer = threading.Timer(idle, os._exit, (0,))
    timer.daemon = True
    if idle:
        timer.start()
    return timer


def _limit_memory(megabytes: int) -> None:
    if resource is not None:
        _lower(resource.RLIMIT_AS, megabytes << 20)
        _lower(resource.RLIMIT_CORE, 0)


def _limit_time(seconds: float) -> None:
    if resource is not None:
        used = resource.getrusage(resource.RUSAGE_SELF)
        _lower(resource.RLIMIT_CPU, int(used.ru_utime + used.ru_stime + seconds) + SPARE_SECONDS)


def _lower(what: int, limit: int) -> None:
    """Sets a limit, within what the system allows."""
    hard = resource.getrlimit(what)[1]
    try:
        resource.setrlimit(what, (limit if hard == resource.RLIM_INFINITY else min(limit, hard), hard))
    except (ValueError, OSError):
        return  # some systems have a limit that cannot be set
