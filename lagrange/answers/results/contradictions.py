"""Contradictions in an answer about equilibrium: two equations of a system that hold together in special cases only.

    P = W/2 tan φ,  P = W/2 cot φ        -W l sin θ + c b² sin θ cos θ = 0,  cos θ = c b²/(W l)

The system has solutions, all of them equilibria, if φ or the parameters are such that both hold. But one equation says
by itself what is asked for, and the other is true at none of the equilibria: it is wrong, and not a special case.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.equilibrium_comparison import NOWHERE
from lagrange.answers.readings import Reading
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict

_RIGHT = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)

Judge = Callable[[Sequence[Sequence[Reading]]], AnswerVerdict | None]
"""The verdict on alternative systems; None if they cannot be compared."""


def with_contradictions(verdict: AnswerVerdict, readings: Sequence[Sequence[Reading]], judge: Judge) -> AnswerVerdict:
    """The verdict on alternative systems, in which equations that contradict the rest of their system are wrong."""
    flat = [(a, n) for a in readings for n in range(len(a))]
    if verdict.verdict is not Verdict.INCOMPLETE or len(flat) != len(verdict.equations):
        return verdict
    equations = [
        EquationVerdict.of(e.text, Verdict.WRONG, NOWHERE) if _contradicts(a, n, judge) else e
        for e, (a, n) in zip(verdict.equations, flat, strict=True)
    ]
    if all(e.verdict is not Verdict.WRONG for e in equations):
        return verdict
    return replace(verdict, verdict=Verdict.WRONG, equations=tuple(equations), missing=0)


def _contradicts(system: Sequence[Reading], n: int, judge: Judge) -> bool:
    """Whether an equation is true at no equilibrium, although the others of its system describe equilibria."""
    own, others = (_symbols(part) for part in (system[n : n + 1], [*system[:n], *system[n + 1 :]]))
    if own.isdisjoint(others):  # y = 0 beside x = 0, where any y will do: it is one of many positions
        return False
    alone, rest = judge([[system[n]]]), judge([[*system[:n], *system[n + 1 :]]])
    if alone is None or rest is None or rest.verdict not in _RIGHT:
        return False
    return alone.verdict is Verdict.WRONG and all(e.diagnosis.startswith(NOWHERE) for e in alone.equations)


def _symbols(readings: Sequence[Reading]) -> set[sp.Basic]:
    return {s for r in readings for e in r.components for s in e.free_symbols}
