"""The exit status of the command, from the verdict on an answer or the kind of error.

0    done, and every check held; the answer is equivalent
1    the answer is wrong, incomplete or trivial
2    something cannot be read, or contradicts itself
3    undecided, not completed, or a check failed
130  interrupted by Ctrl-C
141  the reader of a pipe has gone
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from lagrange.answers.verdicts import Verdict

OK, WRONG, UNREADABLE, UNDECIDED = 0, 1, 2, 3
INTERRUPTED, BROKEN_PIPE = 130, 141
"""128 plus the number of the signal, as a shell reports a program that SIGINT or SIGPIPE has ended."""

_OF_VERDICTS = {
    "equivalent": OK,
    "wrong": WRONG,
    "incomplete": WRONG,
    "trivial": WRONG,
    "unreadable": UNREADABLE,
    "undecided": UNDECIDED,
}


def status_of_verdict(verdict: Verdict) -> int:
    """The exit status of `check` for a verdict on an answer."""
    return _OF_VERDICTS[verdict.value]


def status_of_error(error: Exception) -> int:
    """The exit status of a command that an error has ended."""
    from lagrange.core.diagnostics import NotCoveredError, ProblemError, UndecidedError

    if isinstance(error, ProblemError) and not isinstance(error, UndecidedError | NotCoveredError):
        return UNREADABLE
    return UNDECIDED
