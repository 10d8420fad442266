"""Stated kinetic energies, generalized forces, first integrals and virtual displacements: are they right?

    kinetic_energy         T must have its value in every state that the constraints admit
    generalized_forces     Q_k likewise, Σ_k Q_k δq_k being the virtual work of all applied forces
    conserved              dF/dt must follow from the equations of motion; complete with all independent derived F
    virtual_displacements  A δq = 0 must have the same solutions

Each may be in the file's coordinates or in those of a choice, with a name on the left (`T = ...`, `E = ...`), and in
every notation of answers. Everything is compared with the references of equations of motion, exactly at random states.

Is the stated Hamilton's function right?

It is an expression in the coordinates, the momenta p_θ and time, or an equation `H = ...`. It must equal the derived
one, exactly; a function that differs by a constant gives the same equations, and counts as right with a remark.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.points import Point
from lagrange.answers.questions.asked_quantities import read_stated
from lagrange.answers.readings import Reading, displaced_coordinates, without_displacements
from lagrange.answers.references import Reference, ReferenceCandidate, reference_of_solution
from lagrange.answers.verdicts import (
    DIVIDES_BY_ZERO,
    MIXED_CHOICES,
    UNDECIDED,
    WORST_TO_BEST,
    AnswerVerdict,
    EquationVerdict,
    Verdict,
)
from lagrange.answers.written.decimals import as_written, remark_on, rounded_in_motion
from lagrange.answers.written.notation.plain import cleaned
from lagrange.answers.written.reading import read_as_written
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import all_hold
from lagrange.core.symbols import CONSTANT, base, partial, t, variation
from lagrange.expressions.edits import Draft
from lagrange.expressions.scope import Scope
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import Standing, agreed_in_motion, compare
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.momenta.hamiltonian import Hamiltonian
from lagrange.mechanics.results import Solution

_ORDER = (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED, Verdict.INCOMPLETE, Verdict.TRIVIAL)
_NOT_DERIVED = "the problem asks for no motion, so that there is nothing to compare it with"
_NO_COORDINATE = "`{}` is no coordinate of the file or of a choice"
_NOT_LINEAR = "an equation between virtual displacements is linear and homogeneous in them: delta(x) = ..."
_NOT_CONSTANT = "it is not constant: its rate does not vanish along every motion"
_ALWAYS_CONSTANT = "it is constant whatever the motion"
_ONLY_NAME = re.compile(
    r"\s*\$?\s*(?P<name>\\?[A-Za-zα-ωΑ-Ωℒ](?:_?\{?[A-Za-z0-9α-ω\\']*\}?){0,3}(?:\(t\))?)\s*\$?\s*\Z"
)
_EQUALS_CONSTANT = re.compile(
    r"=\s*(?:\\(?:text|mathrm|rm|mbox)\s*\{?\s*)?(?:const(?:ant|\.)?|konst\.?)\s*\}?\s*[.,]?\s*\$?\s*\Z", re.IGNORECASE
)

Judged = tuple[Verdict, str]
"""A verdict, with its diagnosis or remark."""


def check_kinetic_energy(stated: Fragment, solution: Solution) -> AnswerVerdict:
    """The verdict on a kinetic energy."""
    reference = reference_of_solution(solution)

    def differences(c: ReferenceCandidate, reading: Reading) -> list[sp.Expr]:
        return [c.read(e) - c.read(kinetic_energy(c.configuration)) for e in _values(reading)]

    part = _part(stated, stated.text, reference, lambda r: _best(reference, r, lambda c: _vanish(c, differences(c, r))))
    return _together("kinetic_energy", [part], solution)


def check_generalized_forces(stated: Mapping[str, Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on the generalized forces of some coordinates."""
    reference = reference_of_solution(solution)
    forces = {v.name: v.motion.principle.forces for v in solution.views if v.motion is not None}
    parts = []
    for name, fragment in stated.items():

        def judged(reading: Reading, name: str = name) -> Judged:
            def difference(c: ReferenceCandidate) -> Judged | None:
                names = [q.name for q in c.configuration.slots.coordinates]
                if name not in names or c.choice not in forces:
                    return None
                derived = forces[c.choice][names.index(name)]
                return _vanish(c, [c.read(e) - c.read(derived) for e in _values(reading)])

            known = {q.name for q in reference.scope.slots.coordinates}
            return (
                _best(reference, reading, difference)
                if name in known
                else (Verdict.UNREADABLE, _NO_COORDINATE.format(name))
            )

        parts.append(_part(fragment, f"{name}: {fragment.text}", reference, judged))
    return _together("generalized_forces", parts, solution)


def check_conserved_answers(stated: Sequence[Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on first integrals together; without one of the derived ones they are incomplete."""
    reference = reference_of_solution(solution)
    readings: list[Reading] = []

    def judged(reading: Reading) -> Judged:
        readings.append(reading)
        return _best(reference, reading, lambda c: _is_integral(c, _functions(reading)))

    parts = [_part(f, f.text, reference, judged) for f in stated]
    verdict = _together("conserved", parts, solution)
    if verdict.verdict is Verdict.EQUIVALENT and (missing := _missing_integrals(readings, reference, solution)):
        why = "another first integral is missing" if missing == 1 else f"{missing} more first integrals are missing"
        verdict = replace(verdict, verdict=Verdict.INCOMPLETE, missing=missing, diagnosis=why)
    return verdict


def check_virtual_displacements(stated: Sequence[Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on equations between virtual displacements."""
    reference = reference_of_solution(solution)
    readings: list[Reading] = []

    def judged(reading: Reading) -> Judged:
        readings.append(reading)
        return _best(reference, reading, lambda c: _holds_for_displacements(c, reading.components))

    parts = [_part(f, f.text, reference, judged, equations=True) for f in stated]
    verdict = _together("virtual_displacements", parts, solution)
    if verdict.verdict is Verdict.EQUIVALENT and (missing := _missing_displacements(readings, reference, solution)):
        why = "an equation is missing" if missing == 1 else f"{missing} equations are missing"
        verdict = replace(verdict, verdict=Verdict.INCOMPLETE, missing=missing, diagnosis=why)
    return verdict


def _together(name: str, parts: Sequence[EquationVerdict], solution: Solution) -> AnswerVerdict:
    if solution.own.motion is None:
        return AnswerVerdict(Verdict.UNDECIDED, name=name, diagnosis=_NOT_DERIVED)
    verdict = next((v for v in _ORDER if any(p.verdict is v for p in parts)), Verdict.EQUIVALENT)
    if all(p.verdict is Verdict.EQUIVALENT for p in parts if p.verdict is not Verdict.TRIVIAL) and len(parts) > 1:
        verdict = Verdict.EQUIVALENT if any(p.verdict is Verdict.EQUIVALENT for p in parts) else verdict
    reasons = [p.diagnosis for p in parts if p.verdict is verdict is not Verdict.EQUIVALENT]
    return AnswerVerdict(verdict, tuple(parts), name=name, diagnosis=next(filter(None, reasons), ""))


def _part(
    fragment: Fragment,
    text: str,
    reference: Reference,
    judged: Callable[[Reading], Judged],
    equations: bool = False,
) -> EquationVerdict:
    """The verdict on one statement."""
    reading = _read(fragment, reference, equations=equations)
    if reading.error is not None:
        return EquationVerdict(text, Verdict.UNREADABLE, reading.error.diagnostics[0].message)
    try:
        verdict, remark = judged(reading)
    except DivisionByZeroError:
        verdict, remark = Verdict.UNREADABLE, DIVIDES_BY_ZERO
    return EquationVerdict.of(text, verdict, remark)


def _read(fragment: Fragment, reference: Reference, *, equations: bool) -> Reading:
    """A statement as an equation: 0 = value for one without a left side, or with a name alone on it."""
    scope = reference.scope_of_answers
    text = cleaned(fragment)
    if equations:
        return read_as_written(text, scope)
    if constant := _EQUALS_CONSTANT.search(text.text):
        draft = Draft(text)
        draft.keep(0, constant.start())
        text = draft.finished(latex="\\" in text.text)
    parts = text.text.split("=")
    if len(parts) > 2:
        error = Diagnostic("unexpected-equation", "one value is expected here", fragment.whole)
        return Reading(fragment.text, error=ProblemError(error))
    if len(parts) == 2 and not _ONLY_NAME.match(parts[0]) and not _ONLY_NAME.match(parts[1]):
        return read_as_written(text, scope)
    if len(parts) == 2:
        value = (parts if _ONLY_NAME.match(parts[0]) and not _is_coordinate(parts[0], scope) else parts[::-1])[1]
        start = text.text.index(value)
        draft = Draft(text)
        draft.keep(start, start + len(value))
        text = draft.finished(latex=getattr(text, "latex", False) or "\\" in text.text)
    draft = Draft(text)
    body = draft.text.strip()
    dollars = body.startswith("$")
    at = draft.text.index("$") + 1 if dollars else 0
    draft.apply([(at, at, "0 = ")])
    return read_as_written(draft.finished(latex="\\" in body), scope, fragment.text.strip())


def _is_coordinate(text: str, scope: Scope) -> bool:
    return text.strip(" $\\") in {q.name for q in scope.slots.coordinates}


def _values(reading: Reading) -> list[sp.Expr]:
    """The value that is stated: −e for an equation 0 = value."""
    components = reading.with_decimals or reading.components
    return [-e for e in components]


def _functions(reading: Reading) -> list[sp.Expr]:
    """F, where F = const is stated."""
    return [e.xreplace({CONSTANT: sp.S.Zero}) for e in reading.with_decimals or reading.components]


def _best(reference: Reference, reading: Reading, judged: Callable[[ReferenceCandidate], Judged | None]) -> Judged:
    """The best verdict in the sets of coordinates that have those of the statement."""
    verdicts = [v for c in _candidates(reference, reading.components) if (v := judged(c)) is not None]
    return max(verdicts, key=lambda v: WORST_TO_BEST.index(v[0]), default=(Verdict.UNREADABLE, MIXED_CHOICES))


def _candidates(reference: Reference, components: Sequence[sp.Expr]) -> Iterator[ReferenceCandidate]:
    displaced = displaced_coordinates(components, reference.scope.slots.coordinates)
    used = {base(s).name for e in components for s in e.free_symbols} | {q.name for q in displaced}
    for c in reference.candidates:
        if used & reference.moving <= c.known and not c.only_for:
            yield c


def _standings(c: ReferenceCandidate, expressions: Sequence[sp.Expr]) -> tuple[Standing, ...] | None:
    result = compare([as_written(e) for e in expressions], c.system)
    return None if result is None else result.standings


def _vanish(c: ReferenceCandidate, expressions: Sequence[sp.Expr]) -> Judged:
    """Whether expressions vanish in every state that the constraints admit."""
    standings = _standings(c, expressions)
    if standings is None:
        return Verdict.UNDECIDED, UNDECIDED
    if all(s is Standing.CONSTRAINT for s in standings):
        return Verdict.EQUIVALENT, ""
    values = rounded_in_motion(expressions, c.system)
    return (Verdict.WRONG, "") if values is None else (Verdict.EQUIVALENT, remark_on(values))


_KEPT = (Standing.FOLLOWS, Standing.REDUNDANT)


def _is_integral(c: ReferenceCandidate, functions: Sequence[sp.Expr]) -> Judged:
    """Whether functions are constant along every motion, because of the equations of motion."""
    rates = [c.configuration.slots.time_derivative(c.read(f)) for f in functions]
    standings = _standings(c, rates)
    if standings is None:
        return Verdict.UNDECIDED, UNDECIDED
    if all(s is Standing.CONSTRAINT for s in standings):
        return Verdict.TRIVIAL, _ALWAYS_CONSTANT
    if all(s in (*_KEPT, Standing.CONSTRAINT) for s in standings):
        return Verdict.EQUIVALENT, ""
    values = rounded_in_motion(rates, c.system)
    return (Verdict.WRONG, _NOT_CONSTANT) if values is None else (Verdict.EQUIVALENT, remark_on(values))


def _missing_integrals(readings: Sequence[Reading], reference: Reference, solution: Solution) -> int:
    """How many derived first integrals do not depend on the stated ones."""
    derived = {v.name: v.conserved for v in solution.views if v.conserved is not None}
    counts = []
    for c in _candidates(reference, [e for r in readings for e in r.components]):
        if c.choice not in derived:
            continue
        integrals = [c.read(i.expression) for i in derived[c.choice].integrals]
        stated = [c.read(as_written(f)) for r in readings for f in _functions(r)]
        both = _rank_of_gradients([*stated, *integrals], c.configuration)
        own = _rank_of_gradients(stated, c.configuration)
        if both is not None and own is not None:
            counts.append(both - own)
    return min(counts, default=0)


def _rank_of_gradients(functions: Sequence[sp.Expr], configuration: Configuration) -> int | None:
    """The rank of gradients with respect to coordinates and velocities, modulo those of the constraints."""
    slots = configuration.slots
    state = (*slots.coordinates, *slots.velocities)
    rows = [[f.diff(s) for s in state] for f in functions]
    bound = [slots.time_derivative(f) for f in configuration.finite_constraints]
    bound += [*configuration.finite_constraints]
    fixed = [[f.diff(s) for s in state] for f in bound]

    def at(point: Point) -> int:
        return point.rank(point.matrix([*fixed, *rows])) - (point.rank(point.matrix(fixed)) if fixed else 0)

    return agreed_in_motion(configuration, at, [e for row in (*rows, *fixed) for e in row])


def _holds_for_displacements(c: ReferenceCandidate, components: Sequence[sp.Expr]) -> Judged:
    """Whether equations for virtual displacements hold for every displacement that the constraints admit."""
    read = [c.read(e) for e in components]
    parts = [without_displacements(e, c.configuration) for e in read]
    if any(part == (e,) and e != 0 for part, e in zip(parts, read, strict=True)):
        return Verdict.UNREADABLE, _NOT_LINEAR
    if all(e == 0 for e in components):
        return Verdict.TRIVIAL, "it is an identity"
    standings = _standings(c, [e for part in parts for e in part])
    if standings is None:
        return Verdict.UNDECIDED, UNDECIDED
    right = all(s is Standing.CONSTRAINT for s in standings)
    return (Verdict.EQUIVALENT, "") if right else (Verdict.WRONG, "the constraints do not require it")


def _missing_displacements(readings: Sequence[Reading], reference: Reference, solution: Solution) -> int:
    """How many independent equations are missing between the displacements of the coordinates that occur."""
    components = [e for r in readings for e in r.components]
    own = solution.own.configuration.slots.coordinates
    used = displaced_coordinates(components, reference.scope.slots.coordinates)
    columns = [variation(q) for q in sorted({*own, *used}, key=str)]
    configuration = next(c.configuration for c in _candidates(reference, components))
    freedom = next(len(v.elimination.independent) for v in solution.views if v.name == configuration.name)
    rows = [[configuration.rewritten(e.diff(d)).xreplace(dict(reference.values)) for d in columns] for e in components]

    def at(point: Point) -> int:
        return point.rank(point.matrix(rows))

    rank = agreed_in_motion(configuration, at, [e for row in rows for e in row])
    return 0 if rank is None else max(0, len(columns) - freedom - rank)


# Hamiltonian


_NO_HAMILTONIAN = "the problem does not ask for Hamilton's function"
_BY_A_CONSTANT = "it differs from the derived function by a constant, which changes no equation"
_TIME = "it differs from the derived function by a function of time, which changes no equation"
_VELOCITIES = "it contains velocities: Hamilton's function is one of coordinates and momenta"


def check_hamiltonian_answer(stated: Fragment, solution: Solution) -> AnswerVerdict:
    """The verdict on a stated Hamiltonian, in the coordinates in which it is correct, if there are any."""
    derived = [v.hamiltonian for v in solution.views if v.hamiltonian is not None]
    if not derived:
        return AnswerVerdict(Verdict.UNDECIDED, name="hamiltonian", diagnosis=_NO_HAMILTONIAN)
    reference = reference_of_solution(solution)
    try:
        scope = _scope(reference.scope, derived, frozenset(solution.problem.scope.names()))
        claim, _ = read_stated(stated, scope, "H")
        if claim is None:
            message = "this is an equation, not an expression for Hamilton's function"
            help_ = "write the expression, or `H = ...`"
            raise ProblemError(Diagnostic("unexpected-equation", message, stated.whole, help=help_))
    except ProblemError as error:
        part = EquationVerdict(stated.text, Verdict.UNREADABLE, error.diagnostics[0].message)
        return AnswerVerdict(Verdict.UNREADABLE, (part,), unreadable=tuple(error.diagnostics), name="hamiltonian")
    order = (Verdict.EQUIVALENT, Verdict.UNDECIDED, Verdict.WRONG, Verdict.UNREADABLE)
    verdict, remark = min((_verdict(claim, d, reference) for d in derived), key=lambda pair: order.index(pair[0]))
    return AnswerVerdict(verdict, (EquationVerdict.of(stated.text, verdict, remark),), name="hamiltonian")


def _verdict(claim: sp.Expr, derived: Hamiltonian, reference: Reference) -> tuple[Verdict, str]:
    """The verdict on an expression, with a remark or a diagnosis."""
    slots, states = derived.configuration.slots, derived.configuration.states
    if claim.free_symbols & {*slots.velocities, *slots.accelerations}:
        return Verdict.WRONG, _VELOCITIES
    by_momenta = dict(zip(derived.momenta, derived.energies.momenta, strict=True))
    difference = (claim - derived.function).xreplace(dict(reference.values))

    def vanish(expressions: Sequence[sp.Expr]) -> bool | None:
        return all_hold(states.is_zero(e.xreplace(by_momenta)) for e in expressions)

    try:
        if (same := vanish([difference])) is not False:
            return (Verdict.EQUIVALENT, "") if same else (Verdict.UNDECIDED, UNDECIDED)
        same = vanish([partial(difference, s) for s in (*slots.coordinates, *derived.momenta)])
    except DivisionByZeroError:
        return Verdict.UNREADABLE, DIVIDES_BY_ZERO
    if same:
        return Verdict.EQUIVALENT, _TIME if difference.has(t) else _BY_A_CONSTANT
    if same is None:
        return Verdict.UNDECIDED, UNDECIDED
    return Verdict.WRONG, _explained(claim, derived, lambda e: vanish([e - derived.function]) is True)


def _explained(claim: sp.Expr, derived: Hamiltonian, right: Callable[[sp.Expr], bool]) -> str:
    """A sentence that identifies a wrong function; empty if it is not recognised."""
    from lagrange.answers.models.letters import letter_variations
    from lagrange.answers.models.questions import explained_value

    slots = derived.configuration.slots
    moving = derived.function.free_symbols & {*derived.momenta}
    potential = derived.function.xreplace(dict.fromkeys(derived.momenta, sp.S.Zero))
    if moving and right(claim + 2 * potential) and potential != 0:
        return "this is T - V in the momenta: the Lagrangian, and not T + V"
    if why := explained_value(claim, derived.function, {*slots.coordinates, *derived.momenta}):
        return why
    for change in letter_variations([claim], [derived.function], slots, derived.momenta):
        if change.rule and right(claim.xreplace(dict(change.rule))):
            return f"this is the function {change.clause}"
    return ""


def _scope(scope: Scope, derived: Sequence[Hamiltonian], declared: frozenset[str]) -> Scope:
    """The names that an answer may use, with the momenta, and without the derived H unless the file has one."""
    momenta = {p.name: p for d in derived for p in d.momenta}
    momenta |= {n.replace("phi", "varphi"): p for n, p in momenta.items() if n.startswith("p_phi")}
    if len(momenta) == 1 and "p" not in declared:
        momenta |= {"p": next(iter(momenta.values()))}
    return replace(scope, scalars={n: e for n, e in scope.scalars.items() if n != "H" or n in declared} | momenta)
