"""One run of `lagsolve grade`: the request, the batch, and its results: rows, a CSV file, pages."""

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

from lagrange.answers.submissions import Graded, Submission
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.core.records import record
from lagsolve.command_group import write_stderr
from lagsolve.grading.examine import examine, examine_within_limits, grader, outcomes, prepare
from lagsolve.grading.feedback import page, page_names
from lagsolve.grading.journal import Journal, key
from lagsolve.grading.pool import Pool
from lagsolve.grading.progress import Progress
from lagsolve.grading.submissions import UnreadSubmission, UnreadSubmissionError, entries
from lagsolve.grading.table import HEADER, TableRow, csv_text
from lagsolve.grading.worker import Limits, SetupError
from lagsolve.limits import AHEAD
from lagsolve.written_files import unwritable, write_file


@record
class GradingRun:
    """The request of the command line. `csv` and `feedback` are None where they are not wanted."""

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
        """The file of the journal: beside the CSV file, or in the folder of pages."""
        if self.csv is not None and (self.csv.is_file() or not self.csv.exists()):
            return self.csv.with_name(f"{self.csv.name}.journal")
        return self.feedback / ".journal" if self.feedback is not None else None

    @property
    def own_files(self) -> list[Path]:
        """The files of the run itself, which are not submissions."""
        return [p for p in (self.problem_file, self.csv, self.journal, self.feedback) if p is not None]


class InterruptedBatchError(KeyboardInterrupt):
    """Ctrl-C during a batch. The message tells how far it got."""


def graded(run: GradingRun) -> list[TableRow]:
    """Grades the batch; writes CSV and pages. The rows are sorted by name.

    Raises ProblemError where it cannot begin, InterruptedBatchError where it was interrupted.
    """
    start = perf_counter()
    title = grader(run.problem).examiner.problem.title
    setup_seconds = 60 + 20 * (perf_counter() - start)
    _refuse_pages_among_answers(run)
    _refuse_overwrite(run.csv)
    unread = entries(run.answers, run.own_files)
    _make_folder(run.feedback)
    batch = Batch(run, title, unread)
    complete = False
    try:
        with _executor(run, setup_seconds) as (executor, function, common, processes):
            batch.run(executor, function, common, processes * AHEAD)
        rows = [batch.rows[e.name] for e in unread]
        if run.csv is not None:
            write_file(run.csv, csv_text(rows))
        complete = True  # not before the table is written: if that fails, the work of the batch is in the journal
    except SetupError as error:
        message = f"the problem cannot be solved within the limits of a submission: it {error}"
        raise ProblemError(Diagnostic("limits-too-low", message, help="raise --memory")) from None
    except (BrokenExecutor, CancelledError):
        message = f"the cluster at {run.dask} has gone: {batch.how_far}"
        raise ProblemError(Diagnostic("no-cluster", message)) from None
    except KeyboardInterrupt:
        raise InterruptedBatchError(f"interrupted: {batch.how_far}") from None
    finally:
        batch.journal.close(complete)
    return rows


@contextmanager
def _executor(run: GradingRun, setup_seconds: float) -> Iterator[tuple[Any, Any, tuple[Any, ...], int]]:
    """An executor, the function it runs with its further arguments, and the number of its processes."""
    if run.dask is not None:
        from lagsolve.grading.pool import cluster

        with cluster(run.dask) as (executor, threads):
            yield executor, examine_within_limits, (run.problem, run.limits, setup_seconds), threads
        return
    pool = Pool(run.jobs, run.limits, partial(prepare, run.problem), setup_seconds)
    try:
        yield pool, examine, (run.problem,), run.jobs
    finally:
        pool.shutdown(cancel_futures=True)


class Batch:
    """The rows of a batch as they come, each added to the journal once its page is written."""

    def __init__(self, run: GradingRun, title: str, unread: Sequence[UnreadSubmission]) -> None:
        self._run, self._title, self._entries = run, title, unread
        self._pages = page_names(e.name for e in unread)
        self._version = version("lagsolve")
        self._keys: dict[str, str] = {}  # of submissions that are being graded
        self.rows: dict[str, TableRow] = {}
        try:
            self.journal = Journal(run.journal)
        except OSError as error:
            raise unwritable(str(run.journal), error) from None
        if self.journal.ignored:
            message = f"{run.journal} has {_lines(self.journal.ignored)} that no batch has written"
            help_ = "what it says is not used, and those submissions are graded again"
            write_stderr(str(Diagnostic("journal-ignored", message, help=help_).as_note()))

    @property
    def how_far(self) -> str:
        """The message where a batch does not reach its end."""
        done = f"{len(self.rows):,} of {len(self._entries):,} submissions are graded"
        if self.journal.path is None:
            return f"{done}; with --csv or --feedback the same command would continue from here"
        return f"{done}; the same command continues from here"

    def run(self, executor: Any, function: Any, common: tuple[Any, ...], ahead: int) -> None:
        """Grades the submissions that are not in the journal."""
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
        """Reads the submissions one by one; those that need not, or cannot, be graded get their rows at once."""
        run = self._run
        for entry in self._entries:
            try:
                submission = entry.read()
            except UnreadSubmissionError as error:
                self._note(entry.name, Graded(Verdict.UNREADABLE, f"unreadable: it {error}"), None)
                continue
            under = key(submission, self._version, run.problem.text, run.limits)
            row = self.journal.row(under)
            if row is not None and row.submission == entry.name and self._has_page(row):
                self.rows[entry.name] = row
            else:
                self._keys[entry.name] = under
                yield submission

    def _has_page(self, row: TableRow) -> bool:
        feedback = self._run.feedback
        if feedback is None:
            return not row.feedback
        return row.feedback == self._pages[row.submission] and (feedback / row.feedback).is_file()

    def _note(self, name: str, graded: Graded, under: str | None) -> None:
        feedback = self._run.feedback
        if feedback is not None:
            write_file(feedback / self._pages[name], page(self._title, name, graded), follow=False)
        row = TableRow.of(name, graded, self._pages[name] if feedback is not None else "")
        self.rows[name] = row
        if under is not None:
            try:
                self.journal.add(under, row)
            except OSError as error:
                raise unwritable(str(self.journal.path), error) from None


def _lines(number: int) -> str:
    return "a line" if number == 1 else f"{number:,} lines"


def _make_folder(folder: Path | None) -> None:
    """Makes the folder of pages. Raises ProblemError where that is impossible."""
    try:
        if folder is not None:
            folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(str(folder), error) from None


def _refuse_pages_among_answers(run: GradingRun) -> None:
    """Raises ProblemError where the pages would be taken for submissions the next time."""
    feedback = run.feedback
    if feedback is not None and os.path.realpath(feedback) in map(os.path.realpath, run.answers):
        message = f"{feedback} is the folder of the submissions: its pages would be graded next time"
        raise ProblemError(Diagnostic("feedback-among-answers", message, help="name another folder with --feedback"))


def _refuse_overwrite(path: Path | None) -> None:
    """Raises ProblemError where the CSV file is not a table of an earlier run but an answer, or the problem."""
    if path is None or not path.is_file():
        return
    try:
        with path.open("rb") as file:
            begin = file.read(len(HEADER))
    except OSError as error:
        raise unwritable(str(path), error) from None
    if begin and begin != HEADER:
        message = f"{path} is not a table of grades, and would be overwritten"
        raise ProblemError(Diagnostic("would-be-lost", message, help="name another file with --csv"))
