"""The derived flag of a distribution at one point, in jets.

A system of Pfaffian forms leaves the distribution D_0 = {X : ω_j(X) = 0}. Brackets are added until nothing
new comes,

    D_{k+1} = D_k + [D_k, D_k],       rank of the k-th derived system = dim - rank D_k,

and what annihilates the last one is the largest integrable subsystem (Cartan 1910; Bryant et al., Exterior
Differential Systems, II.4). Every D_k has a basis X_a = ∂_a + Σ_p c_pa ∂_p, a free, p bound, in which a
bracket has bound components only:

    [X_a, X_b] = Σ_p (X_a c_pb - X_b c_pa) ∂_p .

The slopes c are jets at a generic point. A bracket costs one order, so that order d decides d steps; which
brackets are independent is read off their constant terms, and only those are computed further.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.forms.jets import BITS, Jet, Ring, constant_term, is_zero_jet, terms_in, truncated
from lagrange.core.records import record

Matrix = list[list[Jet]]


@record
class Distribution:
    """Fields X_a = ∂_a + Σ_p slopes[p, a] ∂_p, for a in `free` and p in `bound` (numbers of jet variables).

    `new` are the fields that the last step added: only brackets with these can lead further.
    """

    free: tuple[int, ...]
    bound: tuple[int, ...]
    slopes: dict[tuple[int, int], Jet]
    order: int
    new: tuple[int, ...]


def kernel(ring: Ring, rows: Matrix, columns: Sequence[int], order: int) -> Distribution:
    """The distribution annihilated by forms, rows of shape (m, c); `columns` (c,) number the jet variables.

    A later column is bound only where an earlier one cannot be.
    """
    reduced, pivots = echelon(ring, rows)
    bound = tuple(columns[k] for k in pivots)
    free = tuple(c for k, c in enumerate(columns) if k not in pivots)
    slopes = {
        (p, c): ring.scale(row[k], -1)
        for p, row in zip(bound, reduced, strict=True)
        for k, c in enumerate(columns)
        if k not in pivots
    }
    return Distribution(free, bound, slopes, order, free)


def derived(ring: Ring, d: Distribution) -> Distribution | None:
    """D + [D, D], of one order less; None where the order does not suffice to say."""
    if not d.bound:
        return d
    if d.order == 0:
        return None if any(True for _ in _pairs(d)) else d
    pairs = _independent_brackets(ring, d)
    if not pairs:
        return Distribution(d.free, d.bound, d.slopes, d.order, ())
    order = d.order - 1
    rows = [[_bracket(ring, d, a, b, p, order) for p in d.bound] for a, b in pairs]
    reduced, pivots = echelon(ring, rows)
    added = tuple(d.bound[k] for k in pivots)
    bound = tuple(p for p in d.bound if p not in added)
    slopes: dict[tuple[int, int], Jet] = {}
    for k, p in enumerate(d.bound):
        if p in added:
            continue
        for s, row in zip(added, reduced, strict=True):
            slopes[p, s] = row[k]
        for a in d.free:
            moved = [(d.slopes[s, a], slopes[p, s]) for s in added]
            through = ring.sum_of_products(moved, order)
            slopes[p, a] = ring.subtract(truncated(d.slopes[p, a], order), through)
    return Distribution((*d.free, *added), bound, slopes, order, added)


def echelon(ring: Ring, rows: Matrix) -> tuple[Matrix, tuple[int, ...]]:
    """Reduced rows and their pivot columns; rows that depend on the others at the point are dropped.

    Pivots with few terms are taken first, and earlier columns before the last one (time).
    """
    remaining, done, pivots = [list(r) for r in rows], Matrix(), list[int]()
    while place := _pivot(remaining):
        n, k = place
        row = remaining.pop(n)
        inverse = ring.inverse(row[k])
        row = [ring.multiply(inverse, entry) for entry in row]
        row[k] = ring.constant(ring.arithmetic.number(1), len(inverse) - 1)
        remaining = [_cleared(ring, other, row, k) for other in remaining]
        done = [_cleared(ring, other, row, k) for other in done]
        done.append(row)
        pivots.append(k)
    return done, tuple(pivots)


def _pivot(rows: Matrix) -> tuple[int, int] | None:
    candidates = [
        (k == len(row) - 1, terms_in(entry), n, k)
        for n, row in enumerate(rows)
        for k, entry in enumerate(row)
        if constant_term(entry)
    ]
    return min(candidates)[2:] if candidates else None


def _cleared(ring: Ring, row: list[Jet], by: list[Jet], k: int) -> list[Jet]:
    factor = row[k]
    if is_zero_jet(factor):
        return row
    return [e if is_zero_jet(b) else ring.subtract(e, ring.multiply(factor, b)) for e, b in zip(row, by, strict=True)]


def _pairs(d: Distribution) -> Iterator[tuple[int, int]]:
    """The pairs of fields whose bracket may be new."""
    yield from combinations(d.new, 2)
    for a in d.new:
        yield from ((a, b) for b in d.free if b not in d.new)


def _independent_brackets(ring: Ring, d: Distribution) -> list[tuple[int, int]]:
    """Pairs of fields whose brackets are independent at the point."""
    pairs = list(_pairs(d))
    columns = [[_bracket_at_point(d, a, b, p) for a, b in pairs] for p in d.bound]
    _, pivots = row_reduced(ring.arithmetic, columns)
    return [pairs[k] for k in pivots]


def _bracket(ring: Ring, d: Distribution, a: int, b: int, p: int, order: int) -> Jet:
    """The component X_a c_pb - X_b c_pa of a bracket, to the given order."""
    products = [*_rate(ring, d, a, d.slopes[p, b]), *_rate(ring, d, b, ring.scale(d.slopes[p, a], -1))]
    return ring.sum_of_products(products, order)


def _rate(ring: Ring, d: Distribution, a: int, f: Jet) -> Iterator[tuple[Jet, Jet]]:
    """The products whose sum is X_a f."""
    if not any(f[1:]):
        return
    yield ring.constant(ring.arithmetic.number(1), 0), ring.derivative(f, a)
    for q in d.bound:
        slope = d.slopes[q, a]
        if not is_zero_jet(slope):
            change = ring.derivative(f, q)
            if not is_zero_jet(change):
                yield slope, change


def _bracket_at_point(d: Distribution, a: int, b: int, p: int) -> Any:
    return _rate_at_point(d, a, d.slopes[p, b]) - _rate_at_point(d, b, d.slopes[p, a])


def _rate_at_point(d: Distribution, a: int, f: Jet) -> Any:
    gradient = f[1]
    if not gradient:
        return 0
    through = (constant_term(d.slopes[q, a]) * gradient.get(1 << BITS * q, 0) for q in d.bound)
    return gradient.get(1 << BITS * a, 0) + sum(through)
