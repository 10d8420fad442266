"""Somebody else's equations of motion: are they right?

An answer is read with the names of the problem only, and compared as a system: by its solutions, not by its form. It
may use the file's coordinates and those of one choice together; coordinates that a choice replaces are rewritten
through its substitution. It is tried against the file's own system and every choice, and the best verdict counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

import sympy as sp

from lagrange.comparison import Comparison, Standing, System, compare
from lagrange.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.exact import DivisionByZeroError, is_zero
from lagrange.latex_layout import separated
from lagrange.notation import CONSTANT, Slots, base
from lagrange.references import Candidate, Reading, Reference, read_answer

MAX_EQUATIONS = 12


class Verdict(StrEnum):
    """What is said of an answer, or of one of its equations."""

    UNREADABLE = "unreadable"
    WRONG = "wrong"
    UNDECIDED = "undecided"
    INCOMPLETE = "incomplete"
    EQUIVALENT = "equivalent"
    TRIVIAL = "trivial"


EXIT_STATUS = {
    Verdict.EQUIVALENT: 0,
    Verdict.WRONG: 1,
    Verdict.INCOMPLETE: 1,
    Verdict.TRIVIAL: 1,
    Verdict.UNREADABLE: 2,
    Verdict.UNDECIDED: 3,
}


@dataclass(frozen=True)
class EquationVerdict:
    """The verdict on one equation, with what is wrong (`diagnosis`) and what is to be said beside (`remarks`)."""

    text: str
    verdict: Verdict
    diagnosis: str = ""
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class AnswerVerdict:
    """The verdict on a system of equations.

    missing     how many independent equations it lacks
    choice      the choice of coordinates that it was compared in; empty for the file's own
    unreadable  what could not be read, with places
    """

    verdict: Verdict
    equations: tuple[EquationVerdict, ...]
    missing: int = 0
    choice: str = ""
    unreadable: tuple[Diagnostic, ...] = ()
    notes: tuple[Diagnostic, ...] = ()


def check_equations(answer: Sequence[Fragment], reference: Reference) -> AnswerVerdict:
    """The verdict on equations of motion."""
    answer = separated(answer)
    if not answer:
        raise ProblemError(
            Diagnostic("no-answer", "there is no equation to check", help="give equations with -e, or in a file")
        )
    if len(answer) > MAX_EQUATIONS:
        message = f"an answer may have {MAX_EQUATIONS} equations, and this one has {len(answer)}"
        help_ = "leave out those that follow from the others"
        raise ProblemError(Diagnostic("too-many-equations", message, answer[MAX_EQUATIONS].whole, help=help_))
    readings = [read_answer(f, reference.scope) for f in answer]
    tried = [_tried(readings, candidate, reference) for candidate in reference.candidates]
    applicable = [v for v in tried if v is not None]
    notes = tuple(n for r in readings for n in r.notes)
    errors = tuple(d for r in readings if r.error for d in r.error.diagnostics)
    if not applicable:
        return _mixed(readings, errors, notes)
    best = max(applicable, key=lambda v: _QUALITY.index(v.verdict))
    return replace(best, unreadable=errors, notes=notes)


_QUALITY = (
    Verdict.UNREADABLE,
    Verdict.WRONG,
    Verdict.UNDECIDED,
    Verdict.TRIVIAL,
    Verdict.INCOMPLETE,
    Verdict.EQUIVALENT,
)


def _tried(readings: Sequence[Reading], candidate: Candidate, reference: Reference) -> AnswerVerdict | None:
    """The verdict in one set of coordinates; None where the answer uses others."""
    used = {base(s).name for r in readings for e in r.components for s in e.free_symbols}
    if not used & reference.moving <= candidate.known:
        return None
    if candidate.only_for and used.isdisjoint(candidate.only_for):
        return None
    components = [
        [_without_constant(candidate.read(e), candidate.configuration.slots) for e in r.components]
        for r in readings
        if r.error is None
    ]
    flat = [e for es in components for e in es]
    system = candidate.system_with(reference.values)
    if reference.values:
        flat = [e.xreplace(dict(reference.values)) for e in flat]
    free = [u for u in reference.unknowns if u.name in used and u not in system.multipliers]
    try:
        result = compare(flat, system, free)
    except DivisionByZeroError:
        return _dividing_by_zero(readings, components, system, candidate.choice)
    return _verdict(readings, result, candidate.choice)


def _without_constant(equation: sp.Expr, slots: Slots) -> sp.Expr:
    """A finite relation x − R φ = const as one between velocities; what has velocities already stays as it is."""
    if CONSTANT not in equation.free_symbols or equation.free_symbols & {*slots.velocities, *slots.accelerations}:
        return equation
    rate = slots.time_derivative(equation)
    return equation if CONSTANT in rate.free_symbols else rate


def _verdict(readings: Sequence[Reading], result: Comparison | None, choice: str) -> AnswerVerdict:
    """The verdicts on the equations and on the system."""
    standings = iter(result.standings if result else ())
    equations = []
    for r in readings:
        if r.error is not None:
            equations.append(EquationVerdict(r.text, Verdict.UNREADABLE, str(r.error.diagnostics[0].message)))
        elif result is None:
            equations.append(EquationVerdict(r.text, Verdict.UNDECIDED, "it could not be decided whether it follows"))
        else:
            equations.append(_of_one(r, [next(standings) for _ in r.components]))
    missing = result.missing if result else 0
    return AnswerVerdict(_of_all([e.verdict for e in equations], missing), tuple(equations), missing, choice)


def _of_one(reading: Reading, standings: Sequence[Standing]) -> EquationVerdict:
    """The verdict on one equation, from those on its components."""
    text = reading.text
    if Standing.NOT_LINEAR in standings:
        diagnosis = "it is not linear in the accelerations, as an equation of motion is"
        return EquationVerdict(text, Verdict.WRONG, diagnosis)
    if Standing.CONTRADICTS in standings:
        return EquationVerdict(text, Verdict.WRONG, "it does not follow from the equations of motion")
    if all(s is Standing.CONSTRAINT for s in standings):
        identities = [is_zero(e) for e in reading.components]
        if all(identities):
            return EquationVerdict(text, Verdict.TRIVIAL, "it is an identity, true of every motion")
        if None in identities and False not in identities:
            return EquationVerdict(text, Verdict.UNDECIDED, "it could not be decided whether it is an identity")
        return EquationVerdict(text, Verdict.EQUIVALENT, remarks=("it restates a constraint",))
    if Standing.FOLLOWS not in standings:
        return EquationVerdict(text, Verdict.EQUIVALENT, remarks=("it follows from the equations before it",))
    return EquationVerdict(text, Verdict.EQUIVALENT)


def _of_all(verdicts: Sequence[Verdict], missing: int) -> Verdict:
    """The first that applies: unreadable, wrong, undecided, trivial if all are, incomplete, equivalent."""
    for verdict in (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED):
        if verdict in verdicts:
            return verdict
    if all(v is Verdict.TRIVIAL for v in verdicts):
        return Verdict.TRIVIAL
    return Verdict.INCOMPLETE if missing else Verdict.EQUIVALENT


def _dividing_by_zero(
    readings: Sequence[Reading], components: Sequence[Sequence[sp.Expr]], system: System, choice: str
) -> AnswerVerdict:
    """The equations that divide by what is exactly zero are unreadable; the others are not judged."""
    parts = iter(components)
    equations = []
    for r in readings:
        if r.error is not None:
            equations.append(EquationVerdict(r.text, Verdict.UNREADABLE, r.error.diagnostics[0].message))
            continue
        try:
            compare(next(parts), system)
            equations.append(EquationVerdict(r.text, Verdict.UNDECIDED, "not judged beside an unreadable equation"))
        except DivisionByZeroError:
            equations.append(EquationVerdict(r.text, Verdict.UNREADABLE, "it divides by what is exactly zero"))
    return AnswerVerdict(Verdict.UNREADABLE, tuple(equations), choice=choice)


def _mixed(readings: Sequence[Reading], errors: tuple[Diagnostic, ...], notes: tuple[Diagnostic, ...]) -> AnswerVerdict:
    """No set of coordinates knows all that the answer uses."""
    diagnosis = "it mixes coordinates of several choices; use the file's coordinates and those of one choice"
    equations = tuple(
        EquationVerdict(r.text, Verdict.UNREADABLE, r.error.diagnostics[0].message if r.error else diagnosis)
        for r in readings
    )
    return AnswerVerdict(Verdict.UNREADABLE, equations, unreadable=errors, notes=notes)
