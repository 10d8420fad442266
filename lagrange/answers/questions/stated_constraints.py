"""Answers about the constraints: the number of degrees of freedom, the classification, and the constraints themselves.

A problem that asks for its constraints alone may be answered by equations between coordinates, velocities, or
displacements. Such an equation is right if it holds in every state, or for every displacement, that the constraints
admit. Each gives a row of coefficients of displacements: A δq = 0. The answer is complete if the rows bind as many
displacements as the constraints do. A relation f = const, and one with dq or dt, is compared by its rate.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, Point
from lagrange.answers.readings import GivenEquation, displaced_coordinates, without_displacements
from lagrange.answers.verdicts import (
    DIVIDES_BY_ZERO,
    MIXED_CHOICES,
    UNDECIDED,
    AnswerVerdict,
    EquationVerdict,
    Verdict,
)
from lagrange.answers.written.in_words import is_about_freedom
from lagrange.core.symbols import CONSTANT, base, differential, prime, symbols_in, variation
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import Standing, System, agreed_in_motion, compare
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Answers

if TYPE_CHECKING:
    from lagrange.answers.written.working import Working

_NOT_REQUIRED = "the constraints do not require it"
_IDENTITY = "it is an identity"
_ORDER = (Verdict.WRONG, Verdict.UNREADABLE, Verdict.UNDECIDED)


def about_constraints(solution: Solution | None) -> bool:
    """Whether a problem asks for its constraints alone."""
    if solution is None or solution.impact is not None or solution.own.motion is not None:
        return False
    return all(v.equilibrium is None and v.at_rest is None and v.impending is None for v in solution.views)


def on_freedom_and_class(solution: Solution, answers: Answers) -> Iterator[AnswerVerdict]:
    """The verdicts on the degrees of freedom, the classification, and what is integrable."""
    classification = solution.classification
    if answers.degrees_of_freedom is not None:
        agrees = answers.degrees_of_freedom == classification.degrees_of_freedom
        why = ""
        if not agrees:
            from lagrange.answers.models.letters import explained_degrees_of_freedom

            why = explained_degrees_of_freedom(answers.degrees_of_freedom, classification)
        yield AnswerVerdict(_agrees(agrees), name="degrees_of_freedom", diagnosis=why)
    if answers.classification:
        yield _together("classification", {word: _class(solution, word) for word in answers.classification})
    if answers.integrable:
        derived = {c.constraint.name: c.integrable for c in classification.constraints}
        agree = {n: None if derived.get(n) is None else derived[n] == s for n, s in answers.integrable.items()}
        yield _together("integrable", agree)


def _together(name: str, parts: Mapping[str, bool | None]) -> AnswerVerdict:
    """The verdict on several statements, naming those that are not right."""
    verdict = _agrees(False if False in parts.values() else None if None in parts.values() else True)
    named = [n for n, agrees in parts.items() if agrees is (False if verdict is Verdict.WRONG else None)]
    heading = "undecided" if verdict is Verdict.UNDECIDED else "not right"
    diagnosis = f"{heading}: {', '.join(named)}" if len(parts) > 1 and named else ""
    return AnswerVerdict(verdict, name=name, diagnosis=diagnosis)


def _agrees(same: bool | None) -> Verdict:
    return Verdict.UNDECIDED if same is None else Verdict.EQUIVALENT if same else Verdict.WRONG


def _class(solution: Solution, word: str) -> bool | None:
    """Whether the system belongs to a class; None if that is undecided."""
    c = solution.classification
    positive = {"holonomic": c.holonomic, "scleronomic": c.scleronomic, "catastatic": c.catastatic}
    negative = {"nonholonomic": c.holonomic, "rheonomic": c.scleronomic, "acatastatic": c.catastatic}
    if word in positive:
        return positive[word]
    value = negative[word]
    return None if value is None else not value


def check_constraints(working: Working, solution: Solution) -> AnswerVerdict:
    """The verdict on equations that state constraints, between coordinates, velocities or displacements."""
    judged: list[EquationVerdict] = []
    stated: list[sp.Expr] = []
    for fragment in working.judged:
        if not isinstance(fragment, GivenEquation):
            continue
        reading = fragment.reading
        try:
            verdict, why = _judged(reading.components, solution)
        except DivisionByZeroError:
            verdict, why = Verdict.UNREADABLE, DIVIDES_BY_ZERO
        judged.append(EquationVerdict.of(reading.text, verdict, why))
        stated += reading.components if verdict is Verdict.EQUIVALENT else ()
    unreadable = [f for f in working.unreadable if f.reading.error and not is_about_freedom(f)]
    errors = tuple(d for f in unreadable if f.reading.error for d in f.reading.error.diagnostics)
    verdicts = {e.verdict for e in judged}
    whole = next((v for v in _ORDER if v in verdicts), Verdict.EQUIVALENT if stated else Verdict.TRIVIAL)
    missing = _missing(stated, solution) if whole is Verdict.EQUIVALENT else 0
    if missing:
        whole = Verdict.INCOMPLETE
    if unreadable and whole in (Verdict.INCOMPLETE, Verdict.TRIVIAL):
        whole = Verdict.UNREADABLE
    judged += [
        EquationVerdict(f.reading.text, Verdict.UNREADABLE, f.reading.error.diagnostics[0].message)
        for f in unreadable
        if f.reading.error
    ]
    diagnosis = "" if not missing else f"{missing} independent equation{'s are' if missing > 1 else ' is'} missing"
    return AnswerVerdict(whole, tuple(judged), missing, unreadable=errors, notes=working.notes, diagnosis=diagnosis)


def _judged(components: Sequence[sp.Expr], solution: Solution) -> tuple[Verdict, str]:
    """The verdict on one statement, with a diagnosis or a remark."""
    if all(e == 0 for e in components):
        return Verdict.TRIVIAL, _IDENTITY
    view = _view(components, solution)
    if view is None:
        return Verdict.UNREADABLE, MIXED_CHOICES
    configuration = view.configuration
    conditions = [c for e in components for c in _conditions(e, configuration)]
    result = compare(conditions, System(configuration, ()))
    if result is None:
        return Verdict.UNDECIDED, UNDECIDED
    right = all(s is Standing.CONSTRAINT for s in result.standings)
    return (Verdict.EQUIVALENT, "") if right else (Verdict.WRONG, _NOT_REQUIRED)


def _conditions(e: sp.Expr, configuration: Configuration) -> Sequence[sp.Expr]:
    """What a statement says of states: without displacements, and f = const by its rate."""
    e = configuration.rewritten(e)
    if CONSTANT in e.free_symbols:
        return (configuration.slots.time_derivative(e.xreplace({CONSTANT: sp.S.Zero})),)
    return without_displacements(e, configuration)


def _view(components: Sequence[sp.Expr], solution: Solution) -> InCoordinates | None:
    """The coordinates in which a statement is: the file's own, or those of a choice, with which it may be mixed."""
    moving = {q for v in solution.views for q in v.configuration.slots.coordinates}
    used = {base(s) for e in components for s in symbols_in(e)} & moving
    used |= displaced_coordinates(components, tuple(moving))
    for view in solution.views:
        if used <= {*view.configuration.slots.coordinates, *view.configuration.expressed}:
            return view
    return None


def _missing(components: Sequence[sp.Expr], solution: Solution) -> int:
    """How many independent equations are missing between the displacements of the coordinates that occur."""
    view = _view(components, solution)
    if view is None:
        return 0
    configuration = view.configuration
    slots = configuration.slots
    own = {*solution.own.configuration.slots.coordinates}
    used = {base(s) for e in components for s in symbols_in(e)} & {*slots.coordinates, *configuration.expressed}
    used |= displaced_coordinates(components, (*slots.coordinates, *configuration.expressed))
    columns = [*slots.coordinates]
    if used & own - {*columns}:
        columns += [q for q in configuration.expressed if q not in columns]
    rows = [[configuration.rewritten(c) for c in _coefficients(e, columns)] for e in components]

    def at(point: Point) -> int:
        return point.rank(point.matrix(rows))

    rank = agreed_in_motion(configuration, at, [c for row in rows for c in row])
    free = len(view.elimination.independent)
    return 0 if rank is None else max(0, len(columns) - free - rank)


def _coefficients(e: sp.Expr, columns: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """The coefficients of the displacements in what a statement says of them."""
    used = symbols_in(e)
    for kind in (variation, differential, prime):
        if any(kind(q) in used for q in columns):
            return [e.diff(kind(q)) for q in columns]
    return [e.diff(q) for q in columns]
