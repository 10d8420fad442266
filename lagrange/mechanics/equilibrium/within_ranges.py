"""Equilibria within the ranges of the coordinates: what lies outside is omitted.

An angle θ lies in [a, b] modulo 2π, for b − a ≤ π, if and only if sin(θ − a) ≥ 0 and sin(b − θ) ≥ 0; for a larger range
it lies outside if it is strictly in the complement, which is shorter. Any other coordinate x is in [a, b] if x − a ≥ 0
and b − x ≥ 0. The signs are those at the points of a branch. A point is omitted where it is certainly outside; where
the parameters leave that open, it becomes a condition if the coordinate is no angle.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition, not_negative, sign_of
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet
from lagrange.algebra.closed_forms.tangent_equation import beside_zero
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.operations import count_operations
from lagrange.core.ranges import sign_between
from lagrange.mechanics.equilibrium.limits import LONGEST_RANGE_CONDITION
from lagrange.problem.model import Range

QUARTER = Range(-sp.pi / 2, sp.pi / 2)


def within(b: Branch, ranges: Mapping[sp.Symbol, Range], solution: SolutionSet) -> Branch | None:
    """The branch without the points outside of the ranges; None where all of them are."""
    if b.left and not b.special and len(solution.unknowns) == 1 and ranges.get(q := solution.unknowns[0]) == QUARTER:
        return beside_zero(b, q)
    if b.left or b.special or not b.points:
        return b
    positive = [c.lhs - c.rhs for c in b.conditions if c.relation == ">"]
    positive += [c.rhs - c.lhs for c in b.conditions if c.relation == "<"]
    kept = tuple(p for p in b.points if not is_outside(p, ranges, solution, positive))
    if not kept:
        return None
    known = tuple(c for q, r in ranges.items() for c in _known(q, r, solution))
    more = [c for q, r in ranges.items() for c in _conditions(q, r, kept, solution, positive)]
    conditions = tuple(dict.fromkeys([*b.conditions, *more]))
    return replace(b, points=kept, implied=(*b.implied, *known), conditions=conditions)


def distances(q: sp.Expr, limits: Range, is_angle: bool) -> tuple[tuple[sp.Expr, ...], bool]:
    """Expressions that are ≥ 0 where q is in the range, or, if the second result is true, > 0 where it is not."""
    if not is_angle:
        return (q - limits.low, limits.high - q), False
    width = limits.high - limits.low
    if width.is_number and width >= 2 * sp.pi:
        return (), False
    if width.is_number and width > sp.pi:
        return (sp.sin(q - limits.high), sp.sin(limits.low - q)), True
    return (sp.sin(q - limits.low), sp.sin(limits.high - q)), False


def is_outside(
    point: Values, ranges: Mapping[sp.Symbol, Range], solution: SolutionSet, positive: Sequence[sp.Expr] = ()
) -> bool:
    """Whether a coordinate is certainly outside of its range at a point, where some expressions are positive."""
    return any(_is_outside(q, r, point, solution, positive) for q, r in ranges.items())


def _is_outside(q: sp.Symbol, limits: Range, point: Values, solution: SolutionSet, positive: Sequence[sp.Expr]) -> bool:
    tested, complement = distances(q, limits, q in solution.letters.angles)
    signs = [_sign(e, point, solution, positive) for e in tested]
    if complement:
        return bool(signs) and all(s == 1 for s in signs)
    return -1 in signs


def _sign(e: sp.Expr, point: Values, solution: SolutionSet, positive: Sequence[sp.Expr]) -> int | None:
    """The strict sign of an expression at a point; None: it is not known, 0: it vanishes."""
    try:
        value = solution.at(point, sp.expand_trig(e))
        if value.has(sp.zoo, sp.nan):
            return None
        return 0 if value == 0 or is_zero(value) else sign_of(value, positive)
    except (NotAlgebraicError, DivisionByZeroError):
        return None


def _conditions(
    q: sp.Symbol, limits: Range, points: tuple[Values, ...], solution: SolutionSet, positive: Sequence[sp.Expr]
) -> Iterator[SignCondition]:
    """What has to hold for a coordinate that is no angle to be in its range."""
    if q in solution.letters.angles or len(points) != 1:
        return
    for e in distances(q, limits, False)[0]:
        try:
            value = solution.at(points[0], e)
        except (NotAlgebraicError, DivisionByZeroError):
            continue
        if not value.free_symbols & {*solution.unknowns} and count_operations(value) <= LONGEST_RANGE_CONDITION:
            yield from not_negative(value, positive) or ()


def _known(q: sp.Symbol, limits: Range, solution: SolutionSet) -> Iterator[SignCondition]:
    """What holds in the whole range: cos θ ≥ 0 between −π/2 and π/2."""
    zero = sp.S.Zero
    if q not in solution.letters.angles:
        yield from (SignCondition(e, "≥", zero) for e in distances(q, limits, False)[0])
        return
    if not (limits.low.is_number and limits.high.is_number):
        return
    for f in (sp.sin, sp.cos):
        for strict, relation in ((False, ">"), (True, "≥")):
            sign = sign_between(f, limits.low, limits.high, (strict, strict))
            if sign is not None:
                yield SignCondition(sign * f(q), relation, zero)
                break
