"""Executors of `concurrent.futures` whose calls run within limits: processes on this machine, or a Dask cluster.

A call that exceeds its limits fails with a `StoppedError`, and so does one whose process is killed; the process is
replaced, and the other calls are not affected. One thread per process does nothing but wait for it.

The extra `cluster` installs what an existing Dask cluster needs, here and on its workers. A worker of the cluster
cannot stop a task that loops, and is lost if it runs out of memory. So each of its threads has a process of its own
with the limits, and the cluster distributes only the waiting.

A process that runs one call after another and is stopped when a call exceeds its limits.

`multiprocessing` is not used: its pools break when a worker is killed, and its processes cannot be started from within
the workers of a cluster. A worker is a fresh interpreter with this process's module path, so that it can be started at
any time from any thread, and it has a session of its own, so that Ctrl-C at a terminal does not reach it.
"""

from __future__ import annotations

import os
import queue
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from typing import Any, TypeVar

import lagrange
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.records import record
from lagsolve.grading.worker_process import nothing, read_object, write_frame
from lagsolve.limits import CLUSTER_SECONDS, STARTS

T = TypeVar("T")


def available_cores() -> int:
    """The cores that this process may use."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


@record
class _Task:
    future: Future[Any]
    function: Callable[..., Any]
    arguments: tuple[Any, ...]


class Pool(Executor):
    """`jobs` processes. `shutdown(cancel_futures=True)` also stops the calls that are running.

    setup  a call that each process makes first, within `setup_seconds`
    """

    def __init__(
        self, jobs: int, limits: Limits, setup: Callable[[], object] = nothing, setup_seconds: float = 600
    ) -> None:
        self._limits, self._setup, self._setup_seconds = limits, setup, setup_seconds
        self._tasks: queue.SimpleQueue[_Task | None] = queue.SimpleQueue()
        self._lock = threading.Lock()
        self._workers: dict[int, Worker] = {}  # by number of the thread
        self._closed = self._cancelled = False
        self._threads = [threading.Thread(target=self._serve, args=(n,), daemon=True) for n in range(jobs)]
        for thread in self._threads:
            thread.start()

    def submit(self, fn: Callable[..., T], /, *args: Any, **kwargs: Any) -> Future[T]:
        """Runs `fn(*args)` in a process; both must be picklable."""
        assert not kwargs
        future: Future[T] = Future()
        with self._lock:
            if self._closed:
                raise RuntimeError("the pool is closed")
            self._tasks.put(_Task(future, fn, args))
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Ends the processes once the calls are done, or at once if they are to be cancelled."""
        with self._lock:
            self._cancelled |= cancel_futures
            workers = list(self._workers.values()) if cancel_futures else []
            if not self._closed:
                self._closed = True
                for _ in self._threads:
                    self._tasks.put(None)
        for worker in workers:
            worker.stop()
        if wait:
            for thread in self._threads:
                thread.join()

    def _serve(self, number: int) -> None:
        """Runs calls: the life of one thread."""
        while (task := self._tasks.get()) is not None:
            if self._cancelled:
                task.future.cancel()
            if not task.future.set_running_or_notify_cancel():
                continue
            try:
                task.future.set_result(self._worker(number).call(task.function, *task.arguments))
            except CallFailedError as error:
                task.future.set_exception(error)
            except BaseException as error:
                self._discard(number)
                task.future.set_exception(error)
        self._discard(number)

    def _worker(self, number: int) -> Worker:
        """The process of a thread; a new one where the last was lost.

        A process that is lost before it is ready is not the fault of a call, and is replaced.
        """
        worker = self._workers.get(number)
        if worker is not None and worker.is_fresh:
            return worker
        for _ in range(STARTS - 1):
            try:
                return self._started(number)
            except LostError:
                if self._cancelled:
                    raise
        return self._started(number)

    def _started(self, number: int) -> Worker:
        self._discard(number)
        worker = Worker(self._limits)
        with self._lock:
            self._workers[number] = worker
            if self._cancelled:
                worker.stop()
        worker.prepare(self._setup, self._setup_seconds)
        return worker

    def _discard(self, number: int) -> None:
        with self._lock:
            worker = self._workers.pop(number, None)
        if worker is not None:
            worker.stop()


@contextmanager
def cluster(address: str) -> Iterator[tuple[Executor, int]]:
    """The executor of the scheduler at an address, and the number of its threads.

    Raises ProblemError if it cannot be reached, or its workers have another lagsolve.
    """
    try:
        from distributed import Client
        from distributed.comm import get_address_host_port
    except ImportError:
        help_ = "pip install 'lagsolve[cluster]', here and on the cluster"
        raise ProblemError(Diagnostic("no-cluster", "--dask needs the package `distributed`", help=help_)) from None
    try:
        get_address_host_port(address)  # a client with a malformed address hangs
        client = Client(address, timeout=CLUSTER_SECONDS, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        message = f"there is no Dask scheduler at {address}: {_one_line(error)}"
        raise ProblemError(Diagnostic("no-cluster", message, help="an address is like tcp://host:8786")) from None
    with client:
        threads = _threads(client, address)
        executor = client.get_executor(pure=False)
        try:
            yield executor, threads
        finally:
            executor.shutdown(wait=False)  # which cancels the remaining tasks


def _threads(client: Any, address: str) -> int:
    try:
        client.wait_for_workers(1, timeout=CLUSTER_SECONDS)
        versions = set(client.run(_version).values())
    except Exception as error:
        message = f"the workers at {address} cannot grade: {_one_line(error)}"
        help_ = f"they need lagsolve {lagrange.__version__} and what it needs"
        raise ProblemError(Diagnostic("no-cluster", message, help=help_)) from None
    if versions != {lagrange.__version__}:
        message = f"the workers at {address} have lagsolve {', '.join(sorted(versions))}, not {lagrange.__version__}"
        raise ProblemError(Diagnostic("no-cluster", message, help="install the same version everywhere"))
    threads: int = sum(client.nthreads().values())
    return max(1, threads)


def _version() -> str:
    return lagrange.__version__


def _one_line(error: Exception) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split())[:200]


# Worker


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
