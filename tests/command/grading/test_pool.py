"""Processes with limits: what becomes of a call that loops, eats memory or is killed, and of the calls beside it."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from concurrent.futures import CancelledError, as_completed
from functools import partial
from pathlib import Path

import pytest

from lagsolve.grading.pool import (
    Limits,
    LostError,
    Pool,
    SetupError,
    TimeLimitError,
    Worker,
)
from tests.support import grading_calls as calls
from tests.support.grading_calls import GENEROUS
from tests.support.processes import started

SHORT = Limits(0.5, 512)

pytestmark = pytest.mark.skipif(os.name != "posix", reason="limits of memory are those of POSIX")


def is_running(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def wait_until(condition: partial[bool]) -> None:
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_it_is_an_executor(pool: Pool) -> None:
    assert list(pool.map(calls.double, range(20))) == [2 * n for n in range(20)]
    futures = [pool.submit(calls.double, n) for n in range(5)]
    assert {f.result() for f in as_completed(futures)} == {0, 2, 4, 6, 8}


def test_calls_have_processes_of_their_own(pool: Pool) -> None:
    found = {pool.submit(calls.hold_still, 0.2).result() for _ in range(2)}
    found |= {f.result() for f in [pool.submit(calls.hold_still, 0.5) for _ in range(4)]}
    assert os.getpid() not in found
    assert len(found) == 2


def test_a_process_killed_between_two_calls_is_replaced(pool: Pool) -> None:
    pids = {f.result() for f in [pool.submit(calls.hold_still, 0.3) for _ in range(2)]}
    for pid in pids:
        os.kill(pid, 9)
    wait_until(partial(lambda: all(is_over(p) for p in pids)))
    assert [pool.submit(calls.double, n).result() for n in range(4)] == [0, 2, 4, 6]


def is_over(pid: int) -> bool:
    """Whether a child has ended with all its threads; its status is left for whoever started it."""
    try:
        return os.waitid(os.P_PID, pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None
    except ChildProcessError:
        return True


def is_zombie_free(pid: int) -> bool:
    """Whether a process is there and not yet dead."""
    try:
        return ") Z " not in Path(f"/proc/{pid}/stat").read_text()
    except OSError:
        return False


def test_what_a_call_prints_does_not_disturb(pool: Pool) -> None:
    assert [pool.submit(calls.print_and_answer).result() for _ in range(3)] == ["an answer"] * 3


def test_cancelling_stops_what_is_being_carried_out() -> None:
    pool = Pool(1, GENEROUS)
    pid = pool.submit(calls.process).result()
    running, waiting = pool.submit(calls.loop), pool.submit(calls.double, 1)
    wait_until(partial(running.running))
    pool.shutdown(cancel_futures=True)
    with pytest.raises(LostError):
        running.result(60)
    with pytest.raises(CancelledError):
        waiting.result(60)
    assert not is_running(pid)
    with pytest.raises(RuntimeError, match="closed"):
        pool.submit(calls.double, 1)


def test_without_cancelling_calls_are_finished() -> None:
    with Pool(1, GENEROUS) as pool:
        futures = [pool.submit(calls.double, n) for n in range(5)]
        pid = pool.submit(calls.process)
    assert [f.result() for f in futures] == [0, 2, 4, 6, 8]
    assert not is_running(pid.result())


def test_the_setup_has_its_own_time_and_is_made_once_for_each_process() -> None:
    with Pool(1, SHORT, partial(calls.hold_still, 1.0), 120) as pool:
        assert len({pool.submit(calls.process).result() for _ in range(3)}) == 1


@pytest.mark.parametrize("setup", [partial(calls.fail, "no"), calls.eat, partial(calls.hold_still, 3600)])
def test_a_setup_that_fails_concerns_all_calls(setup: partial[None]) -> None:
    with Pool(1, GENEROUS, setup, 1.0) as pool, pytest.raises(SetupError):
        pool.submit(calls.double, 1).result()


def test_a_process_killed_during_its_setup_is_a_lost_call() -> None:
    with Pool(1, GENEROUS, calls.kill) as pool, pytest.raises(LostError):
        pool.submit(calls.double, 1).result()


def test_a_process_killed_during_its_setup_is_replaced(tmp_path: Path) -> None:
    with Pool(1, GENEROUS, partial(calls.kill_once, str(tmp_path / "mark"))) as pool:
        assert pool.submit(calls.double, 1).result() == 2
    assert (tmp_path / "mark").exists()


def test_a_process_without_work_ends_by_itself() -> None:
    worker = Worker(GENEROUS, idle=0.3)
    assert worker.call(calls.double, 1) == 2
    wait_until(partial(lambda: not is_zombie_free(worker.pid)))
    assert not worker.is_fresh
    worker.stop()


def test_the_system_stops_a_call_where_the_clock_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Worker, "_expire", lambda *_: None)
    worker = Worker(Limits(0.1, 512))
    worker.prepare(calls.process, 120)
    with pytest.raises(TimeLimitError):
        worker.call(calls.loop)


PARENT = """
import sys
sys.path[:0] = {path!r}
import os
from tests.support import grading_calls
from lagsolve.grading.pool import Limits, Worker
worker = Worker(Limits(3600, 512))
print(worker.pid, flush=True)
{then}
"""


@pytest.mark.parametrize("then", ["sys.stdin.read()", "worker.call(grading_calls.loop)"])
def test_no_process_outlives_the_command_that_is_killed(then: str) -> None:
    """Idle ones see that nobody asks any more; busy ones, that their parent is another."""
    program = PARENT.format(path=sys.path, then=then)
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with started([sys.executable, "-c", program], **pipes) as parent:
        pid = int(parent.stdout.readline())
        time.sleep(0.3)
        parent.kill()
    wait_until(partial(lambda: not is_zombie_free(pid)))
