"""Somebody else's equilibria with friction at its limit: each alternative belongs to a direction of slip.

An answer is right if each of its alternatives is an equilibrium for some direction, and complete if it has all of them
for every direction.
"""

from __future__ import annotations

from collections.abc import Sequence

from lagrange.answers.equilibria import check_equilibria
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion

_RIGHT = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)


def check_impending(
    alternatives: Sequence[Sequence[Fragment]], motions: Sequence[ImpendingMotion], reference: Reference
) -> AnswerVerdict:
    """The verdict in one set of coordinates; `motions` has each direction of slip."""
    table = [[check_equilibria([a], [m.equilibrium], reference) for a in alternatives] for m in motions]
    unreadable = next((v for row in table for v in row if v.verdict is Verdict.UNREADABLE), None)
    if unreadable is not None:
        return unreadable
    right = [[v.verdict in _RIGHT for v in row] for row in table]
    if all(any(column) for column in zip(*right, strict=True)):
        complete = True
        for row, m in zip(right, motions, strict=True):
            own = [a for a, is_right in zip(alternatives, row, strict=True) if is_right]
            complete = complete and bool(own)
            complete = complete and check_equilibria(own, [m.equilibrium], reference).verdict is Verdict.EQUIVALENT
        return AnswerVerdict(Verdict.EQUIVALENT if complete else Verdict.INCOMPLETE)
    columns = [[row[n].verdict for row in table] for n, _ in enumerate(alternatives)]
    wrong = any(all(v is Verdict.WRONG for v in column) for column in columns)
    return AnswerVerdict(Verdict.WRONG if wrong else Verdict.UNDECIDED)
