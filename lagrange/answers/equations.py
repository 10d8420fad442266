"""The equations of motion of an answer: are they right?

An answer is read with the names of the problem only, and compared as a system, by its solutions and not by its form:
at random states the row spaces of [A | b], affine in the accelerations and multipliers, must agree (`comparison`). It
may use the file's coordinates together with those of one choice; coordinates that a choice replaces are rewritten by
its substitution. It is compared with the file's own system and with that of every choice, and the best verdict counts.
Wrong equations are then diagnosed, and right ones get the conditions under which they are valid.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.limits import MAX_EQUATIONS
from lagrange.answers.readings import (
    NOT_FOR_ALL,
    Reading,
    decimals_in,
    displaced_coordinates,
    read_answer,
    without_displacements,
)
from lagrange.answers.recognition import FROM_THE_START, recognised
from lagrange.answers.references import Reference, ReferenceCandidate
from lagrange.answers.validity import NonzeroCondition, validity_conditions
from lagrange.answers.verdicts import (
    DIVIDES_BY_ZERO,
    MIXED_CHOICES,
    NOT_JUDGED,
    WHAT_IT_IS,
    WORST_TO_BEST,
    AnswerVerdict,
    EquationVerdict,
    Recognised,
    Verdict,
)
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import CONSTANT, Decimal, Slots, base, symbols_in
from lagrange.core.vectors import Vector
from lagrange.expressions.latex_layout import separated_latex
from lagrange.mechanics.dynamics.comparison import EquationComparison, Standing, System, compare, compare_really

if TYPE_CHECKING:
    from lagrange.answers.hints import Convention
    from lagrange.answers.models.search import Explanation
    from lagrange.answers.written.decimals import DecimalValues


def check_equations(answer: Sequence[Fragment], reference: Reference, *, diagnosing: bool = True) -> AnswerVerdict:
    """The verdict on equations of motion; `diagnosing`: with the change that would make a wrong one right.

    Raises ProblemError if there are no equations, or too many.
    """
    return compared_answer(answer, reference).verdict(diagnosing=diagnosing)


@record
class ComparedAnswer:
    """An answer with the comparison that counts. What is wrong with it is found out when a verdict is asked for.

    best  the comparison with the system with which it agrees best; None if there is none with all that it uses
    """

    reference: Reference
    readings: Sequence[Reading]
    best: _Attempt | None

    def verdict(self, *, diagnosing: bool) -> AnswerVerdict:
        """The verdict, with reasons; `diagnosing`: with the change that would make a wrong equation right."""
        notes = tuple(n for r in self.readings for n in r.notes)
        errors = tuple(d for r in self.readings if r.error for d in r.error.diagnostics)
        if self.best is None:
            return _mixed(self.readings, errors, notes)
        verdict = _with_reasons(self.best, self.readings, self.reference, diagnosing)
        pairs = zip(verdict.equations, self.readings, strict=True)
        equations = tuple(replace(e, sides=r.surprising) for e, r in pairs)
        return replace(verdict, equations=equations, unreadable=errors, notes=notes)


def compared_answer(answer: Sequence[Fragment], reference: Reference) -> ComparedAnswer:
    """The comparison of equations of motion. Raises ProblemError if there are no equations, or too many."""
    answer = separated_latex(answer)
    if not answer:
        raise ProblemError(
            Diagnostic("no-answer", "there is no equation to check", help="give equations with -e, or in a file")
        )
    if len(answer) > MAX_EQUATIONS:
        message = f"an answer may have at most {MAX_EQUATIONS} equations; this one has {len(answer)}"
        help_ = "leave out those that follow from the others"
        raise ProblemError(Diagnostic("too-many-equations", message, answer[MAX_EQUATIONS].whole, help=help_))
    readings = [read_answer(f, reference.scope) for f in answer]
    best = max(_attempts(readings, reference), key=lambda a: a.quality, default=None)
    return ComparedAnswer(reference, readings, best)


def sides_of(answer: Sequence[Fragment], reference: Reference) -> list[tuple[sp.Expr | Vector, ...]]:
    """The sides of each equation as they are written; none of one that cannot be read."""
    return [read_answer(f, reference.scope).sides for f in separated_latex(answer)]


@record
class _Attempt:
    """An answer compared with one system.

    components  of each equation, as they were compared; empty for an equation that cannot be read
    standings   of the components; empty if the comparison was undecided or not made
    replaced    how many coordinates of the answer are expressed by others, where it is wrong
    """

    verdict: AnswerVerdict
    candidate: ReferenceCandidate
    components: tuple[tuple[sp.Expr, ...], ...] = ()
    standings: tuple[tuple[Standing, ...], ...] = ()
    replaced: int = 0

    @property
    def quality(self) -> tuple[int, int, int, int, int, bool]:
        """The rank of the verdict; then the number of right equations, then that of linear ones.

        Then the coordinates of the answer are preferred, then fewer, in which a mistake is easier to name. Last, radii
        taken as positive are preferred: a mistake that remains there is not the sign of a radius.
        """
        right = sum(e.verdict is Verdict.EQUIVALENT for e in self.verdict.equations)
        nonlinear = sum(Standing.NOT_LINEAR in standings for standings in self.standings)
        size = len(self.candidate.configuration.slots.coordinates) if self.verdict.verdict is Verdict.WRONG else 0
        worst = WORST_TO_BEST.index(self.verdict.verdict)
        return worst, right, -nonlinear, -self.replaced, -size, bool(self.candidate.positive)


def _attempts(readings: Sequence[Reading], reference: Reference) -> Iterator[_Attempt]:
    """The verdicts in all sets of coordinates that have those of the answer, until it is right in one.

    If it is right in none, then also with radii taken as positive.
    """
    tried = []
    for candidate in reference.candidates_for({s.name for r in readings for e in r.components for s in symbols_in(e)}):
        attempt = _attempt(readings, candidate, reference)
        if attempt is not None:
            yield attempt
            if attempt.verdict.verdict is Verdict.EQUIVALENT:
                return
            tried.append((candidate, attempt))
    for candidate, before in tried:
        positive = candidate.with_positive_radii
        attempt = None if positive is None else _attempt(readings, positive, reference)
        if positive is not None and attempt is not None:
            yield replace(attempt, verdict=_right_for_positive_radii(attempt.verdict, before.verdict, positive))


def _right_for_positive_radii(
    verdict: AnswerVerdict, before: AnswerVerdict, candidate: ReferenceCandidate
) -> AnswerVerdict:
    """The verdict, with a remark on each equation that is right only if radii are positive."""
    where = " and ".join(f"{r} > 0" for r in candidate.positive)
    equations = tuple(
        replace(e, remarks=(*e.remarks, f"valid where {where}"))
        if e.verdict is Verdict.EQUIVALENT and b.verdict is not Verdict.EQUIVALENT
        else e
        for e, b in zip(verdict.equations, before.equations, strict=True)
    )
    return replace(verdict, equations=equations)


def _attempt(readings: Sequence[Reading], candidate: ReferenceCandidate, reference: Reference) -> _Attempt | None:
    """The verdict in one set of coordinates; None if the answer uses others."""
    used = {base(s).name for r in readings for e in r.components for s in symbols_in(e)}
    displaced = displaced_coordinates([e for r in readings for e in r.components], reference.scope.slots.coordinates)
    used |= {q.name for q in displaced}
    if not used & reference.moving <= candidate.known:
        return None
    if candidate.only_for and used.isdisjoint(candidate.only_for):
        return None
    system = candidate.system
    components = tuple(() if r.error else _compared_parts(r.components, candidate) for r in readings)
    free = [u for u in reference.unknowns if u.name in used and u not in system.multipliers]
    try:
        result = compare([e for es in components for e in es], system, free)
    except DivisionByZeroError:
        return _Attempt(_dividing_by_zero(readings, components, system, candidate.choice), candidate)
    if result is None:
        return _Attempt(_verdict(readings, None, 0, candidate.choice), candidate)
    standings = _in_order(result, components)
    missing = result.missing
    values = {} if result.agree else _rounded(readings, standings, components, candidate)
    if values:
        components, standings, missing = _with_rounded(
            values, readings, components, standings, candidate, free, missing
        )
    from_start = {
        n
        for n, several in enumerate(standings)
        if Standing.CONTRADICTS in several and candidate.holds_from_start(components[n], readings[n].components)
    }
    standings = tuple((Standing.CONSTRAINT,) * len(s) if n in from_start else s for n, s in enumerate(standings))
    verdict = _verdict(readings, standings, missing, candidate.choice)
    if from_start:
        marked = (
            replace(e, remarks=(FROM_THE_START,)) if n in from_start else e for n, e in enumerate(verdict.equations)
        )
        verdict = replace(verdict, equations=tuple(marked))
    if values:
        from lagrange.answers.written.decimals import remark_on

        equations = tuple(
            replace(e, remarks=(*e.remarks, remark))
            if e.verdict is Verdict.EQUIVALENT and (remark := remark_on(values.get(n, {})))
            else e
            for n, e in enumerate(verdict.equations)
        )
        verdict = replace(verdict, equations=equations)
    if candidate.named:
        verdict = _without_redundancy(verdict, readings, candidate)
    if candidate.remarks:
        verdict = _with_meanings(verdict, readings, candidate)
    # Unknown forces that only the answer has are columns that `compare` projects out of all its rows together. Then no
    # row of a single equation is left in which the change of one term could be weighed: nothing is diagnosed.
    wrong = verdict.verdict is Verdict.WRONG
    replaced = len({q.name for q in candidate.configuration.expressed} & used) if wrong else 0
    return _Attempt(verdict, candidate, () if free else components, standings, replaced)


def _compared_parts(components: Sequence[sp.Expr], candidate: ReferenceCandidate) -> tuple[sp.Expr, ...]:
    """The components of an equation as they are compared."""
    slots = candidate.configuration.slots
    return tuple(
        part
        for e in components
        for part in without_displacements(_without_constant(candidate.read(e), slots), candidate.system.configuration)
    )


def _in_order(result: EquationComparison, components: Sequence[Sequence[sp.Expr]]) -> tuple[tuple[Standing, ...], ...]:
    in_order = iter(result.standings)
    return tuple(tuple(next(in_order) for _ in es) for es in components)


def _rounded(
    readings: Sequence[Reading],
    standings: Sequence[Sequence[Standing]],
    components: Sequence[Sequence[sp.Expr]],
    candidate: ReferenceCandidate,
) -> dict[int, DecimalValues]:
    """The exact numbers that decimals in wrong equations stand for, if these make the equations correct."""
    rounded = {}
    for n, r in enumerate(readings):
        if components[n] and Standing.CONTRADICTS in standings[n] and r.with_decimals:
            from lagrange.answers.written.decimals import rounded_in_motion

            values = rounded_in_motion(_compared_parts(r.with_decimals, candidate), candidate.system)
            if values is not None:
                rounded[n] = values
    return rounded


def _with_rounded(
    values: Mapping[int, DecimalValues],
    readings: Sequence[Reading],
    components: Sequence[tuple[sp.Expr, ...]],
    standings: tuple[tuple[Standing, ...], ...],
    candidate: ReferenceCandidate,
    free: Sequence[sp.Symbol],
    missing: int,
) -> tuple[tuple[tuple[sp.Expr, ...], ...], tuple[tuple[Standing, ...], ...], int]:
    """The components and their standings with these numbers for decimals, and how many equations are missing."""
    own = {n: {d: Decimal(d.text, f"{n} {d.name}") for d in of_one} for n, of_one in values.items()}
    with_decimals = tuple(
        tuple(e.xreplace(dict(own[n])) for e in _compared_parts(r.with_decimals, candidate)) if n in values else es
        for n, (r, es) in enumerate(zip(readings, components, strict=True))
    )
    numbers = {own[n][d]: v for n, of_one in values.items() for d, v in of_one.items()}
    result = compare_really([e for es in with_decimals for e in es], candidate.system, free, numbers)
    if result is None:
        return tuple(components), standings, missing
    return with_decimals, _in_order(result, with_decimals), result.missing


def _without_redundancy(
    verdict: AnswerVerdict, readings: Sequence[Reading], candidate: ReferenceCandidate
) -> AnswerVerdict:
    """The verdict, in which an equation with a reaction of known value is not redundant: it states that value too."""
    equations = tuple(
        replace(e, remarks=tuple(x for x in e.remarks if x != REDUNDANT))
        if any(s.name in candidate.named for c in r.components for s in symbols_in(c))
        else e
        for e, r in zip(verdict.equations, readings, strict=True)
    )
    return replace(verdict, equations=equations)


def _with_meanings(verdict: AnswerVerdict, readings: Sequence[Reading], candidate: ReferenceCandidate) -> AnswerVerdict:
    """The verdict, with a remark on each right equation about the meaning of the names of forces in it."""
    equations = tuple(
        replace(e, remarks=(*e.remarks, *candidate.remarks_on(r.components))) if e.verdict is Verdict.EQUIVALENT else e
        for e, r in zip(verdict.equations, readings, strict=True)
    )
    return replace(verdict, equations=equations)


def _without_constant(equation: sp.Expr, slots: Slots) -> sp.Expr:
    """A finite relation x − R φ = const differentiated once; an equation with velocities is returned as it is."""
    if CONSTANT not in symbols_in(equation) or equation.free_symbols & {*slots.velocities, *slots.accelerations}:
        return equation
    rate = slots.time_derivative(equation)
    return equation if CONSTANT in rate.free_symbols else rate


def _verdict(
    readings: Sequence[Reading], standings: Sequence[Sequence[Standing]] | None, missing: int, choice: str
) -> AnswerVerdict:
    """The verdict on the system; undecided if there are no standings."""
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
        return EquationVerdict(text, Verdict.WRONG, WHAT_IT_IS[Recognised.NOT_LINEAR])
    if Standing.CONTRADICTS in standings:
        return EquationVerdict(text, Verdict.WRONG, WHAT_IT_IS[Recognised.OTHER])
    if all(s is Standing.CONSTRAINT for s in standings):
        identities = [is_zero(e) for e in reading.components]
        if all(identities):
            return EquationVerdict(text, Verdict.TRIVIAL, "it is an identity, true for every motion")
        if None in identities and False not in identities:
            return EquationVerdict(text, Verdict.UNDECIDED, "it could not be decided whether it is an identity")
        return EquationVerdict(text, Verdict.EQUIVALENT, remarks=("it restates a constraint",))
    if Standing.FOLLOWS not in standings:
        return EquationVerdict(text, Verdict.EQUIVALENT, remarks=(REDUNDANT,))
    return EquationVerdict(text, Verdict.EQUIVALENT)


REDUNDANT = "redundant: it follows from those before it"
_DERIVATIVE = {
    True: "its time derivative is the equation asked for",
    False: "its time derivative follows from the equations asked for",
}


def _with_reasons(
    attempt: _Attempt, readings: Sequence[Reading], reference: Reference, diagnosing: bool
) -> AnswerVerdict:
    """The verdict, with a diagnosis of each wrong equation and the conditions under which a right one is valid."""
    verdict = attempt.verdict
    if not attempt.components:
        return verdict
    system = attempt.candidate.system
    equations = list(verdict.equations)
    following = []
    two: Explanation | None = None
    explained_together: list[tuple[int, Callable[[Explanation], tuple[str, ...]]]] = []
    explanations = _explanations(attempt, reference) if diagnosing else _NONE
    convention = _convention(attempt) if diagnosing and not _is_settled(explanations, attempt) else None
    for n, (es, standings) in enumerate(zip(attempt.components, attempt.standings, strict=True)):
        displaced = displaced_coordinates(readings[n].components, reference.scope.slots.coordinates)
        bad = [(e, s) for e, s in zip(es, standings, strict=True) if s in (Standing.NOT_LINEAR, Standing.CONTRADICTS)]
        if bad:
            equation, linear = bad[0][0], bad[0][1] is not Standing.NOT_LINEAR
            if displaced:
                equations[n] = replace(equations[n], diagnosis=NOT_FOR_ALL, hints=(NOT_FOR_ALL,) * 3)
                continue
            # Most answers are right, and need nothing of this; so do the answers of problem files.
            from lagrange.answers.diagnosis import diagnosed, in_symbols
            from lagrange.answers.hints import Advisor, cause_of
            from lagrange.answers.models.table import MEASURED_FROM_ELSEWHERE
            from lagrange.answers.results.forces import explained_force, one_sense

            residues = attempt.candidate.residues
            advisor = Advisor(system.configuration.slots)
            kind = recognised(equation, system, linear=linear)
            why = WHAT_IT_IS[kind].format(derivative=_DERIVATIVE[_has_one_equation(system)])
            wanted = diagnosing and kind in _TO_BE_DIAGNOSED
            model = explanations.get(n) if wanted else None
            change = diagnosed(equation, system, beside=model is not None, residues=residues) if wanted else None
            if wanted and model is None and convention is None and (change is None or change.slip is None):
                two = two or _two_mistakes(attempt)
            if change is not None and attempt.candidate.values:
                written = readings[n].components[es.index(equation)]
                change = in_symbols(change, attempt.candidate.in_symbols(written), attempt.candidate.values)
            units = reference.mismatch(readings[n]) if wanted else None
            name = model.name if model is not None else ""
            cause = model.cause if model is not None else cause_of(change)
            force = one_sense(equation, system) if wanted and model is None else ""
            change = None if force else change
            if wanted and model is None and not force:
                unknown = two is None and (change is None or change.slip is None)
                force = explained_force(equation, attempt.candidate, reference, moving=unknown)
            if convention is not None and name == MEASURED_FROM_ELSEWHERE:
                model = None  # the convention says the same, in better words
            hints = advisor.hints(why, change, units, convention, readings[n].sides, model)
            if force:
                hints = *hints[:2], advisor.hints(force, change, units, convention, readings[n].sides)[-1]
            equations[n] = replace(
                equations[n], diagnosis=hints[-1], hints=hints, cause=force or cause, model=name, kind=kind
            )
            if wanted:
                explained_together.append((n, partial(advisor.hints, why, None, units, None, readings[n].sides)))
        elif len(es) == 1 and standings[0] is Standing.FOLLOWS and not displaced and not decimals_in(es):
            following.append((n, es[0]))
    for n, hints_on in explained_together if two is not None else ():
        assert two is not None
        hints = hints_on(two)
        equations[n] = replace(equations[n], diagnosis=hints[-1], hints=hints, cause=two.cause, model=two.name)
    # Where the determinant of some equations vanishes, a redundant one may still determine the accelerations.
    complete = all(Standing.REDUNDANT not in standings for standings in attempt.standings)
    # A wrong answer is asked about again, with a diagnosis.
    asked = following and (diagnosing or verdict.verdict is not Verdict.WRONG)
    known = attempt.candidate.factorizations
    nonzero = (
        validity_conditions([e for _, e in following], known, complete=complete) if asked else [()] * len(following)
    )
    for (n, _), own in zip(following, nonzero, strict=True):
        equations[n] = replace(equations[n], remarks=(*equations[n].remarks, *map(_remark, own)))
    return replace(verdict, equations=tuple(equations))


def _is_settled(explanations: Mapping[int, Explanation], attempt: _Attempt) -> bool:
    """Whether a model explains the answer; one later in the table only where no other convention does.

    Where coordinates are free, other ways of measuring one are among the models that have been tried.
    """
    if explanations is _NONE:
        return False
    from lagrange.answers.models.table import AS_BY_A_CONVENTION

    models = attempt.candidate.models
    if models.mechanics is not None and models.is_free:
        return not any(e.whole and e.name in AS_BY_A_CONVENTION for e in explanations.values())
    return any(e.whole and e.name not in AS_BY_A_CONVENTION for e in explanations.values())


_NONE: dict[int, Explanation] = {}
"""Where no explanation is sought."""


def _candidate_with_parts(
    equations: Sequence[sp.Expr], attempt: _Attempt, reference: Reference, *, rough: int
) -> ReferenceCandidate:
    """The system of an attempt; if its parts are not known, as where forces of constraints are stated in the
    coordinates of a choice, another one that has all their symbols, and at least so many rough contacts: with fewer
    than two, forces of constraints are compared singly first, which tells more of one."""
    own = attempt.candidate
    used = {base(s) for e in equations for s in e.free_symbols}
    moving = {*reference.scope.slots.coordinates, *(m for c in reference.candidates for m in c.multipliers)}
    if not own.multipliers or own.models.mechanics is not None:
        return own
    for c in reference.candidates:
        known = {*c.configuration.slots.coordinates, *c.multipliers}
        if not (used & moving <= known and {*own.multipliers} <= known):
            continue
        if c.models.mechanics is not None and len(c.models.mechanics.frictions) >= rough:
            return c
    return own


def _with_open_forces(own: ReferenceCandidate, reference: Reference) -> ReferenceCandidate | None:
    """The system with unknown forces of constraints, where friction at several places depends on them: with one of
    these changed, the forces of constraints are others as well."""
    if own.models.mechanics is None or len(own.models.mechanics.frictions) < 2 or own.multipliers:
        return None
    coordinates = {*own.configuration.slots.coordinates}
    for c in reference.candidates:
        if c.multipliers and coordinates <= {*c.configuration.slots.coordinates} and c.models.mechanics is not None:
            return c
    return None


def _explanations(attempt: _Attempt, reference: Reference) -> dict[int, Explanation]:
    """The models that explain wrong equations, by their numbers."""
    standings = attempt.standings
    if any(Standing.NOT_LINEAR in several for several in standings):
        return _NONE
    components = [(n, e) for n, es in enumerate(attempt.components) for e in es]
    bad = [m for m, standing in enumerate(_flat(standings)) if standing is Standing.CONTRADICTS]
    if not bad:
        return _NONE
    from lagrange.answers.models.search import explained

    equations = [e for _, e in components]
    own = _candidate_with_parts(equations, attempt, reference, rough=2)
    explanations = explained(equations, bad, own.models)
    used = {s for m in bad for s in equations[m].free_symbols}
    if own.models.mechanics is None and not used.isdisjoint(reference.scope.slots.accelerations):
        other = _candidate_with_parts(
            equations, attempt, reference, rough=0
        )  # one mistake in the motion and the forces
        together = explained(equations, bad, other.models)
        explanations = together if all(e is not None and e.whole for e in together) else explanations
    if not any(explanations) and (open_ := _with_open_forces(own, reference)) is not None:
        explanations = explained(equations, bad, open_.models)
    return {components[m][0]: e for m, e in reversed(list(zip(bad, explanations, strict=True))) if e is not None}


def _two_mistakes(attempt: _Attempt) -> Explanation | None:
    """Two mistakes that explain the answer as a whole; None if none are found."""
    if Standing.NOT_LINEAR in _flat(attempt.standings):
        return None
    from lagrange.answers.models.pairs import explained_by_two

    return explained_by_two([e for es in attempt.components for e in es], attempt.candidate.models)


def _flat(standings: Sequence[Sequence[Standing]]) -> list[Standing]:
    return [s for several in standings for s in several]


_TO_BE_DIAGNOSED = (Recognised.OTHER, Recognised.NO_ACCELERATION)


def _convention(attempt: _Attempt) -> Convention | None:
    """The other way of measuring a coordinate with which the whole of a wrong answer would be right; None: none."""
    standings = [s for several in attempt.standings for s in several]
    if Standing.CONTRADICTS not in standings or Standing.NOT_LINEAR in standings:
        return None
    from lagrange.answers.hints import other_convention

    convention = other_convention([e for es in attempt.components for e in es], attempt.candidate.residues)
    if convention is not None and convention.coordinate in attempt.candidate.positive:
        return None
    return convention


def _has_one_equation(system: System) -> bool:
    """Whether one equation of motion is asked for."""
    return len(system.configuration.slots.coordinates) - len(system.configuration.rows) == 1


def _remark(condition: NonzeroCondition) -> str:
    how = "divided" if condition.divided else "multiplied"
    if condition.factor is None:
        return f"valid only where the factor it is {how} by is not zero"
    factor = str(condition.factor).replace("**", "^")
    where = f"valid where {factor} != 0"
    if condition.together:
        return f"{where}: the accelerations are determined only there"
    return f"{where} ({how} by it)"


def _of_all(verdicts: Sequence[Verdict], missing: int) -> Verdict:
    """The verdict on the system: the first that applies of unreadable, wrong, undecided, trivial if all are, ..."""
    for verdict in (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED):
        if verdict in verdicts:
            return verdict
    if all(v is Verdict.TRIVIAL for v in verdicts):
        return Verdict.TRIVIAL
    return Verdict.INCOMPLETE if missing else Verdict.EQUIVALENT


def _dividing_by_zero(
    readings: Sequence[Reading], components: Sequence[Sequence[sp.Expr]], system: System, choice: str
) -> AnswerVerdict:
    """The verdict if an equation divides by exactly zero: that equation is unreadable, the others are not judged."""
    equations = []
    for r, es in zip(readings, components, strict=True):
        if r.error is not None:
            equations.append(EquationVerdict(r.text, Verdict.UNREADABLE, r.error.diagnostics[0].message))
            continue
        try:
            compare(es, system)
            equations.append(EquationVerdict(r.text, Verdict.UNDECIDED, NOT_JUDGED))
        except DivisionByZeroError:
            equations.append(EquationVerdict(r.text, Verdict.UNREADABLE, DIVIDES_BY_ZERO))
    return AnswerVerdict(Verdict.UNREADABLE, tuple(equations), choice=choice)


def _mixed(readings: Sequence[Reading], errors: tuple[Diagnostic, ...], notes: tuple[Diagnostic, ...]) -> AnswerVerdict:
    """The verdict if no single set of coordinates covers all that the answer uses."""
    equations = tuple(
        EquationVerdict(r.text, Verdict.UNREADABLE, r.error.diagnostics[0].message if r.error else MIXED_CHOICES)
        for r in readings
    )
    return AnswerVerdict(Verdict.UNREADABLE, equations, unreadable=errors, notes=notes)
