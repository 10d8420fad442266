"""Solving the problems of one command line, once or, with `--watch`, again whenever their files are saved.

Files are looked at a few times a second. An editor may write a file in two steps, or write another file and rename it:
a change counts once two consecutive looks agree. A file that disappears is a change as well.
"""

from __future__ import annotations

import gc
import os
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from lagrange.core.records import record
from lagsolve.command_group import report_error, write_stderr
from lagsolve.exit_statuses import OK, UNDECIDED
from lagsolve.limits import WATCH_SECONDS
from lagsolve.output import Destination, styled, write_stdout
from lagsolve.progress_line import stage_shown

if TYPE_CHECKING:
    from lagrange.explain.report import Report


@record
class SolveTask:
    """The problems to be solved, the method, and the destination of the result.

    settings  texts NAME=VALUE, the values of parameters
    digits    of results in numbers
    seconds, megabytes  after which a problem is given up; None: never
    """

    problems: tuple[str, ...]
    choice: str | None
    method: str
    destination: Destination
    settings: tuple[str, ...] = ()
    digits: int = 4
    seconds: float | None = None
    megabytes: int | None = None

    def run(self) -> int:
        """Solves the problems, writes the reports and returns the exit status. Raises as `Destination.write`."""
        reports, status = [], OK
        for name in self.problems:
            report, outcome = self._solved(name)
            reports.append(report)
            status = max(status, outcome)
        if any(reports):
            self.destination.write(reports)
        return status

    def _solved(self, name: str) -> tuple[Report | None, int]:
        """The report and its exit status. Messages go to standard error, below the name where there are several."""
        heading = f"{name}:\n" if len(self.problems) > 1 else ""
        try:
            solved = self._report(name)
        except Exception as error:
            return None, report_error(error, heading)
        messages = (*solved.notes, *solved.shortcomings)
        if messages:
            write_stderr(heading + "\n".join(map(str, messages)))
        return solved, OK if solved.holds else UNDECIDED

    def _report(self, name: str) -> Report:
        gc.disable()
        with stage_shown() as on_stage:
            from lagrange.core.effort import unlimited
            from lagrange.explain.report import report
            from lagrange.mechanics.dynamics.motion import Method
            from lagrange.problem.loader import read_problem
            from lagsolve.inputs import problem_source, settings_read
            from lagsolve.time_and_memory import bounded

            look_for_garbage_seldom()
            on_stage("reading the problem")
            patient = nullcontext() if self.seconds is None else unlimited()  # so long was allowed
            with bounded(self.seconds, self.megabytes), patient:
                problem = read_problem(problem_source(name), settings_read(self.settings))
                complete, method, digits = self.destination.is_complete, Method(self.method), self.digits
                return report(problem, self.choice, complete=complete, method=method, digits=digits, on_stage=on_stage)


def look_for_garbage_seldom() -> None:
    """Collects garbage rarely, once everything is imported: modules stay anyway, and so does most of what a run makes.

    Collecting as often as Python does would take a tenth of the time; a large problem must still not fill the memory.
    """
    if gc.get_threshold()[0] < 200_000:
        gc.freeze()
        gc.set_threshold(200_000, 20, 50)
    gc.enable()


FileState = tuple[tuple[int, ...] | None, ...]


def watch_for_ever(task: SolveTask, wait: Callable[[], None] = lambda: time.sleep(WATCH_SECONDS)) -> NoReturn:
    """Runs a task, and again after every change of its files, until an exception such as that of Ctrl-C ends it.

    A problem that cannot be read does not end it. Raises BrokenPipeError if the reader of the output has gone.
    """
    from lagsolve.inputs import problem_path

    paths = list(dict.fromkeys(problem_path(name) for name in task.problems))
    where = task.destination.path
    import shlex

    watched = f"watching {' '.join(shlex.quote(str(p)) for p in paths)}; Ctrl-C ends it"
    for again in changes(paths, wait):
        if again and where is None and styled():
            write_stdout("\x1b[H\x1b[2J")
        before = where and _state(where)
        _run_reporting_errors(task)
        write_stderr(f"\n{where} is written; {watched}" if where and _state(where) != before else f"\n{watched}")
    raise AssertionError("changes never end")


def changes(paths: Sequence[Path], wait: Callable[[], None]) -> Iterator[bool]:
    """Yields False at once, and True after every change of a file, even if made while the caller was busy."""
    known = state_of_file(paths)
    yield False
    while True:
        wait()
        now = state_of_file(paths)
        if now == known:
            continue
        before = known
        while now != before:
            wait()
            before, now = now, state_of_file(paths)
        if now != known:
            known = now
            yield True


def state_of_file(paths: Sequence[Path]) -> FileState:
    """A value that differs if a file has changed: its time of writing, its size, and which file it is."""
    return tuple(_state(path) for path in paths)


def _state(path: Path) -> tuple[int, ...] | None:
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino, status.st_dev


def _run_reporting_errors(task: SolveTask) -> None:
    """Runs a task once; errors are shown."""
    try:
        task.run()
    except BrokenPipeError:
        raise
    except Exception as error:
        report_error(error)
