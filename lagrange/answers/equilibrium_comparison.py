"""An answer against the equilibria of one configuration, as sets of points.

    right       every solution of each alternative satisfies the conditions of equilibrium
    complete    every equilibrium satisfies one of the alternatives

Both sides are solved (`branching`) and put into the other, exactly. Angles count modulo 2π: θ = π says that
(cos θ, sin θ) = (−1, 0). What is not solved in closed form is compared by its factors, or on the surfaces that the
equations cut out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.closed_form import Values
from lagrange.algebra.closed_forms.polynomial_roots import factors, numerator
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet, parameters_given
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR, Letters, NotAlgebraicError
from lagrange.algebra.exact.exact import DivisionByZeroError, Surface, is_zero
from lagrange.answers.answer_readings import Reading
from lagrange.answers.equations import AnswerVerdict, EquationVerdict, Verdict
from lagrange.core.records import record
from lagrange.document.math_writer import text
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, is_balanced

RESTATED = "it restates a constraint"


@record
class _Alternative:
    """One system of an answer in the coordinates of a candidate.

    readings    its equations as they were written
    equations   each is zero; those that give an angle are in `angles`
    """

    readings: tuple[Reading, ...]
    equations: tuple[tuple[sp.Expr, ...], ...]
    angles: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)


@record
class _Judged:
    """What is said of one alternative.

    right     all its solutions are equilibria; None: undecided
    covered   numbers of the equilibria that satisfy it
    loose     it leaves open what the conditions determine: equations are missing
    """

    right: bool | None
    covered: frozenset[int]
    loose: bool
    verdicts: tuple[EquationVerdict, ...]


class EquilibriumComparison:
    """An answer against the equilibria of one configuration."""

    def __init__(
        self, e: Equilibrium, values: Mapping[sp.Symbol, sp.Expr], systems: Sequence[Sequence[Sequence[sp.Expr]]]
    ) -> None:
        self.equilibrium = e
        self.surface = e.configuration.surface
        # A given position satisfies its constraints: they are no equations for the forces.
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
        half = _parts_of_angles(asked, self.angles) > _parts_of_angles(solution.equations, self.angles)
        if values or half:
            solution = solutions(
                [x.xreplace(self.values) for x in solution.equations],
                solution.unknowns,
                [u for u in solution.unknowns if u not in e.configuration.slots.coordinates],
                beside=asked,
            )
        self.solution = solution
        generic = [b for b in solution.branches if not b.special]
        branches = generic or list(solution.branches)
        self.points = self._distinct([(n, p) for n, b in enumerate(branches) for p in _points(b, self.unknowns)])
        self.left = [b for b in branches if b.left]
        self.branches = branches

    def _distinct(self, points: list[tuple[int, Values]]) -> list[tuple[int, Values]]:
        """Points that differ by whole turns are one: those of θ/2 and θ/2 + π."""
        if all(a.measure == u for u, a in self.solution.letters.angles.items() if u in self.angles):
            return points
        kept: list[tuple[int, Values]] = []
        for n, p in points:
            if not any(self._same(p, q) for _, q in kept):
                kept.append((n, p))
        return kept

    def _same(self, p: Values, q: Values) -> bool:
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
                found = tuple(
                    EquationVerdict(r.text, Verdict.UNREADABLE, "it divides by what is exactly zero") for r in reading
                )
                return AnswerVerdict(Verdict.UNREADABLE, found)
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
        if self.left and not any(self._stands_for_left(s) for s in systems):
            uncovered |= {self.branches.index(b) for b in self.left}
        if uncovered:
            return AnswerVerdict(Verdict.INCOMPLETE, equations, missing=len(uncovered))
        return AnswerVerdict(Verdict.EQUIVALENT, equations)

    def _stands_for_left(self, system: Sequence[Sequence[sp.Expr]]) -> bool:
        """Whether an alternative has the solutions that are not known in closed form."""
        own = [x for es in system for x in es]
        mine = {x for e in own for x in self._canonical(e)}
        wanted = {x for b in self.left for e in b.left for x in self._canonical(e)}
        return bool(wanted) and wanted <= mine

    def _canonical(self, e: sp.Expr) -> list[sp.Expr]:
        """The factors of an equation that contain an unknown, without their sign."""
        letters = Letters([e, *self.conditions], self.unknowns)
        try:
            parts = numerator(letters.read(e))
        except NotAlgebraicError:
            parts = numerator(e)
        pieces = factors(letters.reduced(parts[0])) if parts else None
        found = [p for p in pieces or [e] if letters.unknowns_in(p)]
        return [letters.write(-p if p.could_extract_minus_sign() else p) for p in found]

    def _alternative(self, readings: tuple[Reading, ...], system: Sequence[Sequence[sp.Expr]]) -> _Alternative:
        """The system with the equations that give angles apart."""
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
        """θ, α where the equation is θ = α and α contains no unknown."""
        for u in sorted(self.angles & e.free_symbols, key=str):
            rate = e.diff(u)
            if rate.is_Rational and rate != 0:
                angle = sp.expand(u - e / rate)
                if not angle.free_symbols & {*self.unknowns}:
                    return u, angle
        return None

    def _on_circle(self, e: sp.Expr) -> sp.Expr:
        """θ1 = θ2 as cos(θ1 − θ2) = 1, where angles stand outside sines and cosines."""
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
        verdicts = [self._of_one(r, es, a, given) for r, es in zip(a.readings, a.equations, strict=True)]
        if any(v.verdict is Verdict.WRONG for v in verdicts):
            return _Judged(False, covered, False, tuple(verdicts))
        if all(v.verdict is Verdict.TRIVIAL or RESTATED in v.remarks for v in verdicts):
            return _Judged(False, covered, True, tuple(verdicts))
        right, loose, why = self._right(rest, a.angles)
        if right is False and not loose:
            # whether an equation holds at equilibria that are not known is of no matter where it holds elsewhere
            undone = (Verdict.EQUIVALENT, Verdict.UNDECIDED)
            verdicts = [
                replace(v, verdict=Verdict.WRONG, diagnosis=why) if v.verdict in undone else v for v in verdicts
            ]
        if right is None:
            verdicts = [
                replace(v, verdict=Verdict.UNDECIDED, diagnosis="it could not be decided whether it is right")
                if v.verdict is Verdict.EQUIVALENT
                else v
                for v in verdicts
            ]
        return _Judged(right, covered, loose and right is not None, tuple(verdicts))

    def _holds(self, point: Values, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr]) -> bool | None:
        """Whether equations hold at an equilibrium."""
        residuals = [*equations]
        for u, angle in angles.items():
            residuals += [sp.cos(u) - sp.cos(angle), sp.sin(u) - sp.sin(angle)]
        verdicts = []
        for e in residuals:
            try:
                there = self.solution.at(point, e)
                verdicts.append(False if there.has(sp.zoo, sp.nan, sp.oo) else self._vanishes(there))
            except (NotAlgebraicError, DivisionByZeroError):
                verdicts.append(None)
        return False if False in verdicts else None if None in verdicts else True

    def _vanishes(self, e: sp.Expr) -> bool | None:
        """Whether an expression is zero; where the position is given, at all that the constraints admit."""
        return self.surface.is_zero(e) if self.equilibrium.given else is_zero(e)

    def _of_one(
        self, reading: Reading, equations: Sequence[sp.Expr], a: _Alternative, given: Values
    ) -> EquationVerdict:
        """The verdict on one equation: whether it holds at some equilibrium."""
        text = reading.text
        if not equations:  # it gives an angle
            angles = {
                u: v for u, v in a.angles.items() if any(u in e.free_symbols for e in reading.components)
            } or a.angles
            return self._somewhere(text, (), angles, given)
        constraint = [self.surface.is_zero(e) for e in equations]
        if all(constraint):
            if all(is_zero(e) for e in equations):
                return EquationVerdict(text, Verdict.TRIVIAL, "it is an identity, true of every position")
            return EquationVerdict(text, Verdict.EQUIVALENT, remarks=(RESTATED,))
        if not any(e.free_symbols & {*self.unknowns} for e in equations):
            return EquationVerdict(text, Verdict.EQUIVALENT)  # of parameters: judged with the others
        return self._somewhere(text, equations, {}, given)

    def _somewhere(
        self, text: str, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr], given: Values
    ) -> EquationVerdict:
        if given:
            return EquationVerdict(text, Verdict.EQUIVALENT)  # for particular parameters: judged with the others
        verdicts = [self._holds(p, equations, angles) for _, p in self.points]
        if True in verdicts:
            return EquationVerdict(text, Verdict.EQUIVALENT)
        if self.left:
            wanted = {x for b in self.left for e in b.left for x in self._canonical(e)}
            if wanted & {x for e in equations for x in self._canonical(e)}:
                return EquationVerdict(text, Verdict.EQUIVALENT)
        if None in verdicts or self.left:
            return EquationVerdict(text, Verdict.UNDECIDED, "it could not be decided whether it is right")
        return EquationVerdict(text, Verdict.WRONG, "it holds in no position of equilibrium")

    def _right(
        self, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr]
    ) -> tuple[bool | None, bool, str]:
        """Whether all solutions of the equations are equilibria; whether they leave something open; why not."""
        equations, values = parameters_given(equations, self.unknowns)
        conditions = [c.xreplace(values) for c in self.conditions]
        rows = [r.xreplace(values) for r in self.rows]
        try:
            found = solutions([*equations, *rows], self.unknowns, self.forces, known=angles, beside=conditions)
        except NotAlgebraicError:
            return None, False, ""
        if found.solved:
            if not found.branches:
                return False, False, "together with the constraints it can hold nowhere"
            return self._solutions_right(found, values)
        if self._same_factors(equations):
            return True, False, ""
        if len(equations) + len(angles) < len(self.conditions) - len(self.rows):
            return False, True, ""
        surface = Surface([*equations, *rows], self.unknowns)
        verdicts = [surface.is_zero(c) for c in conditions]
        if angles or None in verdicts:
            return None, False, ""
        return (True, False, "") if all(verdicts) else (False, False, "it has other solutions than equilibria")

    def _same_factors(self, equations: Sequence[sp.Expr]) -> bool:
        mine = {x for e in equations for x in self._canonical(e)}
        wanted = {x for e in self.conditions for x in self._canonical(e)}
        return bool(mine) and mine == wanted

    def _solutions_right(self, found: SolutionSet, values: Values) -> tuple[bool | None, bool, str]:
        verdict: bool | None = found.verified
        loose = False
        least = min((self._open(p, self.solution) for _, p in self.points), default=0)
        for b in found.branches:
            for p in b.points:
                holds = self._is_balanced(found, p, values)
                if holds:
                    continue
                if holds is None:
                    verdict = None
                elif self._open(p, found) > least:
                    loose = True
                else:
                    return False, False, f"it also holds where {_stated(b)}, which is no equilibrium"
        return (False if loose else verdict), loose, ""

    def _is_balanced(self, found: SolutionSet, point: Values, values: Values) -> bool | None:
        def at(e: sp.Expr) -> sp.Expr:
            there = found.at(point, e.xreplace(self.values).xreplace(dict(values)))
            if there.has(sp.zoo, sp.nan, sp.oo):
                raise DivisionByZeroError(e)
            return there

        try:
            if not self.equilibrium.given:
                return is_balanced(self.equilibrium, at)
            verdicts = [self._vanishes(at(c.expression)) for c in self.equilibrium.conditions]
            return False if False in verdicts else None if None in verdicts else True
        except DivisionByZeroError:
            return False

    def _open(self, point: Values, found: SolutionSet) -> int:
        """How many unknowns a point leaves open."""
        letters = found.letters
        own = [letters.angles[u].cosine if u in letters.angles else u for u in self.unknowns]
        return sum(letter not in point for letter in own)


def _points(b: Branch, unknowns: Sequence[sp.Symbol]) -> list[Values]:
    """The points of a branch that is in closed form; a relation of parameters gives one of these a value."""
    if b.left:
        return []
    given: Values = {}
    if b.special:
        _, given = parameters_given([r.residual for r in b.relations], unknowns)
    return [{**p, **given} for p in b.points]


def _stated(b: Branch) -> str:
    return " and ".join(f"{text(r.lhs)} = {text(r.rhs)}" for r in b.relations) or "nothing is determined"


def _is_angle(u: sp.Symbol, forces: Sequence[sp.Expr], rows: Sequence[sp.Expr]) -> bool:
    """Whether an unknown occurs in sines and cosines, and forces do not depend on it otherwise."""
    if not any(u in f.free_symbols for e in (*forces, *rows) for f in e.atoms(*CIRCULAR)):
        return False
    outside = (e.xreplace({f: sp.Dummy() for f in e.atoms(*CIRCULAR)}) for e in forces)
    return not any(u in e.free_symbols for e in outside)


def _parts_of_angles(expressions: Sequence[sp.Expr], angles: frozenset[sp.Symbol]) -> int:
    """The largest n for which θ/n occurs."""
    letters = Letters(expressions, tuple(angles))
    return max((int((u / letters.angles[u].measure)) for u in angles if u in letters.angles), default=1)
