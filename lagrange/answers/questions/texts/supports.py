"""The forces of two smooth supports of a rod, N_A and N_B, as the page calls them, among the lines of an answer.

No constraint of the file has them; they are right if they hold at every equilibrium:  R_1 n_1 + R_2 n_2 + Σ F = 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.questions.named_values import worst
from lagrange.answers.readings import GivenEquation
from lagrange.answers.references import reference_of_solution
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, UNDECIDED, AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written
from lagrange.answers.written.working import understood
from lagrange.core.diagnostics import Fragment
from lagrange.mechanics.equilibrium.stability import on_branch
from lagrange.mechanics.results import Solution
from lagrange.mechanics.supports import supports

_WRONG = "it does not hold at every equilibrium"


def supports_of(answer: Sequence[Fragment], solution: Solution) -> tuple[AnswerVerdict, list[Fragment]] | None:
    """The verdict on the lines with forces of supports, and the other lines; None if there are none."""
    if not any("N" in f.text for f in answer):
        return None
    derived = supports(solution)
    if derived is None:
        return None
    reference = reference_of_solution(solution)
    names = {f"N_{s.point}": s.size for s in derived.at if f"N_{s.point}" not in reference.scope.names()}
    forces = {sp.Symbol(n, real=True): size for n, size in names.items()}
    scope = replace(reference.scope, scalars={**reference.scope.scalars, **{s.name: s for s in forces}})
    wider = replace(reference, scope=scope, declared=reference.declared | names.keys())
    working = understood(answer, wider, moving=False)
    parts: list[EquationVerdict] = []
    rest: list[Fragment] = []
    for f in working.written:
        about = isinstance(f, GivenEquation) and any(e.free_symbols & forces.keys() for e in f.reading.components)
        if about and isinstance(f, GivenEquation):
            parts.append(_judged(f, forces, solution))
        elif f in working.judged:
            rest.append(f)
        else:
            rest += [g for g in answer if g.whole == f.whole][:1]
    if not parts:
        return None
    return AnswerVerdict(worst(parts), tuple(parts), notes=working.notes, name="reactions"), rest


def _judged(line: GivenEquation, forces: dict[sp.Symbol, sp.Expr], solution: Solution) -> EquationVerdict:
    """The verdict on one line: whether it holds at every equilibrium."""
    text = line.reading.text
    chosen = solution.chosen
    rest = chosen.equilibrium
    assert rest is not None
    holds: set[bool | None] = set()
    try:
        for e in line.reading.components:
            stated = chosen.configuration.rewritten(as_written(e).xreplace(forces))
            for b in rest.branches:
                value = on_branch(b, stated, rest)
                holds.add(None if value is None else is_zero(value))
    except DivisionByZeroError:
        return EquationVerdict.of(text, Verdict.UNREADABLE, DIVIDES_BY_ZERO)
    if False in holds:
        return EquationVerdict.of(text, Verdict.WRONG, _WRONG)
    if None in holds or not holds:
        return EquationVerdict.of(text, Verdict.UNDECIDED, UNDECIDED)
    return EquationVerdict.of(text, Verdict.EQUIVALENT, "")
