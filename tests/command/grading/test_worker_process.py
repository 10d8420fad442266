"""The process of a worker, killed."""

from __future__ import annotations

import os
import threading
import time
from concurrent.futures import Future

import pytest

from lagsolve.grading.pool import (
    LostError,
    Pool,
    Worker,
)
from tests.support import grading_calls as calls
from tests.support.grading_calls import GENEROUS


def test_a_process_that_is_killed_is_one_lost_call(pool: Pool) -> None:
    killed, others = pool.submit(calls.kill), [pool.submit(calls.double, n) for n in range(10)]
    with pytest.raises(LostError, match="signal 9"):
        killed.result()
    assert [f.result() for f in others] == [2 * n for n in range(10)]


def test_a_process_killed_from_outside_in_the_middle_of_a_call() -> None:
    worker = Worker(GENEROUS)
    outcome: Future[None] = Future()

    def call() -> None:
        try:
            outcome.set_result(worker.call(calls.loop))
        except LostError as error:
            outcome.set_exception(error)

    thread = threading.Thread(target=call)
    thread.start()
    time.sleep(0.2)
    os.kill(worker.pid, 9)
    with pytest.raises(LostError):
        outcome.result(60)
    thread.join()
    assert not worker.is_fresh
