"""A worker: calls that loop, sleep, eat memory or fail are lost, and no others."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from lagsolve.grading.pool import (
    CallFailedError,
    LostError,
    MemoryLimitError,
    Pool,
    TimeLimitError,
)
from tests.command.grading.test_pool import SHORT, is_running
from tests.support import grading_calls as calls


@pytest.fixture
def hasty() -> Iterator[Pool]:
    pool = Pool(1, SHORT)
    yield pool
    pool.shutdown(cancel_futures=True)


def test_a_call_that_loops_is_stopped(hasty: Pool) -> None:
    before = hasty.submit(calls.process).result()
    with pytest.raises(TimeLimitError, match=r"takes longer than 0\.5 s"):
        hasty.submit(calls.loop).result()
    after = hasty.submit(calls.process).result()
    assert before != after
    assert not is_running(before)


def test_a_call_that_sleeps_is_stopped(hasty: Pool) -> None:
    with pytest.raises(TimeLimitError):
        hasty.submit(calls.hold_still, 3600).result()


def test_a_call_that_eats_memory_is_stopped(pool: Pool) -> None:
    eater, others = pool.submit(calls.eat), [pool.submit(calls.double, n) for n in range(10)]
    with pytest.raises(MemoryLimitError, match="more than 512 MB"):
        eater.result()
    assert [f.result() for f in others] == [2 * n for n in range(10)]


def test_exceptions_come_back_as_text(pool: Pool) -> None:
    before = {f.result() for f in [pool.submit(calls.hold_still, 0.3) for _ in range(2)]}
    with pytest.raises(CallFailedError, match=r"^ValueError: no good$"):
        pool.submit(calls.fail, "no good").result()
    with pytest.raises(CallFailedError, match="but its text can"):
        pool.submit(calls.raise_what_cannot_be_sent).result()
    assert pool.submit(calls.process).result() in before


def test_a_result_that_is_too_large_is_a_lost_call(pool: Pool) -> None:
    with pytest.raises(LostError):
        pool.submit(calls.large, 65).result()
    assert pool.submit(calls.double, 1).result() == 2
