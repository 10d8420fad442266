"""Equations for the instant of release: m y'' = T − m g for a rod that hangs level on a vertical string.

Where the questions of a problem are about its initial state, working may be written for that state alone, with the
angles and rates substituted. Such equations do not follow from the equations of motion. They are judged at the initial
state, where accelerations and reactions have definite values.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero, rank
from lagrange.algebra.fourier.linear_systems import solved_linear, tidy_quotient
from lagrange.answers.limits import MOST_AT_RELEASE
from lagrange.answers.readings import read_answer
from lagrange.answers.references import Reference, ReferenceCandidate
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.symbols import base, prime, t
from lagrange.mechanics.questions.states import MotionView, initial_state
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Question

AT_START = "it holds at the initial state, about which the questions are"
_RESTATED = "it restates the initial state"
_OPEN = "it holds at the initial state, but does not follow from the equations of motion"
_NOT_EVEN_THERE = "it does not follow from the equations of motion, and does not hold at the initial state"


def at_release(
    equations: Sequence[Fragment], verdict: AnswerVerdict, solution: Solution, reference: Reference
) -> AnswerVerdict:
    """The verdict on equations of motion, wrong ones judged at the initial state if the questions are about that.

    Without coordinates and velocities an equation that holds there is right. With coordinates it may be meant for all
    of the motion, and is undecided, or wrong where other questions need the motion; with velocities it is meant so.
    Equations are complete if all that is asked for at the initial state follows.
    """
    questions = [a.question for a in solution.asked]
    at_start = [q for q in questions if any(c.function in (t, -t) for c in q.when)]
    if verdict.verdict is not Verdict.WRONG or not at_start or len(verdict.equations) != len(equations):
        return verdict
    components = [read_answer(f, reference.scope).components for f in equations]
    used = {s.name for es in components for e in es for s in e.free_symbols}
    best = verdict
    starts: dict[str, Mapping[sp.Symbol, sp.Expr] | None] = {}
    for candidate in reference.candidates_for(used):
        if candidate.choice not in starts:
            starts[candidate.choice] = _start(candidate, solution)
        start = starts[candidate.choice]
        if start is None:
            continue
        judged = _judged(
            components,
            verdict,
            candidate,
            start,
            reference,
            questions=at_start,
            all_there=len(at_start) == len(questions),
        )
        if judged.verdict is not Verdict.WRONG:
            return judged
        best = judged if best is verdict else best
    return best


def _start(candidate: ReferenceCandidate, solution: Solution) -> Mapping[sp.Symbol, sp.Expr] | None:
    """All coordinates, velocities, accelerations and reactions at t = 0; None if they are not all known."""
    view = next((v for v in solution.views if v.name == candidate.choice), None)
    if view is None or view.dynamics is None or view.conserved is None or solution.law is None:
        return None
    place = MotionView(view.dynamics, view.conserved, solution.law)
    try:
        state = {t: sp.S.Zero, **initial_state(place, solution.problem, [v.configuration for v in solution.views])}
    except ProblemError:
        return None
    system, slots = candidate.system, candidate.configuration.slots
    unknowns = (*slots.accelerations, *system.multipliers)
    if not {*slots.coordinates, *slots.velocities} <= state.keys() or len(unknowns) > MOST_AT_RELEASE:
        return None
    state = {s: e.xreplace(dict(candidate.values)) for s, e in state.items()}
    known = [e.xreplace(state) for e in (*system.equations, *system.accelerated_constraints)]
    if len(known) != len(unknowns):
        return None
    rows = [[e.diff(u) for u in unknowns] for e in known]
    right = [-e.xreplace(dict.fromkeys(unknowns, sp.S.Zero)) for e in known]
    try:
        solved = solved_linear(rows, right, candidate.configuration.surface, tidy_quotient)
    except DivisionByZeroError:
        return None
    if solved is None or None in solved:
        return None
    return {**state, **{u: v for u, v in zip(unknowns, solved, strict=True) if v is not None}}


def _judged(
    components: Sequence[Sequence[sp.Expr]],
    verdict: AnswerVerdict,
    candidate: ReferenceCandidate,
    start: Mapping[sp.Symbol, sp.Expr],
    reference: Reference,
    *,
    questions: Sequence[Question],
    all_there: bool,
) -> AnswerVerdict:
    """The verdict with one meaning of the names of forces."""
    coordinates = {*reference.scope.slots.coordinates}
    slots = candidate.configuration.slots
    of_state = {t, *slots.coordinates, *slots.velocities}
    state = {s: v for s, v in start.items() if s in of_state}
    unknowns = [s for s in start if s not in state]
    parts = []
    read = [[as_written(candidate.read(e)) for e in es] for es in components]
    for part, es, meant in zip(verdict.equations, components, read, strict=True):
        used = {s for e in es for s in e.free_symbols if base(s) in coordinates}
        of_motion = any(e.free_symbols & {*unknowns} for e in meant)
        if of_motion and any(s == prime(base(s)) for s in used):
            parts.append(part)
            continue
        try:
            holds = [is_zero(e.xreplace(dict(start))) for e in meant]
        except DivisionByZeroError:
            holds = [None]
        if part.verdict is not Verdict.WRONG:
            parts.append(part)
        elif not all(holds):
            kind = Verdict.WRONG if False in holds else Verdict.UNDECIDED
            parts.append(
                replace(part, verdict=kind, diagnosis=part.diagnosis if used & coordinates else _NOT_EVEN_THERE)
            )
        elif not of_motion:
            parts.append(_right(part, _RESTATED))
        elif used & coordinates and not all_there:  # other questions need it for all of the motion
            parts.append(part)
        elif used & coordinates or not all_there:
            parts.append(replace(part, verdict=Verdict.UNDECIDED, diagnosis=_OPEN, hints=(), cause=""))
        else:
            parts.append(_right(part, AT_START))
    stated = {p.verdict for p in parts}
    if stated & {Verdict.WRONG, Verdict.UNDECIDED}:
        worst = Verdict.WRONG if Verdict.WRONG in stated else Verdict.UNDECIDED
        return replace(verdict, verdict=worst, equations=tuple(parts), missing=0)
    rows = [[e.xreplace(state).diff(u) for u in unknowns] for es in read for e in es]
    asked = [candidate.read(q.quantity).xreplace(state) for q in questions]
    wanted = [[e.diff(u) for u in unknowns] for e in asked]
    missing = (rank([*rows, *wanted]) or 0) - (rank(rows) or 0)
    worst = Verdict.INCOMPLETE if missing else Verdict.EQUIVALENT
    return replace(verdict, verdict=worst, equations=tuple(parts), missing=missing)


def _right(part: EquationVerdict, remark: str) -> EquationVerdict:
    return replace(part, verdict=Verdict.EQUIVALENT, diagnosis="", hints=(), cause="", remarks=(remark,))


def is_about_release(verdict: AnswerVerdict) -> bool:
    """Whether equations are right at the initial state, to which the questions refer."""
    good = verdict.verdict in (Verdict.EQUIVALENT, Verdict.INCOMPLETE)
    return good and any(AT_START in e.remarks for e in verdict.equations)
