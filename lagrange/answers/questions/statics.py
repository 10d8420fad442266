"""Equations of an answer about a system at rest: positions of equilibrium, and reactions there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lagrange.answers.equilibria import alternatives_of, check_equilibria
from lagrange.answers.questions.positions_in_numbers import compared_in_numbers
from lagrange.answers.reactions import AtRest
from lagrange.answers.readings import read_answer
from lagrange.answers.references import reference_of_solution
from lagrange.answers.verdicts import FIRST, AnswerVerdict, EquationVerdict, Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.mechanics.results import Solution


def check_statics(answer: Sequence[Fragment], solution: Solution) -> tuple[AnswerVerdict, bool, bool]:
    """The verdict on equations without motion; whether they are about equilibria, and about reactions there."""
    equilibria = [v.equilibrium for v in solution.views if v.equilibrium is not None]
    reference = reference_of_solution(solution)
    at_rest = reactions_at_rest(solution)
    readings = [(f, read_answer(f, reference.scope)) for f in answer] if at_rest else []
    about = [(f, r) for f, r in readings if at_rest and at_rest.mentions_reactions(r)]
    rest = [f for f in answer if all(f is not other for other, _ in about)]
    if not about or at_rest is None:
        verdict = check_equilibria(alternatives_of(answer), equilibria, reference)
        return compared_in_numbers(alternatives_of(answer), verdict, solution), True, False
    stated = tuple(at_rest.check(r) for _, r in about)
    together = _all_stated(stated)
    notes = tuple(n for _, r in about for n in r.notes)
    if not rest:
        return AnswerVerdict(together, stated, notes=notes), False, True
    positions = check_equilibria(alternatives_of(rest), equilibria, reference)
    both = next(
        (v for v in FIRST if v in (positions.verdict, together) and v is not Verdict.TRIVIAL), positions.verdict
    )
    equations, notes = (*positions.equations, *stated), (*positions.notes, *notes)
    return replace(positions, verdict=both, equations=equations, notes=notes), True, True


def _all_stated(stated: Sequence[EquationVerdict]) -> Verdict:
    """The verdict on several equations; identities count where there is nothing else."""
    verdicts = {v.verdict for v in stated}
    return next((v for v in (*FIRST[:-1], Verdict.EQUIVALENT) if v in verdicts), Verdict.TRIVIAL)


def reactions_at_rest(solution: Solution) -> AtRest | None:
    """The reactions at the equilibria; None if there are no constraints."""
    if solution.law is None or solution.own.reactions_at_rest is None:
        return None
    reactions = [v.reactions_at_rest for v in solution.views if v.reactions_at_rest]
    return AtRest(solution.law.newton, reactions, reference_of_solution(solution))
