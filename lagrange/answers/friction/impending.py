"""The equilibria of an answer with friction at its limit: each alternative belongs to a direction of slip.

An answer is right if each of its alternatives is an equilibrium for some direction, and complete if it has all of them
for every direction.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.answers.equilibria import check_equilibria
from lagrange.answers.friction.forces_at_limit import ForcesPutIn, forces_put_in, names_of_forces
from lagrange.answers.readings import GivenEquation, read_answer
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.document.math_writer import text
from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
from lagrange.mechanics.results import Solution

_RIGHT = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)


def check_impending_answers(
    alternatives: Sequence[Sequence[Fragment]],
    motions: Sequence[ImpendingMotion],
    reference: Reference,
    solution: Solution,
) -> AnswerVerdict:
    """The verdict in one set of coordinates; `motions` has each direction of slip."""
    newton = solution.law.newton if solution.law is not None else None
    put_in = [[forces_put_in(a, m, newton, reference) for a in alternatives] for m in motions]
    own = [[_positions(p, m, reference) for p in row] for row, m in zip(put_in, motions, strict=True)]
    table = [
        [_judged(p, a, m, reference) for p, a in zip(row, stated, strict=True)]
        for row, stated, m in zip(put_in, own, motions, strict=True)
    ]
    unreadable = next((v for row in table for v in row if v.verdict is Verdict.UNREADABLE), None)
    if unreadable is not None:
        return unreadable
    right = [
        [v.verdict in _RIGHT and not _foreign(p.positions, m, reference) for v, p in zip(row, stated, strict=True)]
        for row, stated, m in zip(table, put_in, motions, strict=True)
    ]
    if all(any(column) for column in zip(*right, strict=True)):
        complete = True
        for row, stated, m in zip(right, own, motions, strict=True):
            kept = [a for a, is_right in zip(stated, row, strict=True) if is_right]
            kept = [a for a in kept if a]
            complete = complete and bool(kept)
            complete = complete and check_equilibria(kept, [m.equilibrium], reference).verdict is Verdict.EQUIVALENT
        return AnswerVerdict(Verdict.EQUIVALENT if complete else Verdict.INCOMPLETE)
    columns = [[row[n].verdict for row in table] for n, _ in enumerate(alternatives)]
    by_motion = [[(row[n], m) for row, m in zip(put_in, motions, strict=True)] for n, _ in enumerate(alternatives)]
    wrong = [
        a
        for a, column, stated in zip(alternatives, columns, by_motion, strict=True)
        if all(v is Verdict.WRONG for v in column) or any(_foreign(p.positions, m, reference) for p, m in stated)
    ]
    if not wrong:
        return AnswerVerdict(Verdict.UNDECIDED)
    return AnswerVerdict(Verdict.WRONG, diagnosis=_explained(wrong, motions, reference, solution))


def _positions(forces: ForcesPutIn, motion: ImpendingMotion, reference: Reference) -> list[Fragment]:
    """The equations of one alternative about positions; those about forces where they are right together with these."""
    stated = [*forces.positions, *forces.balance]
    if not stated:
        return []
    if forces.balance:
        verdict = check_equilibria([stated], [motion.equilibrium], reference).verdict
        if verdict is Verdict.WRONG:  # they hold at the equilibrium, and elsewhere
            stated = [*forces.positions]
    place = [Fragment.of(f"{q} = {text(v)}") for q, v in motion.held.items()]
    return [*stated, *place, *_forces_beside(stated, motion)] if stated else []


def _judged(
    forces: ForcesPutIn, stated: Sequence[Fragment], motion: ImpendingMotion, reference: Reference
) -> AnswerVerdict:
    """The verdict on one alternative for one direction of slip; without positions it is incomplete."""
    if forces.holds is False:
        return AnswerVerdict(Verdict.WRONG)
    verdict = (
        check_equilibria([stated], [motion.equilibrium], reference) if stated else AnswerVerdict(Verdict.INCOMPLETE)
    )
    if forces.holds is None and verdict.verdict in _RIGHT:
        return AnswerVerdict(Verdict.UNDECIDED)
    return verdict


def _explained(
    wrong: Sequence[Sequence[Fragment]],
    motions: Sequence[ImpendingMotion],
    reference: Reference,
    solution: Solution,
) -> str:
    """What wrong limits are instead, in a sentence; empty if that is not found."""
    from lagrange.answers.results.conditions import StatedCondition, explained_limits
    from lagrange.answers.results.contacts import explained_by_contacts

    stated = [
        StatedCondition(f.text, c, True)
        for a in wrong
        for f in a
        for c in read_answer(f, reference.scope).components
        if isinstance(c, sp.Expr)
    ]
    relations = [r for m in motions for b in m.equilibrium.branches for r in b.relations]
    coefficients = {c.coefficient for m in motions for c in m.contacts}
    derived = [r.lhs - r.rhs for r in relations]
    reason = explained_limits(stated, derived, coefficients)
    if not reason and len(stated) > 1:  # the two limits of a range, each with the same mistake
        each = [explained_limits([s], derived, coefficients) for s in stated]
        reason = "; ".join(dict.fromkeys(f"`{s.text}`: {why}" for s, why in zip(stated, each, strict=True) if why))
    return reason or explained_by_contacts(stated, solution)


def _foreign(alternative: Sequence[Fragment], motion: ImpendingMotion, reference: Reference) -> bool:
    """Whether an answer contains a parameter on which nothing depends here, the kinetic friction for the static one."""
    stated = {s for f in alternative for e in read_answer(f, reference.scope).components for s in e.free_symbols}
    equilibrium = motion.equilibrium
    used = {s for e in equilibrium.expressions for s in e.free_symbols} | {
        s for b in equilibrium.branches for s in _symbols(b)
    }
    return not stated & {*reference.parameters.values()} <= used


def one_a_line(judged: Sequence[Fragment], solution: Solution) -> list[tuple[Fragment, ...]]:
    """The equations about positions as alternatives, each with all that are about forces."""
    motions = [m for v in solution.views for m in v.impending or ()]
    newton = solution.law.newton if solution.law is not None else None
    names = set().union(*(names_of_forces(m, newton) for m in motions))
    scope = reference_of_solution(solution).scope
    about = [f for f in judged if any(e.free_symbols & names for e in read_answer(f, scope).components)]
    return [(*about, f) for f in judged if all(f is not other for other in about)]


def _forces_beside(alternative: Sequence[Fragment], motion: ImpendingMotion) -> list[Fragment]:
    """T = m g for an unknown force that an answer does not mention: it may state the limit alone."""
    words = {w for f in alternative for w in re.findall(r"[^\W\d]\w*", f.text)}
    # P_min is another name of P
    words |= {s.name for f in alternative if isinstance(f, GivenEquation) for e in f.reading.components for s in _of(e)}
    equilibrium = motion.equilibrium
    if len(equilibrium.branches) != 1 or not (words & {s.name for b in equilibrium.branches for s in _symbols(b)}):
        return []
    relations = [
        r for r in equilibrium.branches[0].relations if r.lhs in equilibrium.forces and r.lhs.name not in words
    ]
    return [Fragment.of(f"{text(r.lhs)} = {text(r.rhs)}") for r in relations]


def _of(e: sp.Expr) -> set[sp.Symbol]:
    return {s for s in e.free_symbols if isinstance(s, sp.Symbol)}


def _symbols(b: Branch) -> set[sp.Symbol]:
    return set().union(*(r.lhs.free_symbols | r.rhs.free_symbols for r in b.relations))
