"""An answer about equilibria compared with those of one configuration: is it right, and complete?

An answer is a system of equations, or several alternative ones: nested lists in a file, `theta = 0 or theta = pi` in
one equation. It means the set of positions (and unknown forces) that satisfy one of the alternatives, and is compared
as a set of points with the equilibria of a configuration:

    right       every solution of each alternative satisfies the conditions of equilibrium
    complete    every equilibrium satisfies one of the alternatives

Both sides are solved (`branching`) and substituted into the other, exactly: points are never matched one by one, since
which of two solutions is which may depend on the signs of parameters. An equation holds at one of several points, or a
point satisfies one of several alternatives, if the product of their residuals vanishes. Angles count modulo 2π: θ = π
means (cos θ, sin θ) = (−1, 0); for an angle that also occurs outside sines and cosines the value itself is substituted.
What has no closed form is compared by its factors, or on the surfaces that the equations define.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property, partial
from typing import TypeAlias

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.polynomial_roots import irreducible_factors, numerator, over_one_denominator_in_roots
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet, agree, is_one_with_root, parameters_given
from lagrange.algebra.closed_forms.undefined_points import undefined_points
from lagrange.algebra.closed_forms.unit_circle import (
    NotAlgebraicError,
    TrigLetters,
    is_in_circular,
    is_outside_circular,
    parts_of_angles,
)
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.friction.logarithms import at, in_sums, with_logarithms
from lagrange.answers.other_angles import as_waves, on_circle
from lagrange.answers.readings import Reading
from lagrange.answers.unsolved_equations import are_balanced
from lagrange.answers.validity import also_holds
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, UNDECIDED, AnswerVerdict, EquationVerdict, Reason, Verdict, Why
from lagrange.core.records import all_hold, any_holds, record
from lagrange.document.math_writer import text
from lagrange.mechanics.equilibrium.admissible_positions import is_outside
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, is_balanced, is_balanced_on
from lagrange.mechanics.equilibrium.searched.stated_places import are_covered
from lagrange.problem.model import Range

RESTATED = "it restates a constraint"
_DIVIDES = "there are equilibria at which it divides by zero: state them as well"


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
    loose     whether it leaves open what the conditions determine, because equations are missing
    """

    right: bool | None
    loose: bool
    verdicts: tuple[EquationVerdict, ...]


_Case: TypeAlias = tuple[Values, Sequence[sp.Expr], Mapping[sp.Symbol, sp.Expr]]
"""A point, and equations and given angles that may hold there."""


class EquilibriumComparison:
    """An answer against the equilibria of one configuration.

    points    the equilibria in closed form, each with the number of its branch
    demanded  those of them that may lie in the ranges of the coordinates, with taut strings, or all if none do
    branches  those that exist for all parameters, or all if there are none
    special   the others, which exist for particular parameters only
    left      branches not known in closed form
    angles    the unknowns that count modulo 2π
    mixed     the unknowns that occur in sines and cosines, and outside as well
    """

    def __init__(
        self, e: Equilibrium, values: Mapping[sp.Symbol, sp.Expr], systems: Sequence[Sequence[Sequence[sp.Expr]]]
    ) -> None:
        self.equilibrium = e
        self.surface = e.configuration.surface
        # A given position satisfies its constraints, which are then no equations for the forces.
        finite = () if e.given else e.configuration.finite_constraints
        self.rows = tuple(f.xreplace(dict(values)) for f in finite)
        self.conditions = (*(c.xreplace(dict(values)) for c in e.required), *self.rows)
        self.unknowns = e.forces if e.given else (*e.configuration.slots.coordinates, *e.forces)
        self.forces = e.forces
        forces = (*e.work.forces, *e.required)
        bound = tuple(a for row in e.binding for a in row.coefficients)
        turned = [u for u in self.unknowns if is_in_circular(u, (*forces, *self.rows, *bound))]
        self.angles = frozenset(u for u in turned if not is_outside_circular(u, forces))
        self.mixed = frozenset(turned) - self.angles
        self.values = dict(values)
        solution = e.solution
        asked = [x for a in systems for es in a for x in es]
        # cos θ/2 is no rational function of cos θ and sin θ: if the answer has half angles, the conditions are solved
        # again with letters for these.
        half = parts_of_angles(asked, self.angles) > parts_of_angles(solution.equations, self.angles)
        if values or half:
            solution = solutions(
                [x.xreplace(self.values) for x in solution.equations],
                solution.unknowns,
                [u for u in solution.unknowns if u not in e.configuration.slots.coordinates],
                beside=asked,
            )
        # What an answer contains is read with letters of its own, so that no answer depends on one before it.
        own = replace(solution, letters=solution.letters.copy())
        self.solution, self.has_logarithms = (solution := with_logarithms(own)), solution != own
        # Equilibria for particular parameters only need not be in an answer.
        generic = [b for b in solution.branches if not b.special]
        branches = generic or list(solution.branches)
        self.special = [b for b in solution.branches if b.special] if generic else []
        if e.poles:  # nor the poles of a chart at which there is no equilibrium
            self.special += [b for b in branches if self._is_pole(b)]
            branches = [b for b in branches if b not in self.special]
        self.points = self._distinct([(n, p) for n, b in enumerate(branches) for p in self._points_of(b)])
        self.left = [b for b in branches if b.left]
        self.branches = branches
        self.demanded = self._within_ranges() or self.points

    def _within_ranges(self) -> list[tuple[int, Values]]:
        """The points that may lie in the ranges of the coordinates: an answer need not have any others."""
        slack = [p for b in self.equilibrium.slack for p in b.points]
        return [
            (n, p)
            for n, p in self.points
            if not is_outside(p, self._ranges, self.solution) and not any(self._is_at(p, q) for q in slack)
        ]

    @cached_property
    def _ranges(self) -> dict[sp.Symbol, Range]:
        """The ranges of the coordinates: an answer need not have what lies outside, and may have it."""
        rule = dict(self.values)
        ranges = self.equilibrium.configuration.ranges.items()
        return {q: replace(r, low=r.low.xreplace(rule), high=r.high.xreplace(rule)) for q, r in ranges}

    def _is_pole(self, b: Branch) -> bool:
        """Whether all points of a branch are among those that were omitted as poles."""
        poles = [p for pole in self.equilibrium.poles for p in pole.points]
        return bool(b.points) and not b.left and all(any(self._is_at(p, q) for q in poles) for p in b.points)

    def _is_at(self, p: Values, place: Values) -> bool:
        """Whether a point is one of the equilibrium as it was solved, without the values."""
        return agree(self.solution, p, self.equilibrium.solution, place, self._functions(self.unknowns), self.values)

    def _functions(self, unknowns: Sequence[sp.Symbol]) -> list[sp.Expr]:
        """What tells two positions apart, angles modulo whole turns."""
        return [f for u in unknowns for f in ((sp.cos(u), sp.sin(u)) if u in self.angles else (u,))]

    def _points_of(self, b: Branch) -> list[Values]:
        """The points of a branch in closed form; a relation between parameters gives one of them a value."""
        if b.left:
            return []
        given: Values = {}
        if b.special:
            _, given = parameters_given([r.residual for r in b.relations], self.solution.unknowns)
        return [self._with_letters({**p, **given}) for p in b.points]

    def _with_letters(self, point: Values) -> Values:
        """The point with the sines and cosines of an angle whose own value it has."""
        for u in self.mixed:
            lettered = self.solution.letters.angles.get(u)
            if lettered is not None and u in point and lettered.cosine not in point:
                angle = lettered.measure.xreplace({u: point[u]})
                point = {**point, lettered.cosine: sp.cos(angle), lettered.sine: sp.sin(angle)}
        return point

    def _distinct(self, points: list[tuple[int, Values]]) -> list[tuple[int, Values]]:
        """The points without repetition modulo whole turns: θ/2 and θ/2 + π are the same θ."""
        if all(a.measure == u for u, a in self.solution.letters.angles.items() if u in self.angles):
            return points
        kept: list[tuple[int, Values]] = []
        functions = self._functions(self.unknowns)
        for n, p in points:
            if not any(agree(self.solution, p, self.solution, q, functions) for _, q in kept):
                kept.append((n, p))
        return kept

    def verdict(
        self, readings: Sequence[Sequence[Reading]], systems: Sequence[Sequence[Sequence[sp.Expr]]]
    ) -> AnswerVerdict:
        """The verdict on the alternatives together."""
        alternatives = [self._alternative(tuple(r), s) for r, s in zip(readings, systems, strict=True)]
        judged = []
        for a in alternatives:
            try:
                judged.append(self._judged(a))
            except DivisionByZeroError:
                unreadable = (EquationVerdict(r.text, Verdict.UNREADABLE, DIVIDES_BY_ZERO) for r in a.readings)
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
        uncovered = self._uncovered(alternatives)
        if uncovered is None:
            return AnswerVerdict(Verdict.UNDECIDED, equations)
        for b in self.left if not any(self._has_unsolved(s) for s in systems) else ():
            covered = self._is_covered(b, alternatives)
            if covered is None:
                return AnswerVerdict(Verdict.UNDECIDED, equations)
            uncovered |= set() if covered else {self.branches.index(b)}
        lost = {e for n, p in self.demanded if n not in uncovered for e in self._lost(p, alternatives)}
        if lost:
            equations = tuple(
                replace(v, remarks=(*v.remarks, _DIVIDES)) if lost & {*es} else v
                for v, es in zip(equations, (es for a in alternatives for es in a.equations), strict=True)
            )
        if uncovered or lost:
            return AnswerVerdict(Verdict.INCOMPLETE, equations, missing=len(uncovered) + bool(lost))
        return AnswerVerdict(Verdict.EQUIVALENT, equations)

    def is_in_contact(self, readings: Sequence[Reading], system: Sequence[Sequence[sp.Expr]]) -> bool:
        """Whether an alternative has other places than those at which a contact would have to pull: +θ, and not −θ."""
        if not self.equilibrium.slack:
            return True
        alternative = self._alternative(tuple(readings), system)
        return any(self._one_holds(self._cases(p, [alternative])) is not False for _, p in self.demanded)

    def _uncovered(self, alternatives: Sequence[_Alternative]) -> set[int] | None:
        """The branches with a point that satisfies none of the alternatives; None: undecided."""
        uncovered = set()
        for n, p in self.demanded:
            holds = self._one_holds(self._cases(p, alternatives))
            if holds:
                continue
            if holds is None or not self._is_balanced(self.solution, p, {}):
                return None
            uncovered.add(n)
        return uncovered

    def _is_covered(self, b: Branch, alternatives: Sequence[_Alternative]) -> bool | None:
        """Whether the alternatives have the points of a branch that is not in closed form, by some in numbers."""
        systems = [[x for es in a.equations for x in es] + as_waves(a.angles) for a in alternatives]
        equations = [*(r.residual for r in b.equations), *self.rows]
        given = [[x.xreplace(self.values) for x in system] for system in systems]
        unknowns = (*self.unknowns, *self.equilibrium.multipliers)
        return are_covered(equations, b.conditions, unknowns, self.angles | self.mixed, given)

    def _cases(self, p: Values, alternatives: Sequence[_Alternative]) -> list[_Case]:
        return [(p, [x for es in a.equations for x in es], a.angles) for a in alternatives]

    def _lost(self, p: Values, alternatives: Sequence[_Alternative]) -> Iterator[sp.Expr]:
        """The equations that lose equilibria of a family on which they hold, since they divide by zero there."""
        unknowns = tuple(dict.fromkeys((*self.unknowns, *self.equilibrium.multipliers)))
        for e in dict.fromkeys(x for a in alternatives for es in a.equations for x in es):
            for q in undefined_points(e, p, self.solution, unknowns):
                if self._is_balanced(self.solution, q, {}) and self._one_holds(self._defined(q, alternatives)) is False:
                    yield e

    def _defined(self, p: Values, alternatives: Sequence[_Alternative]) -> list[_Case]:
        """The alternatives that have a value at a position."""
        return [case for case in self._cases(p, alternatives) if self._residuals(*case) is not None]

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
        e = over_one_denominator_in_roots(e)
        letters = TrigLetters([e, *self.conditions], self.unknowns)
        try:
            parts = numerator(letters.read(e))
        except NotAlgebraicError:
            parts = numerator(e)
        pieces = irreducible_factors(letters.reduced(parts[0])) if parts else None
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
                    kept.append(on_circle(in_sums(e) if self.has_logarithms else e, self.angles))
            equations.append(tuple(kept))
        return _Alternative(readings, tuple(equations), angles)

    def _given_angle(self, e: sp.Expr) -> tuple[sp.Symbol, sp.Expr] | None:
        """θ, α if the equation is θ = α and α contains no unknown."""
        for u in sorted((self.angles | self.mixed) & e.free_symbols, key=str):
            rate = e.diff(u)
            if rate.is_Rational and rate != 0:
                angle = sp.expand(u - e / rate)
                if not angle.free_symbols & {*self.unknowns}:
                    return u, angle
        return None

    def _judged(self, a: _Alternative) -> _Judged:
        evident = [self._evident(r, es) for r, es in zip(a.readings, a.equations, strict=True)]
        known = tuple(v for v in evident if v is not None)
        if len(known) == len(evident):
            return _Judged(False, True, known)
        right, loose, why = self._right([x for es in a.equations for x in es], a.angles)
        tested = [known or self._tested(n, a, right) for n, known in enumerate(evident)]
        if right is False and not loose and all(v.verdict is not Verdict.WRONG for v in tested):
            # Some solutions are no equilibria: no equation is right then, not even one that may hold at unknown ones.
            open_verdicts = (Verdict.EQUIVALENT, Verdict.UNDECIDED)
            tested = [EquationVerdict.because(v.text, why) if why and v.verdict in open_verdicts else v for v in tested]
        return _Judged(right, loose, tuple(tested))

    def _evident(self, reading: Reading, equations: Sequence[sp.Expr]) -> EquationVerdict | None:
        """The verdict on an identity, or a constraint restated; None for other equations."""
        if not equations or not all(self.surface.is_zero(e) for e in equations):
            return None
        if all(is_zero(e.xreplace(self.values)) for e in reading.components):
            return EquationVerdict(reading.text, Verdict.TRIVIAL, "it is an identity, true for every position")
        return EquationVerdict(reading.text, Verdict.EQUIVALENT, remarks=(RESTATED,))

    def _tested(self, n: int, a: _Alternative, right: bool | None) -> EquationVerdict:
        """The verdict on equation n of an alternative.

        right  whether all solutions of the alternative are equilibria
        """
        text, equations = a.readings[n].text, a.equations[n]
        rest = [x for m, es in enumerate(a.equations) if m != n for x in es]
        _, values = parameters_given([*equations, *rest], self.unknowns)
        if equations and not any(e.free_symbols & {*self.unknowns} for e in equations):
            needed = self._is_needed(rest, a.angles, values, right)
            if needed is None:
                return EquationVerdict(text, Verdict.UNDECIDED, UNDECIDED)
            return (
                EquationVerdict(text, Verdict.EQUIVALENT)
                if needed
                else EquationVerdict.because(text, Why(Reason.NOT_REQUIRED))
            )
        if right:
            return EquationVerdict(text, Verdict.EQUIVALENT)
        angles: Mapping[sp.Symbol, sp.Expr] = {}
        if not equations:  # it gives an angle
            used = set().union(*(e.free_symbols for e in a.readings[n].components))
            angles = {u: v for u, v in a.angles.items() if u in used} or a.angles
        somewhere = self._somewhere(equations, angles, values)
        if somewhere is None or (right is None and somewhere):
            return EquationVerdict(text, Verdict.UNDECIDED, UNDECIDED)
        if somewhere:
            return EquationVerdict(text, Verdict.EQUIVALENT)
        return EquationVerdict.because(text, Why(Reason.NOWHERE, self._unless(equations, angles)))

    def _is_needed(
        self, rest: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr], values: Values, right: bool | None
    ) -> bool | None:
        """Whether an equation between parameters is needed for the other equations to be right; None: undecided.

        It may be the condition of equilibrium, or the case that the others are about: k = 1/2 beside θ = 0. If it is
        neither, nothing in the equilibria agrees with it.
        """
        if right:
            without, _, _ = self._right(rest, angles)
            return None if without is None else not without
        if right is None:
            return None
        own = [e for e in rest if e.free_symbols & {*self.unknowns}]
        if not own and not angles:
            return False
        with_it, without = self._somewhere(own, angles, values), self._somewhere(own, angles, {})
        return None if with_it is None or without is None else with_it and not without

    def _unless(self, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr]) -> str:
        """The relation between parameters for which equations hold at an equilibrium after all."""
        for b in self.special:
            if self._at_one([(p, equations, angles) for p in self._points_of(b)]):
                related = [r for r in b.relations if not self.solution.letters.unknowns_in(self._read(r.residual))]
                return f", unless {' and '.join(f'{text(r.lhs)} = {text(r.rhs)}' for r in related)}" if related else ""
        return ""

    def _read(self, e: sp.Expr) -> sp.Expr:
        try:
            return self.solution.letters.read(e)
        except NotAlgebraicError:
            return e

    def _somewhere(
        self, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr], values: Values
    ) -> bool | None:
        """Whether equations hold at an equilibrium, parameters having these `values`; None: undecided."""
        at = [({**{u: v.xreplace(values) for u, v in p.items()}, **values}, equations, angles) for _, p in self.points]
        holds = self._at_one(at)
        if holds is not False or not self.left:
            return holds
        return True if self._unsolved & {x for e in equations for x in self._canonical(e)} else None

    def _one_holds(self, cases: Sequence[_Case]) -> bool | None:
        """Whether one of several systems holds, each at its own point; None: undecided.

        Which one it is may depend on parameters: then none of them has to hold for all of these, but the product of
        their sums of squared residuals vanishes.
        """
        sums = []
        undecided = False
        for point, equations, angles in cases:
            residuals = self._residuals(point, equations, angles)
            verdicts = [None] if residuals is None else [self._vanishes_if_defined(e) for e in residuals]
            if all(verdicts):
                return True
            undecided = undecided or (None in verdicts and False not in verdicts)
            sums += [sp.Add(*(e**2 for e in residuals))] if residuals else []
        if len(sums) < 2:
            return None if undecided else False
        together = self._vanishes_if_defined(sp.Mul(*sums))
        return together if together or not undecided else None

    def _at_one(self, cases: Sequence[_Case]) -> bool | None:
        """Whether one of several systems holds at its own point, or on part of what this point leaves undetermined."""
        verdicts = [self._one_holds(cases), *(self._on_a_part(*case) for case in cases)]
        return any_holds(verdicts)

    def _on_a_part(
        self, point: Values, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr]
    ) -> bool | None:
        """Whether equations hold on part of what a point leaves open: x = L, where every x is an equilibrium."""
        residuals = self._residuals(point, equations, angles)
        if residuals is None:
            return None
        open_unknowns = [u for u in self.unknowns if any(u in e.free_symbols for e in residuals)]
        if not open_unknowns:
            return False
        part = solutions(residuals, open_unknowns)
        if not part.solved or not part.verified:
            return None
        return any(not b.special for b in part.branches)

    def _residuals(
        self, point: Values, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr]
    ) -> list[sp.Expr] | None:
        """The residuals of equations at an equilibrium; None if they have no value there."""
        residuals = [*equations]
        for u, angle in angles.items():
            residuals += [u - angle] if u in self.mixed and u in point else as_waves({u: angle})
        try:
            values = [at(self.solution, point, e) for e in residuals]
        except (NotAlgebraicError, DivisionByZeroError):
            return None
        # A pole is no solution.
        return [sp.S.One if v.has(sp.zoo, sp.nan, sp.oo) else v for v in values]

    def _vanishes(self, e: sp.Expr) -> bool | None:
        """Whether an expression is zero; if the position is given, at all positions that the constraints admit."""
        return self.surface.is_zero(e) if self.equilibrium.given else is_zero(e)

    def _vanishes_if_defined(self, e: sp.Expr) -> bool | None:
        """Whether an expression is zero; None: undecided, or it divides by zero."""
        try:
            return self._vanishes(e)
        except DivisionByZeroError:
            return None

    def _right(
        self, equations: Sequence[sp.Expr], angles: Mapping[sp.Symbol, sp.Expr]
    ) -> tuple[bool | None, bool, Why | None]:
        """Whether all solutions of the equations are equilibria; whether equations are missing; what is wrong."""
        equations, values = parameters_given(equations, self.unknowns)
        given = {**values, **angles}
        equations = [e.xreplace(given) for e in equations]
        conditions = [c.xreplace(given) for c in self.conditions]
        rows = [r.xreplace(given) for r in self.rows]
        try:
            own = solutions([*equations, *rows], self.unknowns, self.forces, known=angles, beside=conditions)
        except NotAlgebraicError:
            return None, False, None
        if own.solved:
            if not own.branches:  # the sign of a root of parameters, by which one equation holds, may depend on them
                return None if is_one_with_root(equations, self.unknowns) else False, False, Why(Reason.CONTRADICTS)
            if not values and len(equations) + len(angles) > 1 and all(b.special for b in own.branches):
                return False, False, Why(Reason.CONTRADICTS)  # θ = 0, and cos θ = W/(c l)
            named = {s for e in equations for s in e.free_symbols} | {*angles}
            return self._solutions_right(own, given, [u for u in self.unknowns if u in named])
        if self._same_factors(equations):
            return True, False, None
        if len(equations) + len(angles) < len(self.conditions) - len(self.rows):
            return False, True, None
        if angles:
            return None, False, None
        known = {**self.values, **given}
        balanced_on = partial(is_balanced_on, self.equilibrium, values=known)
        verdict = are_balanced(equations, rows, self.unknowns, self._canonical, balanced_on)
        return verdict, False, Why(Reason.HOLDS_ELSEWHERE) if verdict is False else None

    def _same_factors(self, equations: Sequence[sp.Expr]) -> bool:
        """Whether the equations have the same factors as the conditions of equilibrium."""
        own = {x for e in equations for x in self._canonical(e)}
        return bool(own) and own == {x for e in self.conditions for x in self._canonical(e)}

    def _solutions_right(
        self, own: SolutionSet, values: Values, named: Sequence[sp.Symbol]
    ) -> tuple[bool | None, bool, Why | None]:
        """As `_right`, for an alternative that is solved in closed form and names some unknowns.

        A solution that is no equilibrium but leaves more unknowns open than an equilibrium does may contain equilibria:
        then equations are missing rather than wrong. One that differs from an equilibrium in a coordinate only that is
        not named, because the constraints admit two positions, is not meant.
        """
        verdict: bool | None = own.verified
        loose = False
        least = min((self._open(p, self.solution) for _, p in self.points), default=0)
        balanced: list[Values] = []
        others: list[tuple[Branch, Mapping[sp.Symbol, sp.Expr], bool | None]] = []
        inside = [p for b in own.branches for p in b.points if not is_outside(p, self._ranges, own)]
        for b in own.branches:
            _, related = parameters_given([r.residual for r in b.relations] if b.special else [], own.unknowns)
            for p in ({**p, **related} for p in b.points if p in inside or not inside):
                holds = self._is_balanced(own, p, values)
                if holds or self._is_conditional(own, p, values):
                    balanced.append(p)
                else:
                    others.append((b, p, holds))
        stated = self._functions(named) if len(named) < len(self.unknowns) else []
        for b, point, holds in others:
            if stated and any(agree(own, point, own, q, stated) for q in balanced):
                continue
            if holds is None:
                verdict = None
            elif self._open(point, own) > least:
                loose = True
            else:
                return False, False, Why(Reason.NOWHERE) if len(own.branches) == len(b.points) == 1 else also_holds(b)
        return (False if loose else verdict), loose, None

    def _is_conditional(self, own: SolutionSet, point: Values, values: Values) -> bool:
        """Whether a solution of the answer is an equilibrium under the condition of a branch: 5 H ≥ g.

        Where a root has the sign of 5 H − g, the forces balance for some parameters only: not of a special branch.
        """
        known = (p for n, p in self.points if self.branches[n].conditions and not self.branches[n].special)
        functions = self._functions(self.unknowns)
        return self.solution.verified is True and any(
            agree(own, point, self.solution, {**p, **values}, functions) for p in known
        )

    def _is_balanced(self, own: SolutionSet, point: Values, values: Values) -> bool | None:
        """Whether a solution of the answer is an equilibrium; None: undecided."""

        def value_at(e: sp.Expr) -> sp.Expr:
            value = at(own, point, e.xreplace(self.values).xreplace(dict(values)))
            if value.has(sp.zoo, sp.nan, sp.oo):
                raise DivisionByZeroError(e)
            return value

        try:
            if not self.equilibrium.given:
                return is_balanced(self.equilibrium, value_at)
            return all_hold([self._vanishes(value_at(c)) for c in self.equilibrium.required])
        except DivisionByZeroError:
            return False
        except NotAlgebraicError:
            return None

    def _open(self, point: Values, solution: SolutionSet) -> int:
        """The number of unknowns that a point leaves undetermined."""
        angles = solution.letters.angles
        return sum(u not in point and (u not in angles or angles[u].cosine not in point) for u in self.unknowns)
