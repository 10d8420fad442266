"""Somebody else's equilibria with friction at its limit: each alternative belongs to a direction of slip.

An answer is right if each of its alternatives is an equilibrium for some direction, and complete if it has all of them
for every direction.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.answers.equilibria import check_equilibria
from lagrange.answers.readings import GivenEquation, read_answer
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.document.math_writer import text
from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
from lagrange.mechanics.results import Solution

_RIGHT = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)


def check_impending(
    alternatives: Sequence[Sequence[Fragment]],
    motions: Sequence[ImpendingMotion],
    reference: Reference,
    solution: Solution,
) -> AnswerVerdict:
    """The verdict in one set of coordinates; `motions` has each direction of slip."""
    own = [[[*a, *_forces_beside(a, m)] for a in alternatives] for m in motions]
    table = [
        [check_equilibria([a], [m.equilibrium], reference) for a in row] for row, m in zip(own, motions, strict=True)
    ]
    unreadable = next((v for row in table for v in row if v.verdict is Verdict.UNREADABLE), None)
    if unreadable is not None:
        return unreadable
    right = [
        [v.verdict in _RIGHT and not _foreign(a, m, reference) for v, a in zip(row, alternatives, strict=True)]
        for row, m in zip(table, motions, strict=True)
    ]
    if all(any(column) for column in zip(*right, strict=True)):
        complete = True
        for row, stated, m in zip(right, own, motions, strict=True):
            kept = [a for a, is_right in zip(stated, row, strict=True) if is_right]
            complete = complete and bool(kept)
            complete = complete and check_equilibria(kept, [m.equilibrium], reference).verdict is Verdict.EQUIVALENT
        return AnswerVerdict(Verdict.EQUIVALENT if complete else Verdict.INCOMPLETE)
    columns = [[row[n].verdict for row in table] for n, _ in enumerate(alternatives)]
    wrong = [
        a
        for a, column in zip(alternatives, columns, strict=True)
        if all(v is Verdict.WRONG for v in column) or any(_foreign(a, m, reference) for m in motions)
    ]
    if not wrong:
        return AnswerVerdict(Verdict.UNDECIDED)
    return AnswerVerdict(Verdict.WRONG, diagnosis=_explained(wrong, motions, reference, solution))


def _explained(
    wrong: Sequence[Sequence[Fragment]],
    motions: Sequence[ImpendingMotion],
    reference: Reference,
    solution: Solution,
) -> str:
    """What wrong limits are instead, in a sentence; empty if that is not found."""
    from lagrange.answers.results.conditions import Stated, explained_limits
    from lagrange.answers.results.contacts import explained_by_contacts

    stated = [
        Stated(f.text, c, True)
        for a in wrong
        for f in a
        for c in read_answer(f, reference.scope).components
        if isinstance(c, sp.Expr)
    ]
    relations = [r for m in motions for b in m.equilibrium.branches for r in b.relations]
    coefficients = {c.coefficient for m in motions for c in m.contacts}
    found = explained_limits(stated, [r.lhs - r.rhs for r in relations], coefficients)
    return found or explained_by_contacts(stated, solution)


def _foreign(alternative: Sequence[Fragment], motion: ImpendingMotion, reference: Reference) -> bool:
    """Whether an answer contains a parameter on which nothing depends here, the kinetic friction for the static one."""
    stated = {s for f in alternative for e in read_answer(f, reference.scope).components for s in e.free_symbols}
    found = motion.equilibrium
    used = {s for e in found.expressions for s in e.free_symbols} | {s for b in found.branches for s in _symbols(b)}
    return not stated & {*reference.parameters.values()} <= used


def with_reactions_put_in(judged: Sequence[Fragment], solution: Solution) -> tuple[Fragment, ...]:
    """The equations with N_A = ... put into the others, where these then state something without reactions."""
    reactions = solution.law.newton.reactions if solution.law is not None else ()
    names = {s for r in reactions for s in (r.multiplier, r.given, r.symbol) if s is not None}
    rule: dict[sp.Symbol, sp.Expr] = {}
    kept: list[GivenEquation] = []
    for f in judged:
        if not isinstance(f, GivenEquation):
            return tuple(judged)
        sides = f.reading.sides
        pairs = [(a, b) for a, b in (sides, sides[::-1])] if len(sides) == 2 else []
        named = next(((a, b) for a, b in pairs if a in names and a not in rule and isinstance(b, sp.Expr)), None)
        if named and not named[1].xreplace(rule).free_symbols & names:
            rule[named[0]] = named[1].xreplace(rule)
        else:
            kept.append(f)
    if not rule or not kept:
        return tuple(judged)
    return tuple(
        replace(
            f, reading=replace(f.reading, components=tuple(e.xreplace(rule) for e in f.reading.components), sides=())
        )
        for f in kept
    )


def _forces_beside(alternative: Sequence[Fragment], motion: ImpendingMotion) -> list[Fragment]:
    """T = m g for an unknown force that an answer does not mention: it may state the limit alone."""
    words = {w for f in alternative for w in re.findall(r"[^\W\d]\w*", f.text)}
    found = motion.equilibrium
    if len(found.branches) != 1 or not (words & {s.name for b in found.branches for s in _symbols(b)}):
        return []
    relations = [r for r in found.branches[0].relations if r.lhs in found.forces and r.lhs.name not in words]
    return [Fragment.of(f"{text(r.lhs)} = {text(r.rhs)}") for r in relations]


def _symbols(b: Branch) -> set[sp.Symbol]:
    return set().union(*(r.lhs.free_symbols | r.rhs.free_symbols for r in b.relations))
