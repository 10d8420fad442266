"""The outer limits of a command."""

from __future__ import annotations

import signal
import time

import pytest
from click.testing import CliRunner

from lagrange.core.diagnostics import GaveUpError
from lagsolve.bounds import bounded
from lagsolve.main import main

pytestmark = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="the system has no alarms")


@pytest.mark.parametrize("arguments", [("ex18",), ("check", "ex18")])
def test_a_time_that_is_too_short(arguments: tuple[str, ...]) -> None:
    """Whatever stage it is in: exit status 3, and the place, in place of an exception."""
    handler = signal.getsignal(signal.SIGPROF)
    result = CliRunner().invoke(main, (*arguments, "--timeout", "0.001"))
    assert result.exit_code == 3
    assert "given up at: " in result.output
    assert "after 0.001 s" in result.output
    assert signal.getsignal(signal.SIGPROF) is handler


def test_a_time_that_is_long_enough() -> None:
    bounded = CliRunner().invoke(main, ("ex11", "--timeout", "3600", "--memory", "65536"))
    assert (bounded.exit_code, bounded.output) == (0, CliRunner().invoke(main, ("ex11",)).output)


def test_time_is_that_of_the_processor() -> None:
    """A machine that is busy with something else makes no answer wrong."""
    with bounded(0.02, None):
        time.sleep(0.1)
    with pytest.raises(GaveUpError, match=r"after 0\.02 s"), bounded(0.02, None):
        sum(1 for _ in iter(int, 1))


@pytest.mark.parametrize("lost", [MemoryError, SystemError("error return without exception set")])
def test_memory_that_runs_out_outside_of_any_stage(lost: BaseException) -> None:
    message = "given up at: reading or printing, there is not enough memory"
    with pytest.raises(GaveUpError, match=message), bounded(None, 65536):
        raise lost
