"""Calls for the workers of the tests: what no submission can bring about, and the limits are there for."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path
from typing import TYPE_CHECKING

from lagsolve.grading.pool import Limits

GENEROUS = Limits(120, 512)
"""Seconds and megabytes that no test reaches by itself."""


if TYPE_CHECKING:  # a process that loads no more is ready at once
    from lagrange.answers.submissions import Graded, Submission
    from lagrange.core.diagnostics import Source


def double(x: int) -> int:
    return 2 * x


def process(_: object = None) -> int:
    return os.getpid()


def fail(message: str) -> None:
    raise ValueError(message)


def loop() -> None:
    while True:
        pass


def hold_still(seconds: float) -> int:
    time.sleep(seconds)
    return os.getpid()


def eat() -> int:
    """All memory there is, in pieces."""
    pieces = []
    while True:
        pieces.append(bytearray(1 << 26))


def kill() -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def kill_once(mark: str) -> str:
    """Dies the first time."""
    if not Path(mark).exists():
        Path(mark).touch()
        kill()
    return "alive"


def print_and_answer() -> str:
    print("noise on standard output", flush=True)
    os.write(1, b"more noise")
    return "an answer"


def large(megabytes: int) -> bytes:
    return bytes(megabytes << 20)


class UnpicklableError(Exception):
    def __reduce__(self) -> str:
        raise TypeError


def raise_what_cannot_be_sent() -> None:
    raise UnpicklableError("but its text can")


def examine(submission: Submission, problem: tuple[Source, ...]) -> Graded:
    """As the command does it, apart from submissions that say what is to happen."""
    from lagrange.answers.submissions import Submission
    from lagsolve.grading.examine import examine as real

    said = submission.files[0][1]
    for word, call in {b"LOOP": loop, b"EAT": eat, b"KILL": kill, b"FAIL": lambda: fail("a mistake")}.items():
        if said.startswith(word):
            call()
    if said.startswith(b"ONCE "):
        kill_once(said[5:].decode().strip())
        return real(Submission(submission.name, (("x", b"theta'' + g/l*sin(theta) = 0"),)), problem)
    return real(submission, problem)


def examine_within_limits(
    submission: Submission, problem: tuple[Source, ...], limits: object, setup_seconds: float
) -> Graded:
    """On a worker of a cluster: the same, with a note of which worker it is (in its current folder)."""
    from unittest.mock import patch

    from lagsolve.grading import examine as examining

    Path(f"by-{os.getpid()}").write_text(f"{os.getpid()}\n")
    time.sleep(0.1)
    with patch.object(examining, "examine", examine):
        return examining.examine_within_limits(submission, problem, limits, setup_seconds)  # type: ignore[arg-type]
