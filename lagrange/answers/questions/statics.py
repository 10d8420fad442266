"""Equations of an answer about a system at rest: positions of equilibrium, and reactions there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.equilibria import alternatives_of, check_equilibria
from lagrange.answers.questions.positions_in_numbers import compared_in_numbers
from lagrange.answers.reactions import StatedReactionsAtRest
from lagrange.answers.readings import Reading, read_answer
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import FIRST, AnswerVerdict, EquationVerdict, Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.mechanics.results import Solution


def check_statics_answers(answer: Sequence[Fragment], solution: Solution) -> tuple[AnswerVerdict, bool, bool]:
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
    groups = _groups(answer, {id(f) for f, _ in about})
    of_force = {id(f): r for f, r in about}
    stated = tuple(
        at_rest.check(of_force[id(f)], _places(positions, reference)) for positions, forces in groups for f in forces
    )
    stated = _in_one_sense(stated, [r for _, r in about])
    together = _all_stated(stated)
    notes = tuple(n for _, r in about for n in r.notes)
    if not rest:
        return AnswerVerdict(together, stated, notes=notes), False, True
    listed = [a for positions, _ in groups if positions for a in alternatives_of(positions)]
    positions = check_equilibria(listed, equilibria, reference)
    both = next(
        (v for v in FIRST if v in (positions.verdict, together) and v is not Verdict.TRIVIAL), positions.verdict
    )
    equations, notes = (*positions.equations, *stated), (*positions.notes, *notes)
    return replace(positions, verdict=both, equations=equations, notes=notes), True, True


def _groups(answer: Sequence[Fragment], about: set[int]) -> list[tuple[list[Fragment], list[Fragment]]]:
    """The positions and the reactions there: a position after a reaction is another one, with its own reactions.

    about  the ids of the equations about reactions
    """
    groups: list[tuple[list[Fragment], list[Fragment]]] = [([], [])]
    for f in answer:
        if id(f) in about:
            groups[-1][1].append(f)
        elif groups[-1][0] and groups[-1][1]:
            groups.append(([f], []))
        else:
            groups[-1][0].append(f)
    return groups


def _places(positions: Sequence[Fragment], reference: Reference) -> list[list[sp.Expr]]:
    """The equations of each alternative among positions."""
    if not positions:
        return []
    readings = [[read_answer(f, reference.scope) for f in a] for a in alternatives_of(positions)]
    return [[e for r in a for e in r.components] for a in readings if not any(r.error for r in a)]


def _in_one_sense(stated: Sequence[EquationVerdict], readings: Sequence[Reading]) -> tuple[EquationVerdict, ...]:
    """The verdicts, in which a force that is right has the same sense wherever it is stated."""
    senses: dict[str, tuple[str, ...]] = {}
    judged = []
    for e, r in zip(stated, readings, strict=True):
        names = {s.name for c in r.components for s in c.free_symbols}
        for name in names if e.verdict is Verdict.EQUIVALENT else ():
            own = tuple(remark for remark in e.remarks if remark.startswith(f"`{name}`"))
            if senses.setdefault(name, own) != own:
                why = f"`{name}` has another sense here than in the answer before"
                e = EquationVerdict(e.text, Verdict.WRONG, why)
        judged.append(e)
    return tuple(judged)


def _all_stated(stated: Sequence[EquationVerdict]) -> Verdict:
    """The verdict on several equations; identities count where there is nothing else."""
    verdicts = {v.verdict for v in stated}
    return next((v for v in (*FIRST[:-1], Verdict.EQUIVALENT) if v in verdicts), Verdict.TRIVIAL)


def reactions_at_rest(solution: Solution) -> StatedReactionsAtRest | None:
    """The reactions at the equilibria; None if there are no constraints."""
    if solution.law is None or solution.own.reactions_at_rest is None:
        return None
    reactions = [v.reactions_at_rest for v in solution.views if v.reactions_at_rest]
    return StatedReactionsAtRest(solution.law.newton, reactions, reference_of_solution(solution))
