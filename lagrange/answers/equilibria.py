"""Somebody else's equilibria: are they right, and all of them?

An answer is a system of equations, or several alternative ones: nested lists in a file, `theta = 0 or theta = pi` in
one equation. It means the set of positions (and unknown forces) that satisfy one of the alternatives, and is compared
as a set of points with the equilibria of a configuration:

    right       every solution of each alternative satisfies the conditions of equilibrium
    complete    every equilibrium satisfies one of the alternatives

Both sides are solved (`branching`) and substituted into the other, exactly. Angles count modulo 2π: θ = π means
(cos θ, sin θ) = (−1, 0). What has no closed form is compared by its factors, or on the surfaces that the equations
define. In θ = atan(u) the principal value is meant; if that leaves something out, the answer is also read as tan θ = u.
The file's coordinates and every choice are tried, and the best verdict counts.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.polynomial_roots import factors, numerator
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet, parameters_given
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR, NotAlgebraicError, TrigLetters
from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface, is_zero
from lagrange.answers.limits import MAX_ALTERNATIVES, MAX_EQUATIONS
from lagrange.answers.readings import Reading, read_answer
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import (
    DIVIDES_BY_ZERO,
    MIXED_CHOICES,
    NOT_JUDGED,
    UNDECIDED,
    WORST_TO_BEST,
    AnswerVerdict,
    EquationVerdict,
    Verdict,
)
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.document.math_writer import text
from lagrange.expressions.latex_layout import ALTERNATIVE, is_latex, piece
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, is_balanced

RESTATED = "it restates a constraint"
_ALL_ANGLES = "only one of the angles with this tangent, sine or cosine is given; all of them are taken to be meant"


@record
class _Alternative:
    """One system of an answer in the coordinates of a candidate.

    readings    its equations as they were written
    equations   each is zero; those that give an angle are left to `angles`
    angles      the angle that an equation θ = α gives
    """

    readings: tuple[Reading, ...]
    equations: tuple[tuple[sp.Expr, ...], ...]
    angles: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)


@record
class _Judged:
    """The verdict on one alternative.

    right     whether all its solutions are equilibria; None: undecided
    covered   numbers of the equilibria that satisfy it
    loose     whether it leaves open what the conditions determine, because equations are missing
    """

    right: bool | None
    covered: frozenset[int]
    loose: bool
    verdicts: tuple[EquationVerdict, ...]


class EquilibriumComparison:
    """An answer against the equilibria of one configuration.

    points    the equilibria in closed form, each with the number of its branch
    branches  those that exist for all parameters, or all if there are none
    left      branches not known in closed form
    """

    def __init__(
        self, e: Equilibrium, values: Mapping[sp.Symbol, sp.Expr], systems: Sequence[Sequence[Sequence[sp.Expr]]]
    ) -> None:
        self.equilibrium = e
        self.surface = e.configuration.surface
        # A given position satisfies its constraints, which are then no equations for the forces.
        finite = () if e.given else e.configuration.finite_constraints
        self.rows = tuple(f.xreplace(dict(values)) for f in finite)
        self.conditions = (*(c.expression.xreplace(dict(values)) for c in e.conditions), *self.rows)
        self.unknowns = e.forces if e.given else (*e.configuration.slots.coordinates, *e.forces)
        self.forces = e.forces
        forces = (*e.work.forces, *(c.expression for c in e.conditions))
        self.angles = frozenset(u for u in self.unknowns if _is_angle(u, forces, self.rows))
        self.values = dict(values)
        solution = e.solution
        asked = [x for a in systems for es in a for x in es]
        # cos θ/2 is no rational function of cos θ and sin θ: if the answer has half angles, the conditions are solved
        # again with letters for these.
        half = _parts_of_angles(asked, self.angles) > _parts_of_angles(solution.equations, self.angles)
        if values or half:
            solution = solutions(
                [x.xreplace(self.values) for x in solution.equations],
                solution.unknowns,
                [u for u in solution.unknowns if u not in e.configuration.slots.coordinates],
                beside=asked,
            )
        self.solution = solution
        # Equilibria for particular parameters only need not be in an answer.
        generic = [b for b in solution.branches if not b.special]
        branches = generic or list(solution.branches)
        self.points = self._distinct([(n, p) for n, b in enumerate(branches) for p in _points(b, self.unknowns)])
        self.left = [b for b in branches if b.left]
        self.branches = branches

    def _distinct(self, points: list[tuple[int, Values]]) -> list[tuple[int, Values]]:
        """The points without repetition modulo whole turns: θ/2 and θ/2 + π are the same θ."""
        if all(a.measure == u for u, a in self.solution.letters.angles.items() if u in self.angles):
            return points
        kept: list[tuple[int, Values]] = []
        for n, p in points:
            if not any(self._same(p, q) for _, q in kept):
                kept.append((n, p))
        return kept

    def _same(self, p: Values, q: Values) -> bool:
        """Whether two points are the same position with the same forces, angles modulo whole turns."""
        for u in self.unknowns:
            for f in (sp.cos(u), sp.sin(u)) if u in self.angles else (u,):
                if not is_zero(self.solution.at(p, f) - self.solution.at(q, f)):
                    return False
        return True

    def verdict(
        self, readings: Sequence[Sequence[Reading]], systems: Sequence[Sequence[Sequence[sp.Expr]]]
    ) -> AnswerVerdict:
        """The verdict on the alternatives together."""
        judged = []
        for reading, system in zip(readings, systems, strict=True):
            try:
                judged.append(self._judged(self._alternative(tuple(reading), system)))
            except DivisionByZeroError:
                unreadable = (EquationVerdict(r.text, Verdict.UNREADABLE, DIVIDES_BY_ZERO) for r in reading)
                return AnswerVerdict(Verdict.UNREADABLE, tuple(unreadable))
        equations = tuple(v for j in judged for v in j.verdicts)
        verdicts = [v.verdict for v in equations]
        if Verdict.WRONG in verdicts:
            return AnswerVerdict(Verdict.WRONG, equations)
        if all(v is Verdict.TRIVIAL for v in verdicts):
            return AnswerVerdict(Verdict.TRIVIAL, equations)
        if Verdict.UNDECIDED in verdicts or any(j.right is None for j in judged):
            return AnswerVerdict(Verdict.UNDECIDED, equations)
        if any(j.loose for j in judged):
            return AnswerVerdict(Verdict.INCOMPLETE, equations, missing=1)
        missing = set(range(len(self.points))).difference(*(j.covered for j in judged))
        uncovered = {self.points[n][0] for n in missing}
        if self.left and not any(self._has_unsolved(s) for s in systems):
            uncovered |= {self.branches.index(b) for b in self.left}
        if uncovered:
            return AnswerVerdict(Verdict.INCOMPLETE, equations, missing=len(uncovered))
        return AnswerVerdict(Verdict.EQUIVALENT, equations)

    def _has_unsolved(self, system: Sequence[Sequence[sp.Expr]]) -> bool:
        """Whether an alternative includes the solutions that are not known in closed form."""
        own = {x for es in system for e in es for x in self._canonical(e)}
        return bool(self._unsolved) and self._unsolved <= own

    @cached_property
    def _unsolved(self) -> set[sp.Expr]:
        """The factors of the equations that are not solved in closed form."""
        return {x for b in self.left for e in b.left for x in self._canonical(e)}

    def _canonical(self, e: sp.Expr) -> list[sp.Expr]:
        """The factors of an equation that contain an unknown, up to sign."""
        letters = TrigLetters([e, *self.conditions], self.unknowns)
        try:
            parts = numerator(letters.read(e))
        except NotAlgebraicError:
            parts = numerator(e)
        pieces = factors(letters.reduced(parts[0])) if parts else None
        own = [p for p in pieces or [e] if letters.unknowns_in(p)]
        return [letters.write(-p if p.could_extract_minus_sign() else p) for p in own]

    def _alternative(self, readings: tuple[Reading, ...], system: Sequence[Sequence[sp.Expr]]) -> _Alternative:
        """The alternative, with the equations that give angles set apart."""
        angles: dict[sp.Symbol, sp.Expr] = {}
        equations = []
        for es in system:
            kept = []
            for e in es:
                given = self._given_angle(e)
                if given is not None and given[0] not in angles:
                    angles[given[0]] = given[1]
                else:
                    kept.append(self._on_circle(e))
            equations.append(tuple(kept))
        return _Alternative(readings, tuple(equations), angles)

    def _given_angle(self, e: sp.Expr) -> tuple[sp.Symbol, sp.Expr] | None:
        """θ, α if the equation is θ = α and α contains no unknown."""
        for u in sorted(self.angles & e.free_symbols, key=str):
            rate = e.diff(u)
            if rate.is_Rational and rate != 0:
                angle = sp.expand(u - e / rate)
                if not angle.free_symbols & {*self.unknowns}:
                    return u, angle
        return None

    def _on_circle(self, e: sp.Expr) -> sp.Expr:
        """θ1 = θ2 as cos(θ1 − θ2) = 1, if angles occur outside sines and cosines."""
        inside = {s for f in e.atoms(*CIRCULAR) for s in f.free_symbols}
        bare = sorted((self.angles & e.free_symbols) - inside, key=str)
        rates = [e.diff(u) for u in bare]
        if not bare or not all(r.is_Rational and r != 0 for r in rates):
            return e
        return sp.cos(sp.expand(e / rates[0])) - 1

    def _judged(self, a: _Alternative) -> _Judged:
        rest = [x for es in a.equations for x in es]
        covered = frozenset(n for n, (_, p) in enumerate(self.points) if self._holds(p, rest, a.angles))
        _, given = parameters_given(rest, self.unknowns)
        verdicts = [self._of_one(r, es, a, bool(given)) for r, es in zip(a.readings, a.equations, strict=True)]
        if any(v.verdict is Verdict.WRONG for v in verdicts):
            return _Judged(False, covered, False, tuple(verdicts))
        if all(v.verdict is Verdict.TRIVIAL or RESTATED in v.remarks for v in verdicts):
            return _Judged(False, covered, True, tuple(verdicts))
        right, loose, why = self._right(rest, a.angles)
        if right is False and not loose:
            # The solutions include points that are no equilibria: then no equation is right, not even one that may hold
            # at equilibria that are not known.
            open_verdicts = (Verdict.EQUIVALENT, Verdict.UNDECIDED)
            verdicts = [
                replace(v, verdict=Verdict.WRONG, diagnosis=why) if v.verdict in open_verdicts else v for v in verdicts
            ]
        if right is None:
            verdicts = [
                replace(v, verdict=Verdict.UNDECIDED, diagnosis=UNDECIDED) if v.verdict is Verdict.EQUIVALENT else v
                for v in verdicts
            ]
        return _Judged(right, covered, loose and right is not None, tuple(verdicts))

    def _holds(self, point: Values, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr]) -> bool | None:
        """Whether equations hold at an equilibrium; None: undecided."""
        residuals = [*equations]
        for u, angle in angles.items():
            residuals += [sp.cos(u) - sp.cos(angle), sp.sin(u) - sp.sin(angle)]
        verdicts = []
        for e in residuals:
            try:
                value = self.solution.at(point, e)
                verdicts.append(False if value.has(sp.zoo, sp.nan, sp.oo) else self._vanishes(value))
            except (NotAlgebraicError, DivisionByZeroError):
                verdicts.append(None)
        return False if False in verdicts else None if None in verdicts else True

    def _vanishes(self, e: sp.Expr) -> bool | None:
        """Whether an expression is zero; if the position is given, at all positions that the constraints admit."""
        return self.surface.is_zero(e) if self.equilibrium.given else is_zero(e)

    def _of_one(self, reading: Reading, equations: Sequence[sp.Expr], a: _Alternative, given: bool) -> EquationVerdict:
        """The verdict on one equation: whether it holds at some equilibrium.

        given  the alternative is one for particular values of parameters, which are judged with the whole
        """
        text = reading.text
        if not equations:  # it gives an angle
            angles = {
                u: v for u, v in a.angles.items() if any(u in e.free_symbols for e in reading.components)
            } or a.angles
            return self._somewhere(text, (), angles, given)
        constraint = [self.surface.is_zero(e) for e in equations]
        if all(constraint):
            if all(is_zero(e) for e in equations):
                return EquationVerdict(text, Verdict.TRIVIAL, "it is an identity, true for every position")
            return EquationVerdict(text, Verdict.EQUIVALENT, remarks=(RESTATED,))
        if not any(e.free_symbols & {*self.unknowns} for e in equations):
            return EquationVerdict(text, Verdict.EQUIVALENT)  # in parameters only: judged with the others
        return self._somewhere(text, equations, {}, given)

    def _somewhere(
        self, text: str, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr], given: bool
    ) -> EquationVerdict:
        if given:
            return EquationVerdict(text, Verdict.EQUIVALENT)
        verdicts = [self._holds(p, equations, angles) for _, p in self.points]
        if True in verdicts:
            return EquationVerdict(text, Verdict.EQUIVALENT)
        if self.left and self._unsolved & {x for e in equations for x in self._canonical(e)}:
            return EquationVerdict(text, Verdict.EQUIVALENT)
        if None in verdicts or self.left:
            return EquationVerdict(text, Verdict.UNDECIDED, UNDECIDED)
        return EquationVerdict(text, Verdict.WRONG, "it holds in no position of equilibrium")

    def _right(
        self, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr]
    ) -> tuple[bool | None, bool, str]:
        """Whether all solutions of the equations are equilibria; whether equations are missing; what is wrong."""
        equations, values = parameters_given(equations, self.unknowns)
        conditions = [c.xreplace(values) for c in self.conditions]
        rows = [r.xreplace(values) for r in self.rows]
        try:
            own = solutions([*equations, *rows], self.unknowns, self.forces, known=angles, beside=conditions)
        except NotAlgebraicError:
            return None, False, ""
        if own.solved:
            if not own.branches:
                return False, False, "together with the constraints it can hold nowhere"
            return self._solutions_right(own, values)
        if self._same_factors(equations):
            return True, False, ""
        if len(equations) + len(angles) < len(self.conditions) - len(self.rows):
            return False, True, ""
        surface = Surface([*equations, *rows], self.unknowns)
        verdicts = [surface.is_zero(c) for c in conditions]
        if angles or None in verdicts:
            return None, False, ""
        return (True, False, "") if all(verdicts) else (False, False, "it has solutions that are not equilibria")

    def _same_factors(self, equations: Sequence[sp.Expr]) -> bool:
        """Whether the equations have the same factors as the conditions of equilibrium."""
        own = {x for e in equations for x in self._canonical(e)}
        return bool(own) and own == {x for e in self.conditions for x in self._canonical(e)}

    def _solutions_right(self, own: SolutionSet, values: Values) -> tuple[bool | None, bool, str]:
        """As `_right`, for an alternative that is solved in closed form.

        A solution that is no equilibrium but leaves more unknowns open than an equilibrium does may contain equilibria:
        then equations are missing rather than wrong.
        """
        verdict: bool | None = own.verified
        loose = False
        least = min((self._open(p, self.solution) for _, p in self.points), default=0)
        for b in own.branches:
            for p in b.points:
                holds = self._is_balanced(own, p, values)
                if holds:
                    continue
                if holds is None:
                    verdict = None
                elif self._open(p, own) > least:
                    loose = True
                else:
                    return False, False, f"it also holds where {_stated(b)}, which is not an equilibrium"
        return (False if loose else verdict), loose, ""

    def _is_balanced(self, own: SolutionSet, point: Values, values: Values) -> bool | None:
        """Whether a solution of the answer is an equilibrium; None: undecided."""

        def at(e: sp.Expr) -> sp.Expr:
            value = own.at(point, e.xreplace(self.values).xreplace(dict(values)))
            if value.has(sp.zoo, sp.nan, sp.oo):
                raise DivisionByZeroError(e)
            return value

        try:
            if not self.equilibrium.given:
                return is_balanced(self.equilibrium, at)
            verdicts = [self._vanishes(at(c.expression)) for c in self.equilibrium.conditions]
            return False if False in verdicts else None if None in verdicts else True
        except DivisionByZeroError:
            return False
        except NotAlgebraicError:
            return None

    def _open(self, point: Values, solution: SolutionSet) -> int:
        """How many unknowns a point leaves open."""
        letters = solution.letters
        own = [letters.angles[u].cosine if u in letters.angles else u for u in self.unknowns]
        return sum(letter not in point for letter in own)


def _points(b: Branch, unknowns: Sequence[sp.Symbol]) -> list[Values]:
    """The points of a branch in closed form; a relation between parameters gives one of them a value."""
    if b.left:
        return []
    given: Values = {}
    if b.special:
        _, given = parameters_given([r.residual for r in b.relations], unknowns)
    return [{**p, **given} for p in b.points]


def _stated(b: Branch) -> str:
    return " and ".join(f"{text(r.lhs)} = {text(r.rhs)}" for r in b.relations) or "nothing is determined"


def _is_angle(u: sp.Symbol, forces: Sequence[sp.Expr], rows: Sequence[sp.Expr]) -> bool:
    """Whether an unknown occurs in sines and cosines, and the forces depend on it in no other way."""
    if not any(u in f.free_symbols for e in (*forces, *rows) for f in e.atoms(*CIRCULAR)):
        return False
    outside = (e.xreplace({f: sp.Dummy() for f in e.atoms(*CIRCULAR)}) for e in forces)
    return not any(u in e.free_symbols for e in outside)


def _parts_of_angles(expressions: Sequence[sp.Expr], angles: frozenset[sp.Symbol]) -> int:
    """The largest n for which θ/n occurs."""
    letters = TrigLetters(expressions, tuple(angles))
    return max((int((u / letters.angles[u].measure)) for u in angles if u in letters.angles), default=1)


_INVERSE: dict[type, Callable[[sp.Expr], sp.Expr]] = {sp.atan: sp.tan, sp.acos: sp.cos, sp.asin: sp.sin}


def alternatives_of(answer: Sequence[Fragment]) -> list[tuple[Fragment, ...]]:
    """The alternatives of a flat list in which an equation may read `theta = 0 or theta = pi`.

    Raises ProblemError if there are too many.
    """
    parts = [_split(f) for f in answer]
    total = 1
    for p in parts:
        total *= len(p)
    if total > MAX_ALTERNATIVES:
        message = f"an answer may have {MAX_ALTERNATIVES} alternatives, and this one has {total}"
        raise ProblemError(Diagnostic("too-many-equations", message, answer[0].whole))
    return [tuple(choice) for choice in product(*parts)]


def _split(fragment: Fragment) -> list[Fragment]:
    latex = is_latex(fragment)
    parts, start = [], 0
    for match in [*re.finditer(ALTERNATIVE if latex else r"(?<![\w\\])or(?![\w'])", fragment.text), None]:
        end = match.start() if match else len(fragment.text)
        begin = None if fragment.start is None else fragment.start + start
        text = fragment.text[start:end].strip()
        parts.append(piece(fragment, start, end) if latex else replace(fragment, text=text, start=begin))
        start = match.end() if match else end
    return parts


def check_equilibria(
    alternatives: Sequence[Sequence[Fragment]], equilibria: Sequence[Equilibrium], reference: Reference
) -> AnswerVerdict:
    """The verdict on an answer; `equilibria` are those in the file's coordinates and in each choice.

    Raises ProblemError if there are no equations, or too many.
    """
    flat = [f for a in alternatives for f in a]
    if not flat:
        raise ProblemError(
            Diagnostic("no-answer", "there is no equation to check", help="give equations with -e, or in a file")
        )
    if len(alternatives) > MAX_ALTERNATIVES or any(len(a) > MAX_EQUATIONS for a in alternatives):
        message = f"an answer may have {MAX_EQUATIONS} equations"
        raise ProblemError(Diagnostic("too-many-equations", message, flat[0].whole))
    readings = [tuple(read_answer(f, reference.scope) for f in a) for a in alternatives]
    notes = tuple(n for a in readings for r in a for n in r.notes)
    errors = tuple(d for a in readings for r in a if r.error for d in r.error.diagnostics)
    if errors:
        return _unreadable(readings, errors, notes)
    solved = [e for e in equilibria if e.branches] or equilibria
    tried = [v for e in solved if (v := _tried(readings, e, reference)) is not None]
    if not tried:
        equations = tuple(EquationVerdict(r.text, Verdict.UNREADABLE, MIXED_CHOICES) for a in readings for r in a)
        return AnswerVerdict(Verdict.UNREADABLE, equations, notes=notes)
    return replace(max(tried, key=lambda v: WORST_TO_BEST.index(v.verdict)), notes=notes)


def _unreadable(
    readings: Sequence[Sequence[Reading]], errors: tuple[Diagnostic, ...], notes: tuple[Diagnostic, ...]
) -> AnswerVerdict:
    equations = tuple(
        EquationVerdict(r.text, Verdict.UNREADABLE, r.error.diagnostics[0].message)
        if r.error
        else EquationVerdict(r.text, Verdict.UNDECIDED, NOT_JUDGED)
        for a in readings
        for r in a
    )
    return AnswerVerdict(Verdict.UNREADABLE, equations, unreadable=errors, notes=notes)


def _tried(
    readings: Sequence[Sequence[Reading]], equilibrium: Equilibrium, reference: Reference
) -> AnswerVerdict | None:
    """The verdict in one set of coordinates; None if the answer uses others."""
    configuration = equilibrium.configuration
    used = {s.name for a in readings for r in a for e in r.components for s in e.free_symbols}
    known = {s.name for s in (*configuration.slots.coordinates, *configuration.expressed)}
    if not used & {q.name for q in reference.scope.slots.coordinates} <= known:
        return None
    values = dict(reference.values)
    systems = [[tuple(configuration.rewritten(e).xreplace(values) for e in r.components) for r in a] for a in readings]
    literal = EquilibriumComparison(equilibrium, values, systems).verdict(readings, systems)
    wider = [[tuple(_widened(e) for e in es) for es in a] for a in systems]
    if literal.verdict is Verdict.EQUIVALENT or wider == systems:
        return literal
    read_wider = EquilibriumComparison(equilibrium, values, wider).verdict(readings, wider)
    if WORST_TO_BEST.index(read_wider.verdict) <= WORST_TO_BEST.index(literal.verdict):
        return literal
    equations = tuple(
        replace(v, remarks=(*v.remarks, _ALL_ANGLES)) if old != new else v
        for v, old, new in zip(
            read_wider.equations,
            [es for a in systems for es in a],
            [es for a in wider for es in a],
            strict=True,
        )
    )
    return replace(read_wider, equations=equations)


def _widened(e: sp.Expr) -> sp.Expr:
    """θ − atan(u) as tan θ − u."""
    terms = sp.Add.make_args(e)
    if len(terms) != 2:
        return e
    for angle, other in (terms, terms[::-1]):
        c, inverse = other.as_coeff_Mul()
        d, theta = angle.as_coeff_Mul()
        function = _INVERSE.get(type(inverse))
        if theta.is_Symbol and function is not None and abs(c) == abs(d):
            return function(theta) - function(-c / d * inverse)
    return e
