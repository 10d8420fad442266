"""A batch: submissions go to an executor, a few at a time, and outcomes come back as they are ready.

The executor is any of `concurrent.futures`. Whatever happens to one submission is its outcome: a limit that it
exceeded, a process that was killed under it (it is tried once more, because it may not be its fault), a mistake of this
program.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from typing import Any

from lagrange.answers.equations import Verdict
from lagrange.answers.grading import Graded, Submission
from lagrange.core.records import record
from lagsolve.grading.worker import FailedError, LostError, SetupError, StoppedError

TRIES = 2
PULSE = 0.5
"""Seconds between two looks at the clock while nothing is ready."""


@record
class _Trial:
    submission: Submission
    number: int = 1


def outcomes(
    submissions: Iterator[Submission], executor: Executor, examine: Callable[..., Graded], *common: Any, ahead: int
) -> Generator[tuple[Submission, Graded] | None]:
    """The outcome of each submission, `examine(submission, *common)`, in the order in which they are ready.

    ahead  how many are taken and handed to the executor before the first is ready: what memory is needed for

    None comes from time to time while nothing is ready. Raises SetupError where no submission can be graded,
    BrokenExecutor or CancelledError where the executor gives up.
    """
    running: dict[Future[Graded], _Trial] = {}

    def start(trial: _Trial) -> None:
        running[executor.submit(examine, trial.submission, *common)] = trial

    exhausted = False
    while running or not exhausted:
        while not exhausted and len(running) < ahead:
            submission = next(submissions, None)
            if submission is None:
                exhausted = True
            else:
                start(_Trial(submission))
        done = wait(running, timeout=PULSE, return_when=FIRST_COMPLETED).done
        if not done:
            yield None
        for future in done:
            trial = running.pop(future)
            graded = _graded(future, last=trial.number == TRIES)
            if graded is None:
                start(_Trial(trial.submission, trial.number + 1))
            else:
                yield trial.submission, graded


def _graded(future: Future[Graded], last: bool) -> Graded | None:
    """The outcome; None where it is to be tried again. Raises what concerns the whole batch."""
    try:
        return future.result()
    except (SetupError, BrokenExecutor, CancelledError):
        raise
    except LostError as error:
        return _not_judged(f"it {error}") if last else None
    except FailedError as error:
        return _not_judged(f"it could not be graded ({error})")
    except StoppedError as error:
        return _not_judged(f"it {error}")
    except Exception as error:
        return _not_judged(f"it could not be graded ({type(error).__name__}: {error})")


def _not_judged(reason: str) -> Graded:
    """Somebody must look at it."""
    return Graded(Verdict.UNDECIDED, f"undecided: {' '.join(reason.split())[:300]}")
