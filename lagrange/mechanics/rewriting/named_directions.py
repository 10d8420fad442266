"""Vectors as multiples of unit vectors that have names: a force N n, not N sin θ i − N cos θ j.

v = c n + w with c = v_k/n_k, where w lacks the component k, or with c = v·n. It is written so where that is shorter.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import FIXED, Vector
from lagrange.mechanics.limits import LONGEST_IN_DIRECTIONS
from lagrange.mechanics.rewriting.factors import with_common_factor
from lagrange.problem.model import Problem

Directions = Mapping[str, Vector]


def unit_directions(problem: Problem) -> Directions:
    """The unit vectors of `let` and of the frame that are not along an axis, in i, j, k, by name."""
    named = {n: v for n, v in problem.abbreviations.items() if isinstance(v, Vector)}
    units = {n: v.fixed() for n, v in named.items() if is_zero(v.dot(v) - 1) is True}
    if problem.frame is not None and problem.frame.directions is not None:
        rows = (problem.frame.directions.row(n) for n in range(3))
        units = {n: Vector((r[0], r[1], r[2])) for n, r in zip(problem.frame.names, rows, strict=True)} | units
    return {n: v for n, v in units.items() if sum(c != 0 for c in v.components) > 1}


def unit_along(vector: Vector, units: Directions) -> sp.Expr | None:
    """e or −e, where a vector is that; None where it is neither."""
    for name, unit in units.items():
        for sign in (1, -1):
            if all(is_zero(c) is True for c in (vector.fixed() - unit * sp.Integer(sign)).components):
                return sign * VectorSymbol(name)
    return None


def in_named_directions(vector: Vector, units: Directions) -> Vector | sp.Expr:
    """The vector as c n + w, as a sum of two such multiples, or by three vectors; unchanged if none is shorter."""
    if sum(c != 0 for c in vector.components) < 2 or _length(vector) > LONGEST_IN_DIRECTIONS:
        return vector
    units = {n: u for n, u in units.items() if n not in vector.triad.names}
    if not units:
        return vector
    forms = [_along(vector, triad) for triad in _triads(units)]
    forms += [e for e in (_by_two(vector, units),) if e is not None]
    best = min(forms, key=count_operations, default=None)
    return vector if best is None or count_operations(best) >= _length(vector) else best


def _by_two(vector: Vector, units: Directions) -> sp.Expr | None:
    """c n + w with one or two named vectors n; None where w would be in two kinds of directions."""
    left, terms = vector.fixed(), sp.S.Zero
    for _ in range(2):
        along = [(factor, name, rest) for name, unit in units.items() for factor, rest in _splits(left, unit)]
        factor, name, rest = min(along, key=lambda split: count_operations(split[0]) + _length(split[2]))
        if factor != 0:
            left, terms = rest, terms + _collected(factor) * VectorSymbol(name)
    beside = [c for c in left.components if c != 0]
    if len(beside) > 1 and any(c.has(sp.sin, sp.cos) for c in beside):
        return None  # in two kinds of directions that turn it would be no clearer
    return terms + left.as_sum() if terms != 0 else None


def _triads(units: Directions) -> Iterator[dict[sp.Symbol, Vector]]:
    """Three perpendicular unit vectors, at least two of them named: with i, j or k the directions of a cylinder."""
    named: dict[sp.Symbol, Vector] = {VectorSymbol(n): u.fixed() for n, u in units.items()}
    axes: dict[sp.Symbol, Vector] = {
        unit: Vector(tuple(sp.Integer(k == n) for k in range(3))) for n, unit in enumerate(FIXED.units)
    }
    for a, b in combinations(named, 2):
        if is_zero(named[a].dot(named[b])) is not True:
            continue
        for c, third in {**named, **axes}.items():
            if c not in (a, b) and all(is_zero(third.dot(named[u])) is True for u in (a, b)):
                yield {a: named[a], b: named[b], c: third}
                break


def _along(vector: Vector, triad: Mapping[sp.Symbol, Vector]) -> sp.Expr:
    """Σ (v·e) e."""
    fixed = vector.fixed()
    return sp.Add(*(textbook_form(fixed.dot(e)) * unit for unit, e in triad.items()))


def _collected(factor: sp.Expr) -> sp.Expr:
    """(R − a) θ'' for R θ'' − a θ'': what all terms share in front, where only parameters are left in brackets."""
    made = with_common_factor(factor)
    sums = [f for f in sp.Mul.make_args(made) if f.is_Add]
    return made if made.is_Mul and all(s.is_positive for f in sums for s in f.free_symbols) else factor


def _length(vector: Vector) -> int:
    return sum(count_operations(c) + (c != 0) for c in vector.components)


def _splits(vector: Vector, unit: Vector) -> Iterator[tuple[sp.Expr, Vector]]:
    """Pairs c, w of a vector c n + w, where w lacks a component: c = v_k/n_k; and none, c = 0."""
    yield sp.S.Zero, vector
    pairs = [(v, n) for v, n in zip(vector.components, unit.components, strict=True) if v != 0 and n != 0]
    factors = [*(sp.cancel(v / n) for v, n in pairs), *(_share(v, n) for v, n in pairs)]
    for factor in dict.fromkeys([*factors, textbook_form(vector.dot(unit))]):
        if not all(s.is_positive for s in sp.fraction(sp.together(factor))[1].free_symbols):
            continue
        rest = (vector - unit * factor).map(lambda c: sp.S.Zero if is_zero(c) is True else textbook_form(c))
        yield factor, rest


def _share(whole: sp.Expr, part: sp.Expr) -> sp.Expr:
    """The coefficient of sin θ in x − b sin θ, over the sign that sin θ has in the unit vector."""
    sign, core = part.as_coeff_Mul()
    return sp.expand(whole).coeff(core) / sign
