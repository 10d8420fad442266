"""An executor of `concurrent.futures` whose calls run within limits, each in a process that can be stopped.

A call that exceeds its limits fails with a `StoppedError`, and so does one whose process is killed; the process is
replaced and the other calls know nothing of it. One thread stands for each process and does nothing but wait for it.
"""

from __future__ import annotations

import os
import queue
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any, TypeVar

from lagrange.core.records import record
from lagsolve.grading.child import nothing
from lagsolve.grading.worker import FailedError, Limits, LostError, Worker

T = TypeVar("T")

STARTS = 3


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
    """`jobs` processes. `shutdown(cancel_futures=True)` stops the calls that are being carried out, too.

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
        """Has `fn(*args)` carried out; both must be picklable."""
        assert not kwargs
        future: Future[T] = Future()
        with self._lock:
            if self._closed:
                raise RuntimeError("the pool is closed")
            self._tasks.put(_Task(future, fn, args))
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Ends the processes once the calls are done; at once, where they are to be cancelled."""
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
        """Carries out calls, in the life of one thread."""
        while (task := self._tasks.get()) is not None:
            if self._cancelled:
                task.future.cancel()
            if not task.future.set_running_or_notify_cancel():
                continue
            try:
                task.future.set_result(self._worker(number).call(task.function, *task.arguments))
            except FailedError as error:
                task.future.set_exception(error)
            except BaseException as error:
                self._discard(number)
                task.future.set_exception(error)
        self._discard(number)

    def _worker(self, number: int) -> Worker:
        """The process of a thread; a new one where the last was lost.

        That one is lost before it is ready is not the fault of a call, and there is another.
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
