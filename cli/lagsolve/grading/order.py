"""One run of `lagsolve grade`: what is asked for, the batch, and what is left of it: rows, a CSV file, pages.

Exit status: 0 every submission has its verdict, whatever it is; 3 somebody must look at some of them, because they are
undecided or could not be graded within the limits; 130 interrupted.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import BrokenExecutor, CancelledError
from contextlib import closing, contextmanager
from functools import partial
from importlib.metadata import version
from pathlib import Path
from time import perf_counter
from typing import Any

from lagrange.answers.equations import Verdict
from lagrange.answers.grading import Graded, Submission
from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.core.records import record
from lagsolve.grading.batch import outcomes
from lagsolve.grading.examining import examine, examine_within_limits, grader, prepare
from lagsolve.grading.feedback import page, page_names
from lagsolve.grading.journal import Journal, key
from lagsolve.grading.pool import Pool
from lagsolve.grading.progress import Progress
from lagsolve.grading.rows import HEADER, Row, csv_text
from lagsolve.grading.submissions import Entry, RefusedError, entries
from lagsolve.grading.worker import Limits, SetupError

AHEAD = 4
"""Submissions handed over for each process, so that none waits for the next."""


@record
class Order:
    """What the command line asks for. `csv` and `feedback` are None where they are not wanted."""

    problem: Source
    answers: tuple[str, ...]
    limits: Limits
    jobs: int
    dask: str | None = None
    csv: Path | None = None
    feedback: Path | None = None
    problem_file: Path | None = None

    @property
    def journal(self) -> Path | None:
        """Where it is noted what is done: beside the CSV file, or in the folder of pages."""
        if self.csv is not None and (self.csv.is_file() or not self.csv.exists()):
            return self.csv.with_name(f"{self.csv.name}.journal")
        return self.feedback / ".journal" if self.feedback is not None else None

    @property
    def own_files(self) -> list[Path]:
        """What is no submission, wherever it is."""
        return [p for p in (self.problem_file, self.csv, self.journal, self.feedback) if p is not None]


class InterruptedBatchError(KeyboardInterrupt):
    """Ctrl-C during a batch. The message says how far it came."""


def graded(order: Order) -> list[Row]:
    """Grades the batch; writes CSV and pages. The rows are sorted by name.

    Raises ProblemError where it cannot begin, InterruptedBatchError where it was interrupted.
    """
    start = perf_counter()
    title = grader(order.problem).examiner.problem.title
    setup_seconds = 60 + 20 * (perf_counter() - start)
    _refuse_pages_among_answers(order)
    _spare(order.csv)
    found = entries(order.answers, order.own_files)
    _make_room(order.feedback)
    batch = Batch(order, title, found)
    complete = False
    try:
        with _executor(order, setup_seconds) as (executor, function, common, processes):
            batch.run(executor, function, common, processes * AHEAD)
        complete = True
    except SetupError as error:
        message = f"the problem cannot be solved within the limits of a submission: it {error}"
        raise ProblemError(Diagnostic("limits-too-low", message, help="raise --memory")) from None
    except (BrokenExecutor, CancelledError):
        message = f"the cluster at {order.dask} has gone: {batch.how_far}"
        raise ProblemError(Diagnostic("no-cluster", message)) from None
    except KeyboardInterrupt:
        raise InterruptedBatchError(f"interrupted: {batch.how_far}") from None
    finally:
        batch.journal.close(complete)
    rows = [batch.rows[e.name] for e in found]
    if order.csv is not None:
        _write(Path(os.path.realpath(order.csv)), csv_text(rows))
    return rows


@contextmanager
def _executor(order: Order, setup_seconds: float) -> Iterator[tuple[Any, Any, tuple[Any, ...], int]]:
    """An executor, what it is to carry out with which further arguments, and how many processes it has."""
    if order.dask is not None:
        from lagsolve.grading.cluster import cluster

        with cluster(order.dask) as (executor, threads):
            yield executor, examine_within_limits, (order.problem, order.limits, setup_seconds), threads
        return
    pool = Pool(order.jobs, order.limits, partial(prepare, order.problem), setup_seconds)
    try:
        yield pool, examine, (order.problem,), order.jobs
    finally:
        pool.shutdown(cancel_futures=True)


class Batch:
    """The rows of a batch as they come, each noted in the journal once its page is written."""

    def __init__(self, order: Order, title: str, found: Sequence[Entry]) -> None:
        self._order, self._title, self._entries = order, title, found
        self._pages = page_names(e.name for e in found)
        self._version = version("lagsolve")
        self._keys: dict[str, str] = {}  # of submissions that are being graded
        self.rows: dict[str, Row] = {}
        try:
            self.journal = Journal(order.journal)
        except OSError as error:
            raise _unwritable(order.journal, error) from None

    @property
    def how_far(self) -> str:
        """What to say when it does not come to its end."""
        done = f"{len(self.rows):,} of {len(self._entries):,} submissions are graded"
        if self.journal.path is None:
            return f"{done}; with --csv or --feedback the same command would go on from here"
        return f"{done}; the same command goes on from here"

    def run(self, executor: Any, function: Any, common: tuple[Any, ...], ahead: int) -> None:
        """Grades what is not known yet."""
        progress = Progress(len(self._entries))
        with closing(outcomes(self._to_grade(), executor, function, *common, ahead=ahead)) as ready:
            try:
                for outcome in ready:
                    if outcome is not None:
                        submission, graded = outcome
                        self._note(submission.name, graded, self._keys.pop(submission.name))
                    progress.step(len(self.rows), graded=outcome is not None)
            finally:
                progress.end()

    def _to_grade(self) -> Iterator[Submission]:
        """Reads the submissions one by one; those that need not be graded, or cannot, have their rows at once."""
        order = self._order
        for entry in self._entries:
            try:
                submission = entry.read()
            except RefusedError as error:
                self._note(entry.name, Graded(Verdict.UNREADABLE, f"unreadable: it {error}"), None)
                continue
            under = key(submission, self._version, order.problem.text, order.limits)
            row = self.journal.row(under)
            if row is not None and self._has_page(row):
                self.rows[entry.name] = row
            else:
                self._keys[entry.name] = under
                yield submission

    def _has_page(self, row: Row) -> bool:
        feedback = self._order.feedback
        return feedback is None or (row.feedback == self._pages[row.submission] and (feedback / row.feedback).is_file())

    def _note(self, name: str, graded: Graded, under: str | None) -> None:
        feedback = self._order.feedback
        if feedback is not None:
            _write(feedback / self._pages[name], page(self._title, name, graded))
        row = Row.of(name, graded, self._pages[name] if feedback is not None else "")
        self.rows[name] = row
        if under is not None:
            self.journal.add(under, row)


def _make_room(folder: Path | None) -> None:
    """The folder of pages. Raises ProblemError where it cannot be."""
    try:
        if folder is not None:
            folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise _unwritable(folder, error) from None


def _refuse_pages_among_answers(order: Order) -> None:
    """Raises ProblemError where the pages would pass for submissions the next time."""
    feedback = order.feedback
    if feedback is not None and os.path.realpath(feedback) in map(os.path.realpath, order.answers):
        message = f"{feedback} is the folder of the submissions: its pages would be graded next time"
        raise ProblemError(Diagnostic("feedback-among-answers", message, help="name another folder with --feedback"))


def _spare(path: Path | None) -> None:
    """Refuses to write over what is no table of an earlier run: an answer, or the problem."""
    if path is None or not path.is_file():
        return
    with path.open("rb") as file:
        begin = file.read(len(HEADER))
    if begin and begin != HEADER:
        message = f"{path} is no table of grades, and would be written over"
        raise ProblemError(Diagnostic("would-be-lost", message, help="name another file with --csv"))


def _write(path: Path, text: str) -> None:
    """Writes a file as a whole, so that nobody finds half of it; what is there is replaced, and no link followed."""
    try:
        if path.exists() and not path.is_file():
            path.write_text(text, encoding="utf-8", newline="")
            return
        draft = path.with_name(f".{path.name}.{os.getpid()}")
        draft.unlink(missing_ok=True)
        with draft.open("x", encoding="utf-8", newline="") as file:
            file.write(text)
        os.replace(draft, path)
    except OSError as error:
        raise _unwritable(path, error) from None


def _unwritable(path: Path | None, error: OSError) -> ProblemError:
    return ProblemError(Diagnostic("cannot-write", f"{path} cannot be written: {error.strerror}"))
