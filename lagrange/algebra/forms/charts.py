"""Charts of the surface of the geometric constraints, in jets, and what its random points have in common.

Geometric constraints hold at all times, so that ranks and Frobenius' condition are taken on their surface: with z = 0
the form dx + y z du is dx. Near a regular point of f(q, t) = 0 the surface is a graph q_p(u) over the other
coordinates, those p in whose columns ∂f/∂q has its pivots. Their Taylor series come from Newton's iteration with the
Jacobian J of the point,

    q_p <- q_p − J⁻¹ f(q_p, u),

which gains one order a step, and ω = Σ ω_i dq_i becomes Σ_a (ω_a + Σ_p ω_p ∂q_p/∂u_a) du_a. Where ∂f/∂q has a lower
rank than the codimension of f = 0, as for (x − y)² = 0, there is no such chart.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import sympy as sp

from lagrange.algebra.exact.expression_graph import SIGNED
from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.points_needed import (
    FLAG_POINTS,
    FLAG_POINTS_AFTER_ROOTS,
    FLAG_POINTS_WITH_SIGNS,
    FLAG_REAL_POINTS,
    FLAG_REAL_POINTS_WITH_SIGNS,
    ZERO_POINTS,
)
from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    NoPointError,
    Point,
    Surface,
    UnsupportedError,
)
from lagrange.algebra.forms.jets import (
    BITS,
    Expansion,
    Jet,
    JetRing,
    NoExpansionError,
    WorkLimitError,
    truncated,
)
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Slots, t

JetMatrix = list[list[Jet]]
T = TypeVar("T")


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


def surface_of(geometric: Sequence[sp.Expr] | Surface, slots: Slots) -> Surface:
    """The surface of geometric constraints, which may be given as one."""
    return geometric if isinstance(geometric, Surface) else Surface(geometric, slots.coordinates)


def agreed_on_surface(
    evaluate: Callable[[Point, Sequence[sp.Expr]], T],
    expressions: Sequence[sp.Expr],
    surface: Surface,
    slots: Slots,
    undecided: Callable[[str], T],
) -> T:
    """The common answer of random points, if they agree; of real ones too where values have branches or are opaque."""
    everything = (*surface.constraints, *expressions)
    try:
        # A jet takes its roots and signs from the point, on one branch: ranks may differ between branches.
        marks = {surface.graph.marks[surface.graph.node(e)] for e in everything}
        signs = any(isinstance(s, Sign) for e in everything for s in e.free_symbols)
        branches = signs or any(mark & SIGNED for mark in marks)
        count = FLAG_POINTS_WITH_SIGNS if branches else FLAG_POINTS_AFTER_ROOTS if _has_roots(surface) else FLAG_POINTS
        finite = independent_constraints(surface, slots)
        results = surface.sampled(lambda point: evaluate(point, finite), count if expressions else 1)
        if surface.exact and any(marks):
            reals = FLAG_REAL_POINTS_WITH_SIGNS if branches else FLAG_REAL_POINTS
            results += surface.sampled(lambda point: evaluate(point, finite), reals, real=True)
    except (UnsupportedError, NoExpansionError) as error:
        return undecided(f"there is no Taylor series of {error}")
    except (NoPointError, DivisionByZeroError):
        return undecided("no point was found where the geometric constraints hold")
    except SingularSurfaceError:
        return undecided("the geometric constraints are not regular where they hold")
    except WorkLimitError:
        return undecided("the computation would be too large")
    if all(other == results[0] for other in results):
        return results[0]
    return undecided("different points of the constraint surface give different answers")


def _has_roots(surface: Surface) -> bool:
    """Whether points of the surface are chosen between several: the sphere has two over every (x, y)."""
    return bool(surface.constraints) and (surface.order is None or bool(surface.order.roots))
