"""Grading the submissions of a batch: what a worker does, and how its executor is kept busy.

A worker solves the problems once and then compares one submission after another with it. Submissions are handed to the
executor, which is any of `concurrent.futures`, a few at a time, and outcomes come back as they are ready. Whatever
happens to one submission is its outcome: a limit that it exceeds, an error of this program, or a process that was
killed during it (which is tried once more, because it may not be its fault).
"""

from __future__ import annotations

import hashlib
import re
import threading
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from dataclasses import replace
from functools import lru_cache, partial
from pathlib import PurePath
from typing import Any

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Graded, Grader, Submission
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Source
from lagrange.core.printable import visible
from lagrange.core.records import record
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagsolve.grading.pool import CallFailedError, CallStoppedError, Limits, LostError, SetupError, Worker
from lagsolve.limits import IDLE_SECONDS, MOST_KEPT_OUTCOMES, MOST_PROBLEMS, POLL_SECONDS, TRIES


@lru_cache(maxsize=MOST_PROBLEMS)
def problem_of(source: Source) -> Problem:
    """The problem of a file, which is not solved for it. Raises ProblemError."""
    return read_problem(source)


@lru_cache(maxsize=MOST_PROBLEMS)
def grader(problem: Source, seed: str = "") -> Grader:
    """The grader of a problem, or of its variant with a seed, which is solved for it. Raises ProblemError."""
    if seed:
        from lagrange.problem.variants.writing import variant_source

        problem = variant_source(problem, seed)
    return Grader.of(Examiner.of(read_problem(problem)))


def prepare(problems: tuple[Source, ...]) -> None:
    """Solves the problems, before submissions come."""
    for problem in problems:
        grader(problem)


def examine(submission: Submission, problems: tuple[Source, ...]) -> Graded:
    """The verdict on a submission to one of the problems."""
    return grader(problems[submission.problem], submission.seed).grade(submission)


_of_thread = threading.local()


def examine_within_limits(
    submission: Submission, problems: tuple[Source, ...], limits: Limits, setup_seconds: float
) -> Graded:
    """The same in a process of this thread alone: for a cluster, whose workers cannot stop a task.

    Raises StoppedError, or SetupError if the problem cannot be solved within the limits.
    """
    worker: Worker | None = getattr(_of_thread, "worker", None)
    same = getattr(_of_thread, "batch", None) == (problems, limits)
    if worker is None or not worker.is_fresh or not same:
        if worker is not None:
            worker.stop()
        _of_thread.worker, _of_thread.batch = None, (problems, limits)
        worker = Worker(limits, IDLE_SECONDS)
        try:
            worker.prepare(partial(prepare, problems), setup_seconds)
        except BaseException:
            worker.stop()
            raise
        _of_thread.worker = worker
    return worker.call(examine, submission, problems)


@record
class _Trial:
    submission: Submission
    number: int = 1


def outcomes(
    submissions: Iterator[Submission], executor: Executor, examine: Callable[..., Graded], *common: Any, ahead: int
) -> Generator[tuple[Submission, Graded] | None]:
    """The outcome of each submission, `examine(submission, *common)`, in the order in which they are ready.

    ahead  how many are handed to the executor before the first is ready; so many are held in memory

    Of submissions with the same files only the first is graded.

    Yields None from time to time while nothing is ready. Raises SetupError if no submission can be graded,
    BrokenExecutor or CancelledError where the executor gives up.
    """
    running: dict[Future[Graded], _Trial] = {}
    equal = _EqualSubmissions()

    def start(trial: _Trial) -> None:
        running[executor.submit(examine, trial.submission, *common)] = trial

    exhausted = False
    while running or not exhausted:
        while not exhausted and len(running) + equal.number_waiting < ahead:
            submission = next(submissions, None)
            if submission is None:
                exhausted = True
            elif (graded := equal.outcome(submission)) is not None:
                yield submission, graded
            elif not equal.waits(submission):
                start(_Trial(submission))
        done = wait(running, timeout=POLL_SECONDS, return_when=FIRST_COMPLETED).done
        if not done:
            yield None
        for future in done:
            trial = running.pop(future)
            graded = _graded(future, last=trial.number == TRIES)
            if graded is None:
                start(_Trial(trial.submission, trial.number + 1))
            else:
                yield trial.submission, graded
                for waiting in equal.settled(trial.submission, graded):
                    outcome = equal.outcome(waiting)
                    if outcome is None:
                        start(_Trial(waiting))
                    else:
                        yield waiting, outcome


class _EqualSubmissions:
    """Submissions with the same files, whose outcomes differ only in the names of the files."""

    def __init__(self) -> None:
        self._first: dict[bytes, Submission] = {}
        self._waiting: dict[bytes, list[Submission]] = {}
        self._known: dict[bytes, tuple[Submission, Graded]] = {}

    @property
    def number_waiting(self) -> int:
        """How many wait, and are held in memory."""
        return sum(map(len, self._waiting.values()))

    def waits(self, submission: Submission) -> bool:
        """Whether it waits for an equal one that is being graded; otherwise it is the first."""
        key = _key(submission)
        if key in self._first:
            self._waiting.setdefault(key, []).append(submission)
            return True
        self._first[key] = submission
        return False

    def settled(self, submission: Submission, graded: Graded) -> list[Submission]:
        """Keeps the outcome of the first; those that waited for it."""
        key = _key(submission)
        if self._first.pop(key, None) is not None and len(self._known) < MOST_KEPT_OUTCOMES:
            self._known[key] = submission, graded
        return self._waiting.pop(key, [])

    def outcome(self, submission: Submission) -> Graded | None:
        """The outcome of an equal submission, with this one's names; None if there is none or a message needs them."""
        first, graded = self._known.get(_key(submission), (None, None))
        if first is None or graded is None:
            return None
        messages = graded.messages
        for (old, _), (new, _) in zip(first.files, submission.files, strict=True):
            if old != new:
                if visible(old) != old or visible(new) != new:
                    return None
                place = re.compile(rf"^(\s*--> ){re.escape(old)}:", re.MULTILINE)
                if any(old in place.sub("", text) for text in (*messages, graded.headline)):
                    return None
                messages = tuple(place.sub(lambda m, n=new: f"{m[1]}{n}:", m) for m in messages)  # type: ignore[misc]
        return replace(graded, messages=messages, seconds=0.0)


def _key(submission: Submission) -> bytes:
    """What submissions have in common whose outcomes are equal: problem, contents and extensions of files, notes."""
    digest = hashlib.sha256(f"{submission.problem} {submission.seed}\0".encode(errors="surrogatepass"))
    for name, content in submission.files:
        digest.update(f"{PurePath(name).suffix.lower()} {len(content)} ".encode(errors="surrogatepass"))
        digest.update(content)
    digest.update("\0".join(submission.notes).encode(errors="surrogatepass"))
    return digest.digest()


def _graded(future: Future[Graded], last: bool) -> Graded | None:
    """The outcome; None if it is to be tried again. Raises whatever concerns the whole batch."""
    try:
        return future.result()
    except (SetupError, BrokenExecutor, CancelledError):
        raise
    except LostError as error:
        return _not_judged(f"it {error}") if last else None
    except CallFailedError as error:
        return _not_judged(f"it could not be graded ({error})")
    except CallStoppedError as error:
        return _not_judged(f"it {error}")
    except MemoryError:
        return _not_judged("it needs more memory than there is")
    except Exception as error:
        return _not_judged(f"it could not be graded ({type(error).__name__}: {error})")


def _not_judged(reason: str) -> Graded:
    """The outcome `undecided`: a person must look at it."""
    return Graded(Verdict.UNDECIDED, f"undecided: {' '.join(reason.split())[:300]}")
