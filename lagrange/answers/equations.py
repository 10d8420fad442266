"""Somebody else's equations of motion: are they right?

An answer is read with the names of the problem only, and compared as a system: by its solutions, not by its form. It
may use the file's coordinates and those of one choice together; coordinates that a choice replaces are rewritten
through its substitution. It is tried against the file's own system and every choice, and the best verdict counts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from enum import StrEnum

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, is_zero
from lagrange.answers.answer_readings import Reading, read_answer
from lagrange.answers.conventions import Convention, other_convention
from lagrange.answers.diagnosis import diagnosed, in_letters
from lagrange.answers.hints import Advisor
from lagrange.answers.recognition import Kind, recognised
from lagrange.answers.references import Candidate, Reference
from lagrange.answers.validity import Condition, conditions
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import CONSTANT, Slots, base
from lagrange.core.vectors import Vector
from lagrange.expressions.latex_layout import separated
from lagrange.mechanics.dynamics.comparison import Standing, System, compare

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


@record
class EquationVerdict:
    """The verdict on one equation, with what is wrong (`diagnosis`) and what is to be said beside (`remarks`).

    sides  what is equal, as it was read, where the reading may surprise; empty otherwise
    hints  of a wrong equation of motion: the diagnosis in three degrees of frankness, the last of them `diagnosis`
    """

    text: str
    verdict: Verdict
    diagnosis: str = ""
    remarks: tuple[str, ...] = ()
    sides: tuple[sp.Expr | Vector, ...] = ()
    hints: tuple[str, ...] = ()

    def hinted(self, degree: int) -> EquationVerdict:
        """The same, with no more said of what is wrong than this degree allows: 1, 2 or 3."""
        return replace(self, diagnosis=self.hints[degree - 1]) if self.hints else self

    def as_json(self) -> dict[str, object]:
        """FORMAT's JSON object."""
        found = {"text": self.text, "verdict": self.verdict.value, "diagnosis": self.diagnosis}
        return {**found, "remarks": list(self.remarks)}


@record
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


def check_equations(answer: Sequence[Fragment], reference: Reference, *, diagnosing: bool = True) -> AnswerVerdict:
    """The verdict on equations of motion; `diagnosing`: also what would make the wrong ones right."""
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
    attempts = list(_attempts(readings, reference))
    notes = tuple(n for r in readings for n in r.notes)
    errors = tuple(d for r in readings if r.error for d in r.error.diagnostics)
    if not attempts:
        return _mixed(readings, errors, notes)
    best = max(attempts, key=lambda a: a.quality)
    found = _with_reasons(best, readings, reference, diagnosing)
    equations = tuple(replace(e, sides=r.surprising) for e, r in zip(found.equations, readings, strict=True))
    return replace(found, equations=equations, unreadable=errors, notes=notes)


_QUALITY = (
    Verdict.UNREADABLE,
    Verdict.WRONG,
    Verdict.UNDECIDED,
    Verdict.TRIVIAL,
    Verdict.INCOMPLETE,
    Verdict.EQUIVALENT,
)


@record
class _Attempt:
    """An answer compared with one system.

    components  of each equation, as they were compared; none of what cannot be read
    standings   of these; none where it could not be decided, or nothing was compared
    """

    verdict: AnswerVerdict
    candidate: Candidate
    components: tuple[tuple[sp.Expr, ...], ...] = ()
    standings: tuple[tuple[Standing, ...], ...] = ()

    @property
    def quality(self) -> tuple[int, int, int, bool]:
        """The better verdict; of two wrong ones that with more right equations, then with more that are linear.

        Then with radii taken as positive: what is wrong there is not the sign of a radius.
        """
        right = sum(e.verdict is Verdict.EQUIVALENT for e in self.verdict.equations)
        bent = sum(Standing.NOT_LINEAR in standings for standings in self.standings)
        return _QUALITY.index(self.verdict.verdict), right, -bent, bool(self.candidate.positive)


def _attempts(readings: Sequence[Reading], reference: Reference) -> Iterator[_Attempt]:
    """The verdicts in all sets of coordinates that know the answer's, until it is right in one.

    After that, where it is not right, with radii taken as positive.
    """
    tried = []
    for candidate in reference.candidates:
        attempt = _attempt(readings, candidate, reference)
        if attempt is not None:
            yield attempt
            if attempt.verdict.verdict is Verdict.EQUIVALENT:
                return
            tried.append((candidate, attempt))
    for candidate, before in tried:
        there = candidate.where_positive
        attempt = None if there is None else _attempt(readings, there, reference)
        if there is not None and attempt is not None:
            yield replace(attempt, verdict=_where_positive(attempt.verdict, before.verdict, there))


def _where_positive(verdict: AnswerVerdict, before: AnswerVerdict, candidate: Candidate) -> AnswerVerdict:
    """The verdict with a remark on the equations that are right only because radii are positive."""
    where = " and ".join(f"{r} > 0" for r in candidate.positive)
    equations = tuple(
        replace(e, remarks=(*e.remarks, f"valid where {where}"))
        if e.verdict is Verdict.EQUIVALENT and b.verdict is not Verdict.EQUIVALENT
        else e
        for e, b in zip(verdict.equations, before.equations, strict=True)
    )
    return replace(verdict, equations=equations)


def _attempt(readings: Sequence[Reading], candidate: Candidate, reference: Reference) -> _Attempt | None:
    """The verdict in one set of coordinates; None where the answer uses others."""
    used = {base(s).name for r in readings for e in r.components for s in e.free_symbols}
    if not used & reference.moving <= candidate.known:
        return None
    if candidate.only_for and used.isdisjoint(candidate.only_for):
        return None
    slots = candidate.configuration.slots
    components = tuple(
        () if r.error else tuple(_without_constant(candidate.read(e), slots) for e in r.components) for r in readings
    )
    system = candidate.system
    free = [u for u in reference.unknowns if u.name in used and u not in system.multipliers]
    try:
        result = compare([e for es in components for e in es], system, free)
    except DivisionByZeroError:
        return _Attempt(_dividing_by_zero(readings, components, system, candidate.choice), candidate)
    if result is None:
        return _Attempt(_verdict(readings, None, 0, candidate.choice), candidate)
    left = iter(result.standings)
    standings = tuple(tuple(next(left) for _ in es) for es in components)
    verdict = _verdict(readings, standings, result.missing, candidate.choice)
    if candidate.named:
        verdict = _saying_more(verdict, readings, candidate)
    if candidate.remarks:
        verdict = _saying_what_is_meant(verdict, readings, candidate)
    return _Attempt(verdict, candidate, () if free else components, standings)


def _saying_more(verdict: AnswerVerdict, readings: Sequence[Reading], candidate: Candidate) -> AnswerVerdict:
    """An equation with a reaction whose value is known here says that value too: it is not redundant."""
    equations = tuple(
        replace(e, remarks=tuple(x for x in e.remarks if x != REDUNDANT))
        if any(s.name in candidate.named for c in r.components for s in c.free_symbols)
        else e
        for e, r in zip(verdict.equations, readings, strict=True)
    )
    return replace(verdict, equations=equations)


def _saying_what_is_meant(verdict: AnswerVerdict, readings: Sequence[Reading], candidate: Candidate) -> AnswerVerdict:
    """The right equations, with what the names of forces in them are taken for."""
    equations = tuple(
        replace(e, remarks=(*e.remarks, *candidate.said_of(r.components))) if e.verdict is Verdict.EQUIVALENT else e
        for e, r in zip(verdict.equations, readings, strict=True)
    )
    return replace(verdict, equations=equations)


def _without_constant(equation: sp.Expr, slots: Slots) -> sp.Expr:
    """A finite relation x − R φ = const as one between velocities; what has velocities already stays as it is."""
    if CONSTANT not in equation.free_symbols or equation.free_symbols & {*slots.velocities, *slots.accelerations}:
        return equation
    rate = slots.time_derivative(equation)
    return equation if CONSTANT in rate.free_symbols else rate


def _verdict(
    readings: Sequence[Reading], standings: Sequence[Sequence[Standing]] | None, missing: int, choice: str
) -> AnswerVerdict:
    """The verdicts on the equations and on the system. No standings: undecided."""
    equations = []
    for n, r in enumerate(readings):
        if r.error is not None:
            equations.append(EquationVerdict(r.text, Verdict.UNREADABLE, r.error.diagnostics[0].message))
        elif standings is None:
            equations.append(EquationVerdict(r.text, Verdict.UNDECIDED, "it could not be decided whether it follows"))
        else:
            equations.append(_of_one(r, standings[n]))
    return AnswerVerdict(_of_all([e.verdict for e in equations], missing), tuple(equations), missing, choice)


def _of_one(reading: Reading, standings: Sequence[Standing]) -> EquationVerdict:
    """The verdict on one equation, from those on its components."""
    text = reading.text
    if Standing.NOT_LINEAR in standings:
        return EquationVerdict(text, Verdict.WRONG, WHAT_IT_IS[Kind.NOT_LINEAR])
    if Standing.CONTRADICTS in standings:
        return EquationVerdict(text, Verdict.WRONG, WHAT_IT_IS[Kind.OTHER])
    if all(s is Standing.CONSTRAINT for s in standings):
        identities = [is_zero(e) for e in reading.components]
        if all(identities):
            return EquationVerdict(text, Verdict.TRIVIAL, "it is an identity, true of every motion")
        if None in identities and False not in identities:
            return EquationVerdict(text, Verdict.UNDECIDED, "it could not be decided whether it is an identity")
        return EquationVerdict(text, Verdict.EQUIVALENT, remarks=("it restates a constraint",))
    if Standing.FOLLOWS not in standings:
        return EquationVerdict(text, Verdict.EQUIVALENT, remarks=(REDUNDANT,))
    return EquationVerdict(text, Verdict.EQUIVALENT)


REDUNDANT = "redundant: it follows from those before it"
WHAT_IT_IS = {
    Kind.SQUARE: "it is not linear in the accelerations: it is the square of an equation that is right",
    Kind.SUM_OF_SQUARES: "it is not linear in the accelerations: it is made of squares and products of right equations",
    Kind.POWER: "it is not linear in the accelerations: it is a power, or a product, of equations that are right",
    Kind.HOLDS: "it is not linear in the accelerations, though it holds for the motion",
    Kind.NOT_LINEAR: "it is not linear in the accelerations, as an equation of motion is",
    Kind.ENERGY: "it is a first integral, that of energy; {derivative}",
    Kind.MOMENTUM: "it is a first integral, that of a momentum; {derivative}",
    Kind.INTEGRAL: "it is a first integral; {derivative}",
    Kind.OF_PARAMETERS: "it says nothing of the motion, and is not true of all values of the parameters",
    Kind.IMPOSSIBLE: "it can never hold",
    Kind.NO_ACCELERATION: "there is no acceleration in it, and it does not hold in every state of motion",
    Kind.OTHER: "it does not follow from the equations of motion",
}
_DERIVATIVE = {
    True: "its time derivative is the equation asked",
    False: "its time derivative follows from the equations asked",
}


def _with_reasons(
    attempt: _Attempt, readings: Sequence[Reading], reference: Reference, diagnosing: bool
) -> AnswerVerdict:
    """What is wrong with the wrong equations, and where the right ones say less than they should."""
    verdict = attempt.verdict
    if not attempt.components:
        return verdict
    system = attempt.candidate.system
    equations = list(verdict.equations)
    following = []
    advisor = Advisor(system.configuration.slots)
    turned = _convention(attempt, system) if diagnosing else None
    for n, (es, standings) in enumerate(zip(attempt.components, attempt.standings, strict=True)):
        bad = [(e, s) for e, s in zip(es, standings, strict=True) if s in (Standing.NOT_LINEAR, Standing.CONTRADICTS)]
        if bad:
            equation, linear = bad[0][0], bad[0][1] is not Standing.NOT_LINEAR
            kind = recognised(equation, system, linear=linear)
            why = WHAT_IT_IS[kind].format(derivative=_DERIVATIVE[_has_one_equation(system)])
            asked = diagnosing and kind in _TO_BE_DIAGNOSED
            change = diagnosed(equation, system) if asked else None
            if change is not None and attempt.candidate.values:
                written = readings[n].components[es.index(equation)]
                change = in_letters(change, attempt.candidate.in_letters(written), attempt.candidate.values)
            units = reference.mismatch(readings[n]) if asked else None
            hints = advisor.hints(why, change, units, turned, readings[n].sides)
            equations[n] = replace(equations[n], diagnosis=hints[-1], hints=hints)
        elif len(es) == 1 and standings[0] is Standing.FOLLOWS:
            following.append((n, es[0]))
    alone = all(Standing.REDUNDANT not in standings for standings in attempt.standings)
    found = conditions([e for _, e in following], system, complete=alone)
    for (n, _), said in zip(following, found, strict=True):
        equations[n] = replace(equations[n], remarks=(*equations[n].remarks, *map(_remark, said)))
    return replace(verdict, equations=tuple(equations))


_TO_BE_DIAGNOSED = (Kind.OTHER, Kind.NO_ACCELERATION)


def _convention(attempt: _Attempt, system: System) -> Convention | None:
    """Another way of measuring a coordinate for which the whole answer, wrong as it is, would be right."""
    standings = [s for several in attempt.standings for s in several]
    if Standing.CONTRADICTS not in standings or Standing.NOT_LINEAR in standings:
        return None
    found = other_convention([e for es in attempt.components for e in es], system)
    return None if found is not None and found.coordinate in attempt.candidate.positive else found


def _has_one_equation(system: System) -> bool:
    """Whether one equation of motion is asked for."""
    configuration = system.configuration
    return len(configuration.slots.coordinates) - len(configuration.rows) == 1


def _remark(condition: Condition) -> str:
    how = "divided" if condition.divided else "multiplied"
    if condition.factor is None:
        return f"valid only where what it is {how} by is not zero"
    factor = str(condition.factor).replace("**", "^")
    where = f"valid where {factor} != 0"
    if condition.together:
        return f"{where}: only there are the accelerations determined"
    return f"{where} ({how} by it)"


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
    equations = []
    for r, es in zip(readings, components, strict=True):
        if r.error is not None:
            equations.append(EquationVerdict(r.text, Verdict.UNREADABLE, r.error.diagnostics[0].message))
            continue
        try:
            compare(es, system)
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
