"""The outer limits of a command."""

from __future__ import annotations

import importlib
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from lagrange.core.diagnostics import GaveUpError
from lagrange.core.effort import allowed, spare_memory
from lagsolve.limits import SPARE_MEMORY
from lagsolve.main import main
from lagsolve.time_and_memory import bounded
from tests.support.processes import PATIENCE

pytestmark = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="the system has no alarms")


STAGES = {
    "reading or printing": "lagrange.problem.loader.read_problem",
    "classifying the constraints": "lagrange.mechanics.solution.classify",
    "checks": "lagrange.mechanics.solution.check_motion",
}


@pytest.mark.parametrize("stage", STAGES)
@pytest.mark.parametrize("arguments", [("ex11",), ("check", "ex11")])
def test_a_time_that_is_too_short(arguments: tuple[str, ...], stage: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever stage it is in when the alarm goes off: exit status 3, and the place, in place of an exception."""
    module, _, name = STAGES[stage].rpartition(".")
    begun = getattr(importlib.import_module(module), name)

    def alarmed(*values: Any, **named: Any) -> Any:
        signal.raise_signal(signal.SIGPROF)
        return begun(*values, **named)

    monkeypatch.setattr(STAGES[stage], alarmed)
    handler = signal.getsignal(signal.SIGPROF)
    result = CliRunner().invoke(main, (*arguments, "--timeout", "3600"))
    assert result.exit_code == 3
    assert f"given up at: {stage}, after 3600 s" in result.output
    assert signal.getsignal(signal.SIGPROF) is handler


def test_an_alarm_while_a_class_is_being_made() -> None:
    """Python 3.11 makes a RuntimeError of any exception there, as it does in a module that is being imported."""

    class Named:
        def __set_name__(self, owner: type, name: str) -> None:
            signal.raise_signal(signal.SIGPROF)

    with pytest.raises(GaveUpError, match="after 3600 s"), bounded(3600, None):
        type("Made", (), {"named": Named()})
    with pytest.raises(RuntimeError, match="another"), bounded(3600, None):
        raise RuntimeError("another")


def test_a_time_that_is_long_enough() -> None:
    bounded = CliRunner().invoke(main, ("ex11", "--timeout", "3600", "--memory", "65536"))
    assert (bounded.exit_code, bounded.output) == (0, CliRunner().invoke(main, ("ex11",)).output)


def test_time_is_that_of_the_processor() -> None:
    """A machine that is busy with something else makes no answer wrong."""
    with bounded(0.02, None):
        time.sleep(0.1)
    with pytest.raises(GaveUpError, match=r"after 0\.02 s"), bounded(0.02, None):
        sum(1 for _ in iter(int, 1))


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the system does not tell the size of the stack")
def test_the_stack_is_taken_in_advance() -> None:
    """A stack that cannot grow is a segmentation fault; one level of `min` with a key has at least 100 bytes of it."""
    code = r"""
import re, sys
from pathlib import Path
from lagsolve.time_and_memory import bounded
size = lambda: int(re.search(r"VmStk:\s+(\d+) kB", Path("/proc/self/status").read_text())[1])
before = size()
with bounded(None, 256):
    print(size() - before, sys.getrecursionlimit())
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=PATIENCE, check=True)
    grown, depth = map(int, done.stdout.split())
    assert 1024 * grown > 4 * 100 * depth


def test_spare_memory_is_freed_when_memory_runs_out() -> None:
    """Handling the error needs some memory, and Python 3.11 aborts a process that has none."""
    with bounded(None, 65536):
        assert sum(map(len, spare_memory)) == SPARE_MEMORY
        with pytest.raises(MemoryError), allowed(1):
            raise MemoryError
        assert not spare_memory


def test_an_error_that_a_lack_of_memory_has_caused() -> None:
    """Python may lose its MemoryError on the way, or fail in handling it."""
    lost = TypeError("record() takes no arguments")
    with pytest.raises(TypeError), bounded(None, 65536):
        raise lost
    lost.__context__ = MemoryError()
    with pytest.raises(GaveUpError, match="there is not enough memory"), bounded(None, 65536):
        raise lost


def test_memory_that_runs_out_in_a_stage(monkeypatch: pytest.MonkeyPatch) -> None:
    """What was found before is printed."""

    def too_large(*_: Any) -> Any:
        return bytearray(1 << 30)  # of which nothing is touched

    monkeypatch.setattr("lagrange.mechanics.solution.check_motion", too_large)
    result = CliRunner().invoke(main, ("ex11", "--memory", "256"))
    assert result.exit_code == 3
    assert "given up at: checks" in result.output
    assert "there is not enough memory" in result.output
    assert "Ideal pendulum" in result.output


@pytest.mark.parametrize("lost", [MemoryError, SystemError("error return without exception set")])
def test_memory_that_runs_out_outside_of_any_stage(lost: BaseException) -> None:
    message = "given up at: reading or printing, there is not enough memory"
    with pytest.raises(GaveUpError, match=message), bounded(None, 65536):
        raise lost
