"""One run of `lagsolve grade`: the request, the batch, and its results: rows, a CSV file, pages."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import BrokenExecutor, CancelledError
from contextlib import closing, contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import lagrange
from lagrange.answers.submissions import Graded, Submission
from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.core.records import record
from lagsolve.command_group import write_stderr
from lagsolve.grading.examine import examine, examine_within_limits, grader, outcomes, prepare, problem_of
from lagsolve.grading.feedback import page, page_names
from lagsolve.grading.journal import Journal, key
from lagsolve.grading.pool import Limits, Pool, SetupError
from lagsolve.grading.students import Attempts, Roster, attributed, identity
from lagsolve.grading.submissions import (
    AssignedProblem,
    UnreadSubmission,
    UnreadSubmissionError,
    divided,
    named_submissions,
    one_entry,
)
from lagsolve.grading.table import HEADER, TableRow, csv_text
from lagsolve.limits import AHEAD, PROGRESS_ELSEWHERE, PROGRESS_ON_TERMINAL, SETUP_SECONDS
from lagsolve.written_files import unwritable, write_file


@record
class GradingRun:
    """The request of the command line. `csv` and `feedback` are None if they are not wanted.

    problems  the problems of the assignment, each with its label
    hint      how much pages and remarks reveal: 1, 2 or 3
    together  whether everything that is named is one submission
    seeded    whether each student has a variant of their own
    own       further files that are no submissions
    """

    problems: tuple[tuple[str, Source], ...]
    answers: tuple[str, ...]
    limits: Limits
    jobs: int
    dask: str | None = None
    csv: Path | None = None
    feedback: Path | None = None
    hint: int = 3
    together: bool = False
    seeded: bool = False
    platform: str = ""
    roster: Roster = Roster()
    attempts: Attempts | None = None
    own: tuple[Path, ...] = ()

    @property
    def sources(self) -> tuple[Source, ...]:
        """The texts of the problems."""
        return tuple(source for _, source in self.problems)

    @property
    def journal(self) -> Path | None:
        """The file of the journal: beside the CSV file, or in the folder of pages."""
        if self.csv is not None and (self.csv.is_file() or not self.csv.exists()):
            return self.csv.with_name(f"{self.csv.name}.journal")
        return self.feedback / ".journal" if self.feedback is not None else None

    @property
    def own_files(self) -> list[Path]:
        """The files of the run itself, which are not submissions."""
        problems = (Path(source.name) for source in self.sources)
        return [*problems, *self.own, *(p for p in (self.csv, self.journal, self.feedback) if p is not None)]

    def seed(self, name: str) -> str:
        """The seed of the student who handed something in: that of the roster, or who the student is."""
        if not self.seeded:
            return ""
        who = identity(name, self.platform, self.attempts is not None).student
        return self.roster.of(name, who).seed or who


class InterruptedBatchError(KeyboardInterrupt):
    """Ctrl-C during a batch. The message tells how far it got."""


def graded(run: GradingRun) -> list[TableRow]:
    """Grades the batch; writes CSV and pages. The rows are sorted by name.

    Raises ProblemError if it cannot begin, InterruptedBatchError where it was interrupted.
    """
    return all_results(run)[0]


Outcome = tuple[str, int, Graded]
"""The name of a submission, the problem it answers, and what came out."""


def all_results(run: GradingRun) -> tuple[list[TableRow], list[Outcome]]:
    """The same, with what came out of those that were graded now and not found in the journal."""
    asked = tuple(AssignedProblem(label, problem_of(source).title, source) for label, source in run.problems)
    if run.seeded and not any(problem_of(source).vary for source in run.sources):
        help_ = "say what varies, as `vary: {l: {from: 0.2 m, to: 1 m, step: 0.1 m}}`"
        raise ProblemError(Diagnostic("nothing-varies", "none of the problems has `vary`", help=help_))
    _refuse_pages_among_answers(run)
    _refuse_overwrite(run.csv)
    unread = [one_entry(run.answers)] if run.together else named_submissions(run.answers, run.own_files)
    _make_folder(run.feedback)
    batch = Batch(run, asked, unread)
    complete = False
    try:
        with _executor(run) as (executor, function, common, processes):
            batch.run(executor, function, common, processes * AHEAD)
        ordered = [batch.rows[e.name, n] for e in unread for n in range(len(asked))]
        rows = attributed(ordered, run.roster, run.platform, run.attempts)
        if run.csv is not None:
            write_file(run.csv, csv_text(rows))
        complete = True  # not before the table is written: if that fails, the work of the batch is in the journal
    except SetupError as error:
        for source in run.sources:
            grader(source)  # here it says why it cannot be solved, if that is no matter of limits
        the = "the problem" if len(asked) == 1 else "one of the problems"
        message = f"{the} cannot be solved within the limits of a submission: it {error}"
        raise ProblemError(Diagnostic("limits-too-low", message, help="raise --memory")) from None
    except (BrokenExecutor, CancelledError):
        message = f"the cluster at {run.dask} has gone: {batch.how_far}"
        raise ProblemError(Diagnostic("no-cluster", message)) from None
    except KeyboardInterrupt:
        raise InterruptedBatchError(f"interrupted: {batch.how_far}") from None
    finally:
        batch.journal.close(complete)
    return rows, batch.outcomes


@contextmanager
def _executor(run: GradingRun) -> Iterator[tuple[Any, Any, tuple[Any, ...], int]]:
    """An executor, the function it runs with its further arguments, and the number of its processes."""
    if run.dask is not None:
        from lagsolve.grading.pool import cluster

        with cluster(run.dask) as (executor, threads):
            yield executor, examine_within_limits, (run.sources, run.limits, SETUP_SECONDS), threads
        return
    pool = Pool(run.jobs, run.limits, partial(prepare, run.sources), SETUP_SECONDS)
    try:
        yield pool, examine, (run.sources,), run.jobs
    finally:
        pool.shutdown(cancel_futures=True)


SubmissionKey = tuple[str, int]
"""The name of a submission, and the problem it answers."""


class Batch:
    """The rows of a batch as they come, each added to the journal once its page is written."""

    def __init__(self, run: GradingRun, asked: Sequence[AssignedProblem], unread: Sequence[UnreadSubmission]) -> None:
        self._run, self._asked, self._entries = run, asked, unread
        self._pages = page_names(self._called((e.name, n)) for e in unread for n in range(len(asked)))
        self._version = lagrange.__version__
        self._keys: dict[SubmissionKey, str] = {}  # of submissions that are being graded
        self.rows: dict[SubmissionKey, TableRow] = {}
        self.outcomes: list[Outcome] = []
        try:
            self.journal = Journal(run.journal)
        except OSError as error:
            raise unwritable(str(run.journal), error) from None
        if self.journal.ignored:
            message = f"{run.journal} has {_lines(self.journal.ignored)} that no batch has written"
            help_ = "what it says is not used, and those submissions are graded again"
            write_stderr(str(Diagnostic("journal-ignored", message, help=help_).as_note()))

    def _called(self, key: SubmissionKey) -> str:
        """What a part of a submission is called: by its problem too, where there are several."""
        name, problem = key
        return name if len(self._asked) == 1 else f"{name} {self._asked[problem].label}"

    @property
    def how_far(self) -> str:
        """The message where a batch does not reach its end."""
        done = f"{len(self.rows) // len(self._asked):,} of {len(self._entries):,} submissions are graded"
        if self.journal.path is None:
            return f"{done}; with --csv or --feedback the same command would continue from here"
        return f"{done}; the same command continues from here"

    def run(self, executor: Any, function: Any, common: tuple[Any, ...], ahead: int) -> None:
        """Grades the submissions that are not in the journal."""
        progress = Progress(len(self._entries) * len(self._asked))
        with closing(outcomes(self._to_grade(), executor, function, *common, ahead=ahead)) as ready:
            try:
                for outcome in ready:
                    if outcome is not None:
                        submission, graded = outcome
                        part = submission.name, submission.problem
                        self._note(part, graded, self._keys.pop(part))
                    progress.step(len(self.rows), graded=outcome is not None)
            finally:
                progress.end()

    def _to_grade(self) -> Iterator[Submission]:
        """Reads the submissions one by one; those that need not, or cannot, be graded get their rows at once."""
        run = self._run
        for entry in self._entries:
            try:
                parts = divided(entry.read(), self._asked)
            except UnreadSubmissionError as error:
                parts = f"it {error}"
            if isinstance(parts, str):
                self._note_unread(entry.name, parts)
                continue
            for part in parts:
                varies = problem_of(run.sources[part.problem]).vary
                submission = replace(part, seed=run.seed(entry.name) if varies else "")
                under = key(submission, self._version, run.sources[part.problem].text, run.limits, run.hint)
                row = self.journal.row(under)
                if row is not None and self._is_of(row, entry.name, part.problem) and self._has_page(row, part.problem):
                    self.rows[entry.name, part.problem] = row
                else:
                    self._keys[entry.name, part.problem] = under
                    yield submission

    def _note_unread(self, name: str, why: str) -> None:
        """The rows of a submission that is not graded: no points for any problem."""
        for n, source in enumerate(self._run.sources):
            unread = grader(source).unread(why)
            self._note((name, n), unread if len(self._asked) > 1 else replace(unread, right=None, required=None), None)

    def _is_of(self, row: TableRow, name: str, problem: int) -> bool:
        return (row.submission, row.problem) == (name, self._asked[problem].label)

    def _has_page(self, row: TableRow, problem: int) -> bool:
        feedback = self._run.feedback
        if feedback is None:
            return not row.feedback
        return (
            row.feedback == self._pages[self._called((row.submission, problem))] and (feedback / row.feedback).is_file()
        )

    def _note(self, part: SubmissionKey, graded: Graded, under: str | None) -> None:
        feedback, asked, hint = self._run.feedback, self._asked[part[1]], self._run.hint
        page_name = self._pages[self._called(part)]
        if graded.score is None:  # a limit was exceeded: a person has to look at it
            unjudged = grader(self._run.sources[part[1]]).unread("")
            graded = replace(graded, score=unjudged.score.undecided if unjudged.score else None)
        if feedback is not None:
            write_file(feedback / page_name, page(asked.title, part[0], graded.at_hint_level(hint)), follow=False)
        row = TableRow.of(part[0], graded, page_name if feedback is not None else "", asked.label, hint)
        self.rows[part] = row
        if self._run.together:
            self.outcomes.append((*part, graded.at_hint_level(hint)))
        if under is not None:
            try:
                self.journal.add(under, row)
            except OSError as error:
                raise unwritable(str(self.journal.path), error) from None


def _lines(number: int) -> str:
    return "a line" if number == 1 else f"{number:,} lines"


def _make_folder(folder: Path | None) -> None:
    """Makes the folder of pages. Raises ProblemError if that is impossible."""
    try:
        if folder is not None:
            folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(str(folder), error) from None


def _refuse_pages_among_answers(run: GradingRun) -> None:
    """Raises ProblemError if the pages would be taken for submissions the next time."""
    feedback = run.feedback
    if feedback is not None and os.path.realpath(feedback) in map(os.path.realpath, run.answers):
        message = f"{feedback} is the folder of the submissions: the pages in it would be graded next time"
        raise ProblemError(Diagnostic("feedback-among-answers", message, help="name another folder with --feedback"))


def _refuse_overwrite(path: Path | None) -> None:
    """Raises ProblemError if the CSV file is not a table of an earlier run but an answer, or the problem."""
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


# -- The progress of a batch on standard error: a line that changes on a terminal, otherwise a line now and then -------


class Progress:
    """Counts submissions; prints nothing if a batch is short."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._terminal = sys.stderr is not None and sys.stderr.isatty()
        self._start = self._last = time.monotonic()
        self._first: tuple[float, int] | None = None  # when the first was graded, and how many were done by then

    def step(self, done: int, graded: bool) -> None:
        """Updates the number of submissions that are done; `graded`: one has just been graded."""
        now = time.monotonic()
        if graded and self._first is None:
            self._first = now, done
        if sys.stderr is None or now - self._last < (PROGRESS_ON_TERMINAL if self._terminal else PROGRESS_ELSEWHERE):
            return
        self._last = now
        line = f"{done:,} of {self._total:,} graded, {now - self._start:.0f} s{self._left(now, done)}"
        sys.stderr.write(f"\r\x1b[K{line}" if self._terminal else f"{line}\n")
        sys.stderr.flush()

    def _left(self, now: float, done: int) -> str:
        """The time that remains, estimated from the time since the processes were ready."""
        if self._first is None or done == self._first[1]:
            return ""
        since, before = self._first
        return f", about {(now - since) * (self._total - done) / (done - before):.0f} s more"

    def end(self) -> None:
        """Removes the line."""
        if self._terminal:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
