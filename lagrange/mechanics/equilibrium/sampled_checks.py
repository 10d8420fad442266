"""Stability and frequencies checked numerically: what is printed is evaluated at sampled parameters.

An equilibrium is a point of the printed relations; its conditions, and those of its stability, are read there as they
are printed. The second variation is formed anew, from Lagrange's equations at rest L_k = 0 with multipliers,

    S = Nᵀ H N ,     H_kj = ∂(L_k − Σ_i λ_i a_ik)/∂q_j ,     A N = 0 ,     Aᵀ λ = L ,

with λ and N solved for in numbers: no coordinate is eliminated, and no minor is factored or simplified. Stable needs
S > 0 wherever the conditions hold, unstable a negative square, and so does a condition that is reversed.

Values have eighty digits. A sign counts if the value is above 10⁻⁴² of the largest one; otherwise the point is not
used. The points are the same in every run.

Frequencies: det(K + p D + p² M) = det M Π (p² + ω_i²)^{n_i}, exactly, with the multiplicities n_i that are stated.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from random import Random
from typing import Any

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch, resolved
from lagrange.algebra.exact.expression_graph import DivisionByZeroError, Graph, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.real_points import RealPoint, Reals, newton_point
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.determinants import expanded_determinant
from lagrange.core.records import all_hold
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.equilibrium.admissible_positions import QUARTER
from lagrange.mechanics.equilibrium.damped_modes import all_exponents_hold
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import (
    MOST_COMPARED_POINTS,
    MOST_DRAWS,
    MOST_DRAWS_FOR_ONE,
    MOST_EXPANDED_ROWS,
    SAMPLES_PER_SIDE,
)
from lagrange.mechanics.equilibrium.linear_stability import Ground, VelocityTerms
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations
from lagrange.mechanics.equilibrium.stability import SecondVariation, Stability, StabilityVerdict

HOW = "in numbers, at sampled parameters"


def check_stability(resting: Equilibrium, second: SecondVariation | None) -> list[Check]:
    """The check of the stability of the equilibria of one configuration; none if nothing is claimed of it."""
    if second is None:
        return []
    samples = Samples(resting)
    judged = zip(resting.branches, second.verdicts, strict=True)
    verdicts = [v for b, s in judged if s.order == 2 and not s.even_powers for v in samples.agreeing(b, s)]
    if not verdicts:
        return []
    return [Check("the second variation has the stated signs", all_hold(verdicts), HOW, resting.configuration.name)]


def check_oscillations(linear: Linearization) -> list[Check]:
    """The checks of stability to first order and of the frequencies, in one set of coordinates."""
    name = linear.configuration.name
    samples = Samples(linear.equilibrium)
    checks = []
    signs = [
        v
        for b, s in zip(linear.branches, linear.at, strict=True)
        if s is not None and _rests_on_stiffness(s)
        for v in samples.agreeing(b, s.judgement.stability)
    ]
    if signs:
        checks.append(Check("the stiffness has the stated signs", all_hold(signs), HOW, name))
    listed = (s for s in linear.originals if s.frequencies and len(s.free) <= MOST_EXPANDED_ROWS)
    roots = [_are_all_roots(s) for s in listed]
    if roots:
        how = "exact: det(K − ω² M) is their product"
        checks.append(Check("the frequencies have the stated multiplicities", all_hold(roots), how, name))
    damped = [(s.decaying, s.system) for s in linear.originals if len(s.free) <= MOST_EXPANDED_ROWS]
    exponents = [all_exponents_hold(d, (s.mass, s.damping, s.stiffness)) for d, s in damped if d is not None]
    if exponents:
        how = "exact: det(K + p D + p² M) is their product"
        checks.append(
            Check("the decay rates and frequencies are those of all exponents", all_hold(exponents), how, name)
        )
    return checks


def _rests_on_stiffness(s: SmallOscillations) -> bool:
    """Whether the verdict is one on the signs of K: stable if and only if K > 0."""
    return s.system.symmetric and (s.judgement.ground is Ground.POTENTIAL or s.system.kind is VelocityTerms.NONE)


def _are_all_roots(s: SmallOscillations) -> bool | None:
    """Whether det(K + p D + p² M) = det M Π (p² + ω_i²)^{n_i}, and the modes are as many as the multiplicity."""
    if any(f.modes and len(f.modes) != f.multiplicity for f in s.frequencies):
        return False
    mass, damping, stiffness = (sp.Matrix(x) for x in (s.system.mass, s.system.damping, s.system.stiffness))
    p = sp.Symbol("exponent", real=True)
    product = expanded_determinant(mass.tolist())
    for f in s.frequencies:
        if f.square is not None:
            product *= (p**2 + f.square) ** f.multiplicity
        else:
            polynomial = sp.Poly(f.factor, f.letter)
            sign = (-1) ** polynomial.degree()
            product *= (sign * f.factor.xreplace({f.letter: -(p**2)}) / polynomial.LC()) ** f.multiplicity
    try:
        return is_zero(expanded_determinant((stiffness + p * damping + p**2 * mass).tolist()) - product)
    except DivisionByZeroError:
        return None


class Samples:
    """Points in numbers at which statements about the equilibria of one configuration are tried."""

    def __init__(self, resting: Equilibrium) -> None:
        self.resting = resting
        self.slots = resting.configuration.slots
        self.graph = Graph()

    @cached_property
    def forces(self) -> list[sp.Expr]:
        """L_k at rest, shape (n,), by Lagrange's equations."""
        at_rest = dict.fromkeys((*self.slots.velocities, *self.slots.accelerations), sp.S.Zero)
        return [e.xreplace(at_rest) for e in lagrange_equations(self.resting.configuration).left]

    @cached_property
    def rows(self) -> list[list[sp.Expr]]:
        """A, shape (m, n)."""
        return [list(r.coefficients) for r in self.resting.binding]

    @cached_property
    def multipliers(self) -> tuple[sp.Symbol, ...]:
        """λ, shape (m,)."""
        return tuple(sp.Symbol(f"lambda_sampled_{n}", real=True) for n, _ in enumerate(self.rows))

    @cached_property
    def hessian(self) -> list[list[sp.Expr]]:
        """H, shape (n, n); away from the jumps of forces, where sign(x) is constant."""
        total = [
            e - sp.Add(*(m * row[k] for m, row in zip(self.multipliers, self.rows, strict=True)))
            for k, e in enumerate(self.forces)
        ]
        derivatives = [[e.diff(q) for q in self.slots.coordinates] for e in total]
        return [[d.replace(sp.DiracDelta, lambda *_: sp.S.Zero) for d in row] for row in derivatives]

    def agreeing(self, b: Branch, s: Stability) -> list[bool | None]:
        """Whether the second variation has the stated sign, at each point that could be used; None if none could."""
        if b.special or (s.verdict is StabilityVerdict.UNDECIDED and not s.unstable):
            return []
        verdicts: list[bool | None] = [v for points in self.series(b) for v in self._agree(points, b, s)]
        # Other branches do not stand in for one at which nothing was tried.
        return verdicts or ([] if b.may_be_empty else [None])

    def _agree(self, points: Iterator[RealPoint], b: Branch, s: Stability) -> Iterator[bool]:
        left = {True: SAMPLES_PER_SIDE, False: SAMPLES_PER_SIDE}
        for number, point in enumerate(points):
            if number >= MOST_DRAWS and min(left.values()) < SAMPLES_PER_SIDE:
                return
            try:
                stable = claimed(point, b, s)
                sign = self._sign(point, bool(s.pole)) if stable is not None and left[stable] else None
            except (InadmissibleError, UnsupportedError, DivisionByZeroError):
                continue
            if stable is None or sign is None:
                continue
            if s.pole and sign == 1 and not stable:
                continue  # V may be less at another φ
            left[stable] -= 1
            yield sign == (1 if stable else -1)

    def series(self, b: Branch) -> Iterator[Iterator[RealPoint]]:
        """Points with drawn parameters for each root of a branch; conditions need not hold there."""
        if b.left:
            yield self._on_surface(b)
            return
        for values in b.points[:MOST_COMPARED_POINTS]:
            yield self._at(values)

    def _at(self, values: Values) -> Iterator[RealPoint]:
        for number in range(MOST_DRAWS_FOR_ONE):
            try:
                yield self.point(values, number)
            except (InadmissibleError, UnsupportedError, DivisionByZeroError):
                continue

    def _on_surface(self, b: Branch) -> Iterator[RealPoint]:
        """Points of the surface that unsolved equations define, by Newton's iteration from drawn places."""
        e = self.resting
        equations = [r.residual for r in b.equations] + [*e.configuration.finite_constraints]
        unknowns = [*self.slots.coordinates, *e.forces, *e.multipliers]
        q = e.solution.unknowns
        quarter = len(q) == 1 and b.occupied and e.configuration.ranges.get(q[0]) == QUARTER
        for number in range(MOST_DRAWS):
            point = RealPoint(self.graph, Reals(Random(number)))
            if newton_point(point, equations, unknowns) and not (quarter and abs(point.value(q[0])) > math.pi / 2):
                yield point

    def point(self, values: Values, number: int, given: Mapping[sp.Symbol, Any] | None = None) -> RealPoint:
        """Random parameters and free coordinates, and the other coordinates by the values of a branch's letters.

        given  parameters that are not drawn
        """
        point = RealPoint(self.graph, Reals(Random(number)))
        point.move(given or {})
        letters = self.resting.solution.letters
        places: dict[sp.Symbol, Any] = {}

        def written(letter: sp.Symbol) -> sp.Expr:
            return letters.write(resolved(letter, values))

        known = {q for q in self.slots.coordinates if q in values or q in letters.angles}
        fixed = {q for q in known if q in values or letters.angles[q].cosine in values}
        expressions = [written(x) for q in fixed for x in (q, *self._letters(q)) if x in values]
        drawn = {x for e in (*self.forces, *expressions) for x in e.free_symbols} - fixed
        for x in sorted(drawn, key=str):
            point.input(x)
        by_others = {q for q in fixed if q in values and values[q].free_symbols & fixed}  # α = β
        for q in sorted(fixed - by_others, key=str):
            if q in values:
                places[q] = point.value(written(q))
                continue
            angle = letters.angles[q]
            pair = point.value(written(angle.cosine)), point.value(written(angle.sine))
            turned = RealPoint(self.graph, point.reals)
            turned.set_angle(q, pair, int(q / angle.measure))
            places[q] = turned.input(q)
        point.move(places)
        if by_others:
            point.move({q: point.value(written(q)) for q in by_others})
        return point

    def _letters(self, q: sp.Symbol) -> tuple[sp.Symbol, ...]:
        angle = self.resting.solution.letters.angles.get(q)
        return angle.letters if angle is not None else ()

    def _sign(self, point: RealPoint, at_pole: bool = False) -> int | None:
        """1 where S is positive definite, −1 where it takes negative values, None if a minor is too small.

        at_pole  without the displacement that moves nothing
        """
        table, _ = self.projected(point)
        if at_pole:
            moving = [k for k, row in enumerate(table) if not all(map(point.arithmetic.vanishes, row))]
            table = [[table[k][j] for j in moving] for k in moving]
        return definiteness_in_numbers(point, table)

    def projected(self, point: RealPoint) -> tuple[list[list[Any]], list[list[Any]]]:
        """S, empty if the forces do not balance, and N; the multipliers receive their values."""
        size = len(self.slots.coordinates)
        rows = point.matrix(self.rows)
        basis = [[point.number(int(n == k)) for n in range(size)] for k in range(size)]
        if rows:
            columns = [list(column) for column in zip(*rows, strict=True)]
            solved = point.solution(columns, point.values(self.forces))
            if solved is None:
                return [], []
            point.move(dict(zip(self.multipliers, solved, strict=True)))
            basis = point.nullspace(rows, size)
        hessian = point.matrix(self.hessian)
        return [[_product(a, hessian, c) for c in basis] for a in basis], basis


def _product(a: Sequence[Any], matrix: Sequence[Sequence[Any]], b: Sequence[Any]) -> Any:
    """aᵀ M b."""
    return sum(x * sum(e * y for e, y in zip(row, b, strict=True)) for x, row in zip(a, matrix, strict=True))


def definiteness_in_numbers(point: RealPoint, table: Sequence[Sequence[Any]]) -> int | None:
    """1, −1 or None for a symmetric matrix of numbers, by completing squares: the signs of xᵀ S x."""
    largest = max([abs(x) for row in table for x in row], default=0)
    if not table or point.arithmetic.vanishes(largest):
        return None
    rest = [[x / largest for x in row] for row in table]
    vanishes = point.arithmetic.vanishes
    while rest:
        size = len(rest)
        if any(rest[k][k] < 0 and not vanishes(rest[k][k]) for k in range(size)):
            return -1
        k = max(range(size), key=lambda k, rest=rest: rest[k][k])  # type: ignore[misc]
        if vanishes(rest[k][k]):  # and so do all the others: 2 a x y takes both signs
            return None if all(vanishes(x) for row in rest for x in row) else -1
        others = [i for i in range(size) if i != k]
        rest = [[rest[i][j] - rest[i][k] * rest[k][j] / rest[k][k] for j in others] for i in others]
    return 1


def determinant_in_numbers(table: Sequence[Sequence[Any]]) -> Any:
    """By the first row, without a division."""
    if not table:
        return 1
    return sum(
        (-1) ** j * x * determinant_in_numbers([[*row[:j], *row[j + 1 :]] for row in table[1:]])
        for j, x in enumerate(table[0])
    )


def exists(b: Branch, point: RealPoint) -> bool:
    """Whether the conditions of a branch hold strictly at a point, which may be at the end of a range."""
    return all(_sense(point, c) == 1 for c in b.conditions) and all(_sense(point, c) >= 0 for c in b.implied)


def claimed(point: RealPoint, b: Branch, s: Stability) -> bool | None:
    """Whether an equilibrium is stated to be stable at a point; None if it does not exist, or nothing is stated."""
    if not exists(b, point):
        return None
    match s.verdict:
        case StabilityVerdict.STABLE | StabilityVerdict.UNSTABLE:
            holds = all(_sense(point, c) == 1 for c in s.presupposed)
            return (s.verdict is StabilityVerdict.STABLE) if holds else None
        case StabilityVerdict.CONDITIONAL:
            senses = [_sense(point, c) for c in s.conditions]
            return True if set(senses) == {1} else False if -1 in senses else None
        case StabilityVerdict.UNDECIDED:
            return False if any(_sense(point, c) == 1 for c in s.unstable) else None


def _sense(point: RealPoint, c: SignCondition) -> int:
    """1 where a condition holds strictly, −1 where it is reversed, 0 where both sides are equal."""
    difference = point.value(c.lhs - c.rhs)
    if point.arithmetic.vanishes(difference):
        return 0
    if c.relation == "≠":
        return 1
    return 1 if (difference > 0) == (c.relation in ("≥", ">")) else -1
