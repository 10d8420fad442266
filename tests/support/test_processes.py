"""No test can hang: every child process has a time limit, and can be interrupted where this process ignores SIGINT."""

from __future__ import annotations

import ast
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.support.paths import ROOT
from tests.support.processes import started

FILES = sorted(p for p in (ROOT / "tests").rglob("*.py") if p.parent.name != "bench")
LIMITED = {"run": 99, "call": 99, "check_call": 99, "check_output": 99, "wait": 0, "communicate": 1}
"""Ways to wait for a process, and where the limit stands if it is not named."""


def without_limit(text: str) -> list[int]:
    """The lines of a file of tests in which a process is waited for without a limit, or started other than by `started`."""
    found = []
    for call in ast.walk(ast.parse(text)):
        if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Attribute):
            continue
        owner, name = ast.unparse(call.func.value), call.func.attr
        waits = name in ("wait", "communicate") or (owner == "subprocess" and name in LIMITED)
        limited = len(call.args) > LIMITED.get(name, 99) or any(k.arg == "timeout" for k in call.keywords)
        if (waits and not limited) or (owner == "subprocess" and name == "Popen"):
            found.append(call.lineno)
    return found


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.relative_to(ROOT / "tests").as_posix())
def test_every_process_has_a_limit(path: Path) -> None:
    allowed = 1 if path.name == "processes.py" else 0
    assert len(without_limit(path.read_text(encoding="utf-8"))) == allowed


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("subprocess.run(c)", [1]),
        ("subprocess.run(c, check=True, timeout=1)", []),
        ("p.wait()\np.wait(1)\np.wait(timeout=1)", [1]),
        ("p.communicate(b'')\np.communicate(b'', 1)", [1]),
        ("subprocess.Popen(c)", [1]),
        ("runner.run()\nsubprocess.list2cmdline(c)", []),
    ],
)
def test_the_search_finds_what_has_none(text: str, lines: list[int]) -> None:
    assert without_limit(text) == lines


SLEEP = [sys.executable, "-c", "import time; print('ready', flush=True); time.sleep(600)"]


def test_a_process_that_does_not_end_is_killed() -> None:
    before = time.monotonic()
    with started(SLEEP, patience=1, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.read() == b"ready\n"  # ends with the process
    assert process.returncode == -signal.SIGKILL
    assert time.monotonic() - before < 120


def test_a_process_is_killed_when_its_test_fails() -> None:
    with pytest.raises(ZeroDivisionError), started(SLEEP) as process:
        raise ZeroDivisionError
    assert process.returncode == -signal.SIGKILL


def test_a_process_can_be_interrupted_where_the_tests_ignore_it() -> None:
    """As under `nohup make test &`."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with started(SLEEP, patience=30, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            assert process.stdout is not None
            assert process.stdout.readline() == b"ready\n"
            process.send_signal(signal.SIGINT)
            assert b"KeyboardInterrupt" in process.communicate(timeout=30)[1]
        assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)
