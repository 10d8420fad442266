"""The derived flag of a system of constraints: how many independent finite relations it implies.

A system of Pfaffian forms leaves the distribution D_0 = {X : ω_j(X) = 0}. Brackets are added until nothing new arises,

    D_{k+1} = D_k + [D_k, D_k],       rank of the k-th derived system = dim − rank D_k,

and the annihilator of the last one is the largest integrable subsystem (Cartan 1910; Bryant et al., Exterior
Differential Systems, II.4). Every D_k has a basis X_a = ∂_a + Σ_p c_pa ∂_p, a free, p bound, in which a bracket has
bound components only: [X_a, X_b] = Σ_p (X_a c_pb − X_b c_pa) ∂_p. The slopes c are jets at a generic point of the
surface of the geometric constraints (`charts`). A bracket costs one order, so that order d decides d steps.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.zero_test import (
    Point,
    Surface,
)
from lagrange.algebra.forms.charts import (
    JetMatrix,
    agreed_on_surface,
    chart,
    pulled_back,
    surface_of,
)
from lagrange.algebra.forms.hidden_relations import Flag
from lagrange.algebra.forms.jets import (
    BITS,
    Jet,
    JetRing,
    WorkLimitError,
    constant_term,
    is_zero_jet,
    terms_in,
    truncated,
)
from lagrange.algebra.forms.limits import (
    FLAG_WORK,
    HIGHEST_FLAG_ORDER,
    LONGEST_DIRECTION,
)
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots


def derived_flag(
    forms: Sequence[Sequence[sp.Expr]],
    slots: Slots,
    geometric: Sequence[sp.Expr] | Surface = (),
    *,
    modulo: Sequence[Sequence[sp.Expr]] = (),
    highest_order: int = HIGHEST_FLAG_ORDER,
    work_limit: int = FLAG_WORK,
) -> Flag:
    """The derived flag of all constraints together, at generic points of the geometric ones.

    forms      (m, n + 1): coefficients of dq_1 ... dq_n, dt; rows of geometric constraints may be among them
    geometric  functions f(q, t) whose vanishing is the geometric constraints, or their surface
    modulo     (k, n + 1): forms that vanish as well and are not counted: the ranks are those of I + E less that of E,
               I being a derived system of all the forms and E the span of these

    Random points must agree. Undecided where no point is found, an expression has no Taylor series, or the
    limits on order and work (products of coefficients, all points together) are reached.
    """
    surface = surface_of(geometric, slots)
    rows = _beyond(surface.constraints, [tuple(sp.sympify(a, strict=True) for a in form) for form in forms], slots)
    others = [tuple(form) for form in modulo]
    left = work_limit

    def at(point: Point, finite: Sequence[sp.Expr]) -> Flag:
        nonlocal left
        if not rows:
            return Flag((len(finite),), len(finite))
        ring = JetRing(point.arithmetic, left)
        try:
            flag = _flag_at(ring, point, rows, others, slots, finite, highest_order)
        finally:
            left -= ring.work
        # A limit of order or work is reached at every generic point alike: no need to try another one.
        if flag.integrable_rank is None:
            raise _OpenFlagError(flag)
        return flag

    try:
        return agreed_on_surface(
            at, [a for row in (*rows, *others) for a in row], surface, slots, lambda why: Flag((), None, why)
        )
    except _OpenFlagError as error:
        return error.flag


def _flag_at(
    ring: JetRing,
    point: Point,
    forms: Sequence[Sequence[sp.Expr]],
    modulo: Sequence[Sequence[sp.Expr]],
    slots: Slots,
    geometric: Sequence[sp.Expr],
    highest_order: int,
) -> Flag:
    """The flag at one point, with as high an order as it takes."""
    # The order needed is not known beforehand, and the work grows steeply with it: so the lowest that decides.
    best: list[int] = []
    for order in range(1, highest_order + 1):
        ranks: list[int] = []
        try:
            # Pulling back differentiates the chart, which costs one order.
            local = chart(ring, point, geometric, slots, order + 1 if geometric else order)
            others = pulled_back(ring, local, modulo)
            d: Distribution | None = kernel(ring, [*pulled_back(ring, local, forms), *others], local.free, order)
            last = -1
            while d is not None:
                total = len(local.graph) + len(d.bound)
                if total == last:
                    return Flag(tuple(ranks), ranks[-1], beside=total - ranks[-1])
                last = total
                ranks.append(total - _rank_lost(ring, d, others, local.free) if others else total)
                d = derived(ring, d)
        except WorkLimitError:
            best = ranks if len(ranks) > len(best) else best
            return Flag(tuple(best), None, "the computation would be too large")
        best = ranks
    return Flag(tuple(best), None, f"brackets of more than {highest_order} levels would be needed")


def _rank_lost(ring: JetRing, d: Distribution, forms: Sequence[Sequence[Jet]], columns: Sequence[int]) -> int:
    """dim (I ∩ E) at the point: the rank of the forms E, less that of E restricted to the fields annihilated by I."""
    values = [dict(zip(columns, map(constant_term, form), strict=True)) for form in forms]
    along = [[e[a] + sum(e[p] * constant_term(d.slopes[p, a]) for p in d.bound) for a in d.free] for e in values]
    full = row_reduced(ring.arithmetic, [[*e.values()] for e in values])[1]
    return len(full) - len(row_reduced(ring.arithmetic, along)[1])


class _OpenFlagError(Exception):
    """A flag that a limit left undecided; no other point would do better."""

    def __init__(self, flag: Flag) -> None:
        super().__init__(flag.reason)
        self.flag = flag


def _beyond(
    constraints: Sequence[sp.Expr], rows: Sequence[tuple[sp.Expr, ...]], slots: Slots
) -> list[tuple[sp.Expr, ...]]:
    """The rows that are not written as the differential of a geometric constraint."""
    # On the surface df vanishes identically: such rows are counted with the surface, not again.
    known = set()
    for f in constraints:
        symbols = f.free_symbols
        gradient = (sp.diff(f, q) if q in symbols else sp.S.Zero for q in slots.coordinates)
        known.add((*gradient, slots.frozen_derivative(f)))
    return [row for row in rows if row not in known and any(row)]


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
    """D + [D, D], of one order less; None if the order does not suffice."""
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


# -- A manoeuvre: two displacements and both back again, which leave the commutator of two admitted directions ---------
#
# For ω = a dx + b dy + c dz let X and Y be directions with ω(X) = ω(Y) = 0. To go ε along X, ε along Y, back along X
# and back along Y ends ε² [X, Y] from the start, up to higher orders, with [X, Y] = (X·∇) Y − (Y·∇) X. Since
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
