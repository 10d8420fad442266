"""What is carried out in a worker: the problem is solved once, then submission after submission is compared with it."""

from __future__ import annotations

import threading
from functools import lru_cache, partial

from lagrange.answers.examiner import Examiner
from lagrange.answers.grading import Graded, Grader, Submission
from lagrange.core.diagnostics import Source
from lagrange.problem.loader import read_problem
from lagsolve.grading.worker import Limits, Worker

IDLE = 60.0
"""Seconds after which a process on a cluster ends that has nothing to do."""


@lru_cache(maxsize=1)
def grader(problem: Source) -> Grader:
    """The problem, solved. Raises ProblemError."""
    return Grader.of(Examiner.of(read_problem(problem)))


def prepare(problem: Source) -> None:
    """Solves the problem, before submissions come."""
    grader(problem)


def examine(submission: Submission, problem: Source) -> Graded:
    """The verdict on a submission."""
    return grader(problem).grade(submission)


_of_thread = threading.local()


def examine_within_limits(submission: Submission, problem: Source, limits: Limits, setup_seconds: float) -> Graded:
    """The same in a process of this thread's own: for a cluster, whose workers cannot stop a task.

    Raises StoppedError, or SetupError where the problem cannot be solved within the limits.
    """
    worker: Worker | None = getattr(_of_thread, "worker", None)
    same = getattr(_of_thread, "batch", None) == (problem, limits)
    if worker is None or not worker.is_fresh or not same:
        if worker is not None:
            worker.stop()
        _of_thread.worker, _of_thread.batch = None, (problem, limits)
        worker = Worker(limits, IDLE)
        try:
            worker.prepare(partial(prepare, problem), setup_seconds)
        except BaseException:
            worker.stop()
            raise
        _of_thread.worker = worker
    return worker.call(examine, submission, problem)
