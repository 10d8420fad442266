"""Lines beside the answers to questions: the working that leads to them, and values under names of their own.

A line that cannot be read only because it contains the label of an answer, `m v^2/2 = m g h` before `v = ...`, is
working; so is one without accelerations and forces, an energy or a relation of kinematics. A value under a name that
nobody declared, which answers none of the questions though it has the dimension of one, is a wrong answer.
"""

from __future__ import annotations

from collections.abc import Sequence

from lagrange.answers.questions.texts.labels import label_of
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.judging import is_of_motion
from lagrange.answers.written.reading import read_as_written, tried
from lagrange.answers.written.statements import statement
from lagrange.answers.written.unread import undeclared
from lagrange.answers.written.working import Working
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.symbols import base
from lagrange.core.units import NO_DIMENSION
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import read_value
from lagrange.mechanics.results import Solution
from lagrange.values.dimensions import dimension, dimensions_of_units

_SPEEDS = {"v", "V", "u"}
_UNANSWERED = "it answers none of the questions"


def working_beside(rest: Sequence[Fragment], answer: Sequence[Fragment], reference: Reference) -> list[Fragment]:
    """The lines that cannot be read only because of names that other lines state, or of v, the speed at some place."""
    labels = {name for f in answer if (name := label_of(f))} | _SPEEDS
    values = []
    for f in rest:
        names = {*undeclared(read_as_written(f, reference.scope_of_answers), f.text)}
        if names and names <= labels:
            values.append(f)
    return values


def only_beside(working: Working, reference: Reference) -> bool:
    """Whether what could be read is about the motion in none of its lines: energies, relations of kinematics."""
    return not any(is_of_motion(f, reference) for f in working.judged)


def not_judged(lines: Sequence[Fragment], why: str) -> tuple[Diagnostic, ...]:
    """A note on each line."""
    return tuple(Diagnostic("not-judged", f"`{f.text.strip()}` {why}", f.whole).as_note() for f in lines)


def under_another_name(answer: Sequence[Fragment], solution: Solution) -> AnswerVerdict | None:
    """The verdict on values of parameters alone, none of which answers a question; None if there is anything else."""
    reference = reference_of_solution(solution)
    known = dimensions_of_units(reference.units)
    if known:  # what has no unit where others have one is a number
        known |= {s: NO_DIMENSION for s in reference.parameters.values() if s not in known}
    derived = [v for a in solution.asked for b in a.branches for v in b.values]
    expected = {d for v in derived if (d := dimension(v, known)) is not None}
    parts = []
    for f in answer:
        try:
            stated = statement(f, reference.scope)
            if not stated.label or len(stated.sides) != 1 or label_of(f) in reference.declared:
                return None
            value = tried(stated.sides[0], stated.scope, lambda g, s=stated.scope: read_value(g, s, [], latex=True))  # type: ignore[misc]
        except ProblemError:
            return None
        if isinstance(value, Vector) or not value.free_symbols <= {*reference.parameters.values()}:
            return None
        if any(base(s) != s for s in value.free_symbols) or dimension(value, known) not in expected:
            return None
        parts.append(EquationVerdict(f.text.strip(), Verdict.WRONG, _UNANSWERED))
    return AnswerVerdict(Verdict.WRONG, tuple(parts), name="ask") if parts else None
