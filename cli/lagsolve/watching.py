"""`--watch`: problems solved again whenever their files are saved.

Files are looked at a few times a second. An editor may write a file in two steps, or write another and rename it: a
change counts when two looks in a row have seen the same. A file that is gone is a change as well.
"""

from __future__ import annotations

import os
import shlex
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import NoReturn

from lagsolve.output import put, styled
from lagsolve.solving import Task
from lagsolve.status import complain, say

PERIOD = 0.25
"""Seconds between two looks."""

State = tuple[tuple[int, ...] | None, ...]


def watch_for_ever(task: Task, wait: Callable[[], None] = lambda: time.sleep(PERIOD)) -> NoReturn:
    """Carries a task out, and again after every change of its files; ends by an exception, as Ctrl-C raises.

    A problem that cannot be read is no reason to end. Raises BrokenPipeError where nobody reads on.
    """
    from lagsolve.reading import problem_path

    paths = list(dict.fromkeys(problem_path(name) for name in task.problems))
    where = task.destination.path
    watched = f"watching {' '.join(shlex.quote(str(p)) for p in paths)}; Ctrl-C ends it"
    for again in changes(paths, wait):
        if again and where is None and styled():
            put("\x1b[H\x1b[2J")
        before = where and _state(where)
        _carry_out(task)
        say(f"\n{where} is written; {watched}" if where and _state(where) != before else f"\n{watched}")
    raise AssertionError("changes never end")


def changes(paths: Sequence[Path], wait: Callable[[], None]) -> Iterator[bool]:
    """Yields False at once, and True after every change of a file, also of one made while the caller was busy."""
    known = state(paths)
    yield False
    while True:
        wait()
        now = state(paths)
        if now == known:
            continue
        before = known
        while now != before:
            wait()
            before, now = now, state(paths)
        if now != known:
            known = now
            yield True


def state(paths: Sequence[Path]) -> State:
    """What tells that a file is another than before: when it was written, its size, and which file it is."""
    return tuple(_state(path) for path in paths)


def _state(path: Path) -> tuple[int, ...] | None:
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino, found.st_dev


def _carry_out(task: Task) -> None:
    """Carries a task out once. What goes wrong is shown."""
    try:
        task.carry_out()
    except BrokenPipeError:
        raise
    except Exception as error:
        complain(error)
