"""The derived flag of a distribution at one point, in jets, on the surface of the geometric constraints.

A system of Pfaffian forms leaves the distribution D_0 = {X : ω_j(X) = 0}. Brackets are added until nothing new arises,

    D_{k+1} = D_k + [D_k, D_k],       rank of the k-th derived system = dim − rank D_k,

and the annihilator of the last one is the largest integrable subsystem (Cartan 1910; Bryant et al., Exterior
Differential Systems, II.4). Every D_k has a basis X_a = ∂_a + Σ_p c_pa ∂_p, a free, p bound, in which a bracket has
bound components only: [X_a, X_b] = Σ_p (X_a c_pb − X_b c_pa) ∂_p. The slopes c are jets at a generic point. A bracket
costs one order, so that order d decides d steps.

Near a regular point of f(q, t) = 0 the surface is a graph q_p(u) over the other coordinates, those p in whose columns
∂f/∂q has its pivots. Their Taylor series come from Newton's iteration with the Jacobian J of the point,
q_p <- q_p − J⁻¹ f(q_p, u), which gains one order a step, and ω = Σ ω_i dq_i becomes Σ_a (ω_a + Σ_p ω_p ∂q_p/∂u_a) du_a.
Where ∂f/∂q has a lower rank than the codimension of f = 0, as for (x − y)² = 0, there is no such chart.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.points_needed import ZERO_POINTS
from lagrange.algebra.exact.zero_test import Point, Surface
from lagrange.algebra.forms.jets import BITS, Expansion, Jet, JetRing, constant_term, is_zero_jet, terms_in, truncated
from lagrange.algebra.forms.limits import LONGEST_DIRECTION
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, t

JetMatrix = list[list[Jet]]


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


def kernel(ring: JetRing, rows: JetMatrix, columns: Sequence[int], order: int) -> Distribution:
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


def derived(ring: JetRing, d: Distribution) -> Distribution | None:
    """D + [D, D], of one order less; None where the order does not suffice."""
    if not d.bound:
        return d
    if d.order == 0:
        return None if any(True for _ in _pairs(d)) else d
    # Which brackets are independent is seen from their constant terms; only those are computed to higher order.
    pairs = _independent_brackets(ring, d)
    if not pairs:
        return Distribution(d.free, d.bound, d.slopes, d.order, ())
    order = d.order - 1
    rows = [[_bracket(ring, d, a, b, p, order) for p in d.bound] for a, b in pairs]
    # The brackets are solved for part of the bound directions, which become free; subtracted from the old fields, they
    # leave the form ∂_a + Σ c_pa ∂_p with fewer p.
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


def echelon(ring: JetRing, rows: JetMatrix) -> tuple[JetMatrix, tuple[int, ...]]:
    """Reduced rows and their pivot columns; rows that depend on the others at the point are dropped.

    Pivots with few terms are taken first, and earlier columns before the last one (time).
    """
    # Dense jets make dense products: a pivot with few terms keeps the rows sparse. Time is bound only where no
    # coordinate can be.
    remaining, done, pivots = [list(r) for r in rows], JetMatrix(), list[int]()
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


def _pivot(rows: JetMatrix) -> tuple[int, int] | None:
    candidates = [
        (k == len(row) - 1, terms_in(entry), n, k)
        for n, row in enumerate(rows)
        for k, entry in enumerate(row)
        if constant_term(entry)
    ]
    return min(candidates)[2:] if candidates else None


def _cleared(ring: JetRing, row: list[Jet], by: list[Jet], k: int) -> list[Jet]:
    factor = row[k]
    if is_zero_jet(factor):
        return row
    return [e if is_zero_jet(b) else ring.subtract(e, ring.multiply(factor, b)) for e, b in zip(row, by, strict=True)]


def _pairs(d: Distribution) -> Iterator[tuple[int, int]]:
    """The pairs of fields whose bracket may be new."""
    yield from combinations(d.new, 2)
    for a in d.new:
        yield from ((a, b) for b in d.free if b not in d.new)


def _independent_brackets(ring: JetRing, d: Distribution) -> list[tuple[int, int]]:
    """Pairs of fields whose brackets are independent at the point."""
    pairs = list(_pairs(d))
    columns = [[_bracket_at_point(d, a, b, p) for a, b in pairs] for p in d.bound]
    _, pivots = row_reduced(ring.arithmetic, columns)
    return [pairs[k] for k in pivots]


def _bracket(ring: JetRing, d: Distribution, a: int, b: int, p: int, order: int) -> Jet:
    """The component X_a c_pb - X_b c_pa of a bracket, to the given order."""
    products = [*_rate(ring, d, a, d.slopes[p, b]), *_rate(ring, d, b, ring.scale(d.slopes[p, a], -1))]
    return ring.sum_of_products(products, order)


def _rate(ring: JetRing, d: Distribution, a: int, f: Jet) -> Iterator[tuple[Jet, Jet]]:
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


class SingularSurfaceError(Exception):
    """The constraints are not regular at the point."""


@record
class Chart:
    """Jets on the constraint surface.

    expansion  expressions in the free coordinates
    free       numbers of the free coordinates, ascending; coordinate n is t
    graph      for each bound coordinate its number and its jet
    """

    expansion: Expansion
    free: tuple[int, ...]
    graph: tuple[tuple[int, Jet], ...]


def independent_constraints(surface: Surface, slots: Slots) -> tuple[sp.Expr, ...]:
    """Constraints with independent gradients that cut out the whole surface. Raises SingularSurfaceError.

    Those whose gradients depend on others must vanish where the others do: 2 f = 0 follows from f = 0, but
    (x - y)² = 0 from nothing, though its gradient is 0.
    """
    constraints = surface.constraints

    def kept(point: Point) -> list[int]:
        ring = JetRing(point.arithmetic)
        linear = _expansion(ring, point, {}, slots, 1)
        columns = zip(*_jacobian(linear, constraints, len(slots.coordinates) + 1), strict=True)
        return row_reduced(point.arithmetic, list(columns))[1]

    places = max(surface.sampled(kept, ZERO_POINTS), key=len) if constraints else []
    independent = tuple(constraints[k] for k in places)
    if len(independent) < len(constraints):
        others = Surface(independent, surface.coordinates, fields=surface.fields)
        if not all(others.is_zero(f) for f in constraints):
            raise SingularSurfaceError
    return independent


def chart(ring: JetRing, point: Point, geometric: Sequence[sp.Expr], slots: Slots, order: int) -> Chart:
    """The chart of f = 0, gradients independent, at a point on it. Raises SingularSurfaceError."""
    n = len(slots.coordinates)
    start = {k: ring.constant(point.value(q), 0) for k, q in enumerate(slots.coordinates)}
    inverse = _inverse_jacobian(ring, _expansion(ring, point, {}, slots, 1), geometric, n)
    bound = {k: start[k] for k in inverse}
    # The Jacobian at the point serves in every step: the error is of one order more each time.
    for m in range(1, order + 1 if bound else 1):
        bound = {k: (*jet, {}) for k, jet in bound.items()}
        expansion = _expansion(ring, point, bound, slots, m)
        residuals = [expansion(f) for f in geometric]
        for k, row in inverse.items():
            for factor, residual in zip(row, residuals, strict=True):
                bound[k] = ring.subtract(bound[k], ring.scale(residual, factor))
    free = tuple(k for k in range(n + 1) if k not in bound)
    return Chart(_expansion(ring, point, bound, slots, order), free, tuple(bound.items()))


def pulled_back(ring: JetRing, chart: Chart, forms: Sequence[Sequence[sp.Expr]]) -> JetMatrix:
    """Forms (m, n + 1) as jets (m, free) on the surface; one order is lost where there are constraints."""
    rows = []
    order = chart.expansion.order - 1 if chart.graph else chart.expansion.order
    for form in forms:
        jets = [chart.expansion(a) for a in form]
        row = []
        for a in chart.free:
            through = ((jets[p], ring.derivative(q, a)) for p, q in chart.graph)
            row.append(ring.add(truncated(jets[a], order), ring.sum_of_products(through, order)))
        rows.append(row)
    return rows


def _expansion(ring: JetRing, point: Point, bound: dict[int, Jet], slots: Slots, order: int) -> Expansion:
    """Expressions about a point in all variables, except bound ones, which have their own jets."""
    symbols = (*slots.coordinates, t)
    jets = {q: bound[k] if k in bound else ring.variable(k, point.value(q), order) for k, q in enumerate(symbols)}
    return Expansion(ring, point.value, jets, slots.prescribed)


def _jacobian(linear: Expansion, constraints: Sequence[sp.Expr], width: int) -> list[list[Any]]:
    """The matrix ∂f/∂(q, t) at the point, shape (m, width)."""
    gradients = [linear(f)[1] for f in constraints]
    return [[g.get(1 << BITS * k, 0) for k in range(width)] for g in gradients]


def _inverse_jacobian(ring: JetRing, linear: Expansion, constraints: Sequence[sp.Expr], n: int) -> dict[int, list[Any]]:
    """For each of m bound coordinates its row of the inverse of their part of ∂f/∂q, shape (m,)."""
    rows = _jacobian(linear, constraints, n)
    m = len(rows)
    extended = [[*row, *(int(i == j) for j in range(m))] for i, row in enumerate(rows)]
    reduced, pivots = row_reduced(ring.arithmetic, extended)
    if any(k >= n for k in pivots):
        raise SingularSurfaceError
    return {k: row[n:] for k, row in zip(pivots, reduced, strict=True)}


# -- What two displacements and both back again leave: the commutator of two directions that a form admits -------------
#
# For ω = a dx + b dy + c dz let X and Y be directions with ω(X) = ω(Y) = 0. To go ε along X, ε along Y, back along X
# and
# back along Y ends ε² [X, Y] from the start, up to higher orders, with [X, Y] = (X·∇) Y − (Y·∇) X. Since
# ω([X, Y]) = −dω(X, Y), where ω ∧ dω is not zero, this is a direction that the form forbids at every single step.


Direction = tuple[sp.Expr, ...]


@record
class Manoeuvre:
    """Two admitted directions, and what going along both and back along both leaves."""

    first: Direction
    second: Direction
    left_over: Direction


def manoeuvre(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol]) -> Manoeuvre | None:
    """For a form in three variables with one coefficient 0 and short others; None for any other."""
    if (
        len(variables) != 3
        or sum(a == 0 for a in form) != 1
        or sum(count_operations(a) for a in form) > LONGEST_DIRECTION
    ):
        return None
    n = next(k for k, a in enumerate(form) if a == 0)
    m, k = (j for j in range(3) if j != n)
    first = [sp.S.Zero] * 3
    first[m], first[k] = -form[k], form[m]
    second = [sp.S.Zero] * 3
    second[n] = sp.S.One
    if first[m].could_extract_minus_sign() and not first[k].is_number:
        first = [-a for a in first]
    left = [
        sum((x * b.diff(v) - y * a.diff(v) for v, x, y in zip(variables, first, second, strict=True)), sp.S.Zero)
        for a, b in zip(first, second, strict=True)
    ]
    return Manoeuvre(tuple(first), tuple(second), tuple(map(sp.expand, left)))
