"""Verdicts on values that are stated by name: answers to questions, velocities and impulses, amplitudes."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, AnswerVerdict, EquationVerdict, Verdict
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError

Judged = tuple[Verdict, str]
"""A verdict, with its diagnosis or remark."""

_ORDER = (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED, Verdict.INCOMPLETE, Verdict.TRIVIAL)


def worst(parts: list[EquationVerdict]) -> Verdict:
    """The verdict on all together: the first of these that one of them has, otherwise that they are right."""
    return next((v for v in _ORDER if any(p.verdict is v for p in parts)), Verdict.EQUIVALENT)


def check_each(key: str, stated: Mapping[str, Fragment], judged: Callable[[str, Fragment], Judged]) -> AnswerVerdict:
    """The verdict on all entries of a key; `judged` may raise ProblemError and DivisionByZeroError."""
    parts: list[EquationVerdict] = []
    errors: list[Diagnostic] = []
    for name, fragment in stated.items():
        try:
            verdict, comment = judged(name, fragment)
        except ProblemError as error:
            errors += error.diagnostics
            verdict, comment = Verdict.UNREADABLE, error.diagnostics[0].message if error.diagnostics else ""
        except DivisionByZeroError:
            verdict, comment = Verdict.UNREADABLE, DIVIDES_BY_ZERO
        parts.append(EquationVerdict.of(f"{name}: {fragment.text}", verdict, comment))
    return AnswerVerdict(worst(parts), tuple(parts), unreadable=tuple(errors), name=key)
