"""Wrong accelerations and reactions at the start: which changed problem has them?

At t = 0 the state is given, so that an acceleration or a reaction follows from the equations of motion alone, which
are linear in them. A stated value is compared with the equations of each changed problem in that state.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    InadmissibleError,
    NoPointError,
    UnsupportedError,
)
from lagrange.answers.limits import MAX_MODEL_WORK
from lagrange.answers.models.search import Models, changed_space
from lagrange.answers.references import ReferenceCandidate
from lagrange.core.symbols import t
from lagrange.mechanics.questions.results import Asked


def explained_at_start(claim: sp.Expr, asked: Asked, candidate: ReferenceCandidate) -> str:
    """The changed problem that gives a wrong value at t = 0, in a sentence; empty if none is found.

    candidate  the file's own system
    """
    question = asked.question
    slots = candidate.configuration.slots
    initial = {s.symbol: s.value for s in asked.initial}
    whole = {*slots.coordinates, *slots.velocities}
    at_start = all(c.lhs - c.rhs in (t, -t) for c in question.when) and bool(question.when)
    if not at_start or not whole <= initial.keys():
        return ""
    start = {s: initial[s] for s in whole}
    try:
        equation = candidate.read(question.quantity - claim)
        models = Models(candidate.system, {**candidate.values, **start}, candidate.parts)
        if models.mechanics is None:
            return ""
        return next(of_changed_problems(equation, models), "")
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ValueError):
        pass
    return ""


def of_changed_problems(equation: sp.Expr, models: Models) -> Iterator[str]:
    """The changed problems whose equations an equation follows from at several states, within the work allowed."""
    states = models.states([equation])
    rows = [at.row(equation) for at in states]
    work = MAX_MODEL_WORK
    for number, (_, variation) in enumerate(models.variations):
        work -= len(models.system.equations) * (len(states[0].unknowns) + 1)
        if work < 0 or None in rows:
            return
        if variation.mechanics is None or variation.is_reduced:
            continue
        space = models.space(number, variation)
        if space is None or rows[0] is None or rows[0] not in space:
            continue
        later = [changed_space(variation, at) for at in states[1:]]
        if all(s is not None and r is not None and r in s for s, r in zip(later, rows[1:], strict=True)):
            yield f"this is the answer {variation.clause}"
