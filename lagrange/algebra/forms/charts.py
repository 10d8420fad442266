"""The surface of the geometric constraints as a graph, in jets, and forms pulled back to it.

Near a regular point of f(q, t) = 0 some coordinates q_p are functions of the others: those in whose columns
∂f/∂q has its pivots. Their Taylor series come from Newton's iteration with the Jacobian J of the point,

    q_p <- q_p - J^{-1} f(q_p, u),

which gains one order a step. A form ω = Σ ω_i dq_i becomes Σ_a (ω_a + Σ_p ω_p ∂q_p/∂u_a) du_a. Where the
rank of ∂f/∂q is less than the codimension of f = 0, as for (x - y)² = 0, no such chart exists.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from lagrange.algebra.exact.exact import Point, Surface
from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.forms.flags import Matrix
from lagrange.algebra.forms.jets import BITS, Jet, Ring, truncated
from lagrange.algebra.forms.taylor import Expansion
from lagrange.core.records import record
from lagrange.core.symbols import Slots, t


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
        ring = Ring(point.arithmetic)
        linear = _expansion(ring, point, {}, slots, 1)
        columns = zip(*_jacobian(linear, constraints, len(slots.coordinates) + 1), strict=True)
        return row_reduced(point.arithmetic, list(columns))[1]

    places = max(surface.sampled(kept, 2), key=len) if constraints else []
    independent = tuple(constraints[k] for k in places)
    if len(independent) < len(constraints):
        others = Surface(independent, surface.coordinates, fields=surface.fields)
        if not all(others.is_zero(f) for f in constraints):
            raise SingularSurfaceError
    return independent


def chart(ring: Ring, point: Point, geometric: Sequence[sp.Expr], slots: Slots, order: int) -> Chart:
    """The chart of f = 0, gradients independent, at a point on it. Raises SingularSurfaceError."""
    n = len(slots.coordinates)
    start = {k: ring.constant(point.value(q), 0) for k, q in enumerate(slots.coordinates)}
    inverse = _inverse_jacobian(ring, _expansion(ring, point, {}, slots, 1), geometric, n)
    bound = {k: start[k] for k in inverse}
    for m in range(1, order + 1 if bound else 1):
        bound = {k: (*jet, {}) for k, jet in bound.items()}
        there = _expansion(ring, point, bound, slots, m)
        residuals = [there(f) for f in geometric]
        for k, row in inverse.items():
            for factor, residual in zip(row, residuals, strict=True):
                bound[k] = ring.subtract(bound[k], ring.scale(residual, factor))
    free = tuple(k for k in range(n + 1) if k not in bound)
    return Chart(_expansion(ring, point, bound, slots, order), free, tuple(bound.items()))


def pulled_back(ring: Ring, chart: Chart, forms: Sequence[Sequence[sp.Expr]]) -> Matrix:
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


def _expansion(ring: Ring, point: Point, bound: dict[int, Jet], slots: Slots, order: int) -> Expansion:
    """Expressions about a point in all variables, but for bound ones, which have their own jets."""
    symbols = (*slots.coordinates, t)
    jets = {q: bound[k] if k in bound else ring.variable(k, point.value(q), order) for k, q in enumerate(symbols)}
    return Expansion(ring, point.value, jets, slots.prescribed)


def _jacobian(linear: Expansion, constraints: Sequence[sp.Expr], width: int) -> list[list[Any]]:
    """The matrix ∂f/∂(q, t) at the point, shape (m, width)."""
    gradients = [linear(f)[1] for f in constraints]
    return [[g.get(1 << BITS * k, 0) for k in range(width)] for g in gradients]


def _inverse_jacobian(ring: Ring, linear: Expansion, constraints: Sequence[sp.Expr], n: int) -> dict[int, list[Any]]:
    """For each of m bound coordinates its row of the inverse of their part of ∂f/∂q, shape (m,)."""
    rows = _jacobian(linear, constraints, n)
    m = len(rows)
    extended = [[*row, *(int(i == j) for j in range(m))] for i, row in enumerate(rows)]
    reduced, pivots = row_reduced(ring.arithmetic, extended)
    if any(k >= n for k in pivots):
        raise SingularSurfaceError
    return {k: row[n:] for k, row in zip(pivots, reduced, strict=True)}
