"""Integrability: which constraints are finite relations in disguise.

A form ω = Σ a_i dq_i + a_t dt (t counts as a coordinate here) is exact if ∂a_i/∂q_k = ∂a_k/∂q_i for all pairs, and then
ω = df. It is integrable if ω = μ df; by Frobenius' theorem this holds if and only if

    ω ∧ dω = Σ_{i<j<k} c_ijk dq_i ∧ dq_j ∧ dq_k = 0,
    c_ijk = a_i (∂_j a_k − ∂_k a_j) + a_j (∂_k a_i − ∂_i a_k) + a_k (∂_i a_j − ∂_j a_i).

Exact implies integrable; y dx − x dy shows that the converse fails. Several constraints may imply finite relations that
none of them shows: the derived flag counts them (`derived_flag`).

Geometric constraints hold at all times, so that ranks and Frobenius' condition are taken on their surface: with z = 0
the form dx + y z du is dx. There, at a generic point in a prime field, the surface is written as a graph over some of
the coordinates, all as jets, and the forms are pulled back to it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations
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
)
from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    NoPointError,
    Point,
    Surface,
    UnsupportedError,
    is_zero,
)
from lagrange.algebra.forms.derived_flag import (
    Distribution,
    SingularSurfaceError,
    chart,
    derived,
    independent_constraints,
    kernel,
    pulled_back,
)
from lagrange.algebra.forms.exact_forms import differentiated
from lagrange.algebra.forms.jets import BITS, Jet, JetRing, NoExpansionError, WorkLimitError, constant_term
from lagrange.algebra.forms.limits import FLAG_WORK, HIGHEST_FLAG_ORDER, LONGEST_TIDIED_COMPONENT, LONGEST_TIDIED_FORM
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Slots
from lagrange.core.verdicts import all_hold

T = TypeVar("T")


@record
class Flag:
    """The derived flag of a system of constraints.

    ranks            of the system, of its first derived system, ..., as far as they were found
    integrable_rank  number of independent finite relations in the constraints (the last rank), or None
    reason           why it is undecided
    beside           number of finite relations in which only forms take part modulo which the ranks are taken
    """

    ranks: tuple[int, ...]
    integrable_rank: int | None
    reason: str = ""
    beside: int = 0

    @property
    def bound(self) -> int | None:
        """An upper bound of `integrable_rank`, None where nothing is known."""
        return self.ranks[-1] if self.ranks else None


@record
class PartialsComparison:
    """∂a/∂k = ∂b/∂i, for the coefficients a of di and b of dk; `equal` is None where it is undecided."""

    variables: tuple[sp.Symbol, sp.Symbol]
    coefficients: tuple[sp.Expr, sp.Expr]
    derivatives: tuple[sp.Expr, sp.Expr]
    equal: bool | None


@record
class Exactness:
    """All pairs of partial derivatives of one form; `exact` is None where it depends on an undecided pair."""

    comparisons: tuple[PartialsComparison, ...]
    exact: bool | None

    @property
    def differing(self) -> tuple[PartialsComparison, ...]:
        """The pairs that differ."""
        return tuple(c for c in self.comparisons if c.equal is False)


@record
class WedgeComponent:
    """One component of ω ∧ dω: the coefficient of da ∧ db ∧ dc; `nonzero` is None where it is undecided."""

    variables: tuple[sp.Symbol, sp.Symbol, sp.Symbol]
    coefficient: sp.Expr
    nonzero: bool | None


def exactness(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> Exactness:
    """Every pair of partial derivatives of a form compared, as the chapter does it; not those of 0 with 0.

    form       (k,) coefficients of the differentials of `variables` (k,), t among them if there is a dt
    """
    comparisons = []
    for (q, a), (r, b) in combinations(zip(variables, form, strict=True), 2):
        if a == b == 0:
            continue
        left, right = differentiated(a, r, slots), differentiated(b, q, slots)
        equal = True if left == right else _compared(left - right)
        comparisons.append(PartialsComparison((q, r), (a, b), (left, right), equal))
    return Exactness(tuple(comparisons), all_hold(c.equal for c in comparisons))


def frobenius_form(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> tuple[WedgeComponent, ...]:
    """The components of ω ∧ dω, in the order of the variables; those written as 0 are left out."""
    components = []
    write = writer(form)
    indices = range(len(form))
    d = {(i, j): differentiated(form[j], variables[i], slots) for i in indices for j in indices if i != j}
    for i, j, k in combinations(indices, 3):
        cyclic = ((i, j, k), (j, k, i), (k, i, j))
        coefficient = write(sp.Add(*(form[a] * (d[b, c] - d[c, b]) for a, b, c in cyclic)))
        if coefficient != 0:
            zero = _compared(coefficient)
            triple = (variables[i], variables[j], variables[k])
            components.append(WedgeComponent(triple, coefficient, None if zero is None else not zero))
    return tuple(components)


def writer(form: Sequence[sp.Expr]) -> Callable[[sp.Expr], sp.Expr]:
    """How components of ω ∧ dω are written: in textbook form, unless that would be too long to read."""
    if sum(count_operations(a) for a in form) > LONGEST_TIDIED_FORM:
        return lambda coefficient: coefficient
    return lambda coefficient: (
        textbook_form(coefficient) if count_operations(coefficient) <= LONGEST_TIDIED_COMPONENT else coefficient
    )


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
    surface = _surface(geometric, slots)
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
        return _agreed(
            at, [a for row in (*rows, *others) for a in row], surface, slots, lambda why: Flag((), None, why)
        )
    except _OpenFlagError as error:
        return error.flag


def is_integrable(form: Sequence[sp.Expr], slots: Slots, geometric: Sequence[sp.Expr] | Surface = ()) -> bool | None:
    """Whether one form has an integrating factor on the geometric constraints: ω ∧ dω ∧ df_1 ∧ ... = 0.

    form       (n + 1,) coefficients of dq_1 ... dq_n, dt
    geometric  functions f(q, t) whose vanishing is the geometric constraints, or their surface
    """
    surface = _surface(geometric, slots)
    omega = [sp.sympify(a, strict=True) for a in form]

    def at(point: Point, finite: Sequence[sp.Expr]) -> bool | None:
        ring = JetRing(point.arithmetic, FLAG_WORK)
        local = chart(ring, point, finite, slots, 2 if finite else 1)
        (row,) = pulled_back(ring, local, [omega])
        return _is_frobenius(ring, row, local.free)

    return _agreed(at, omega, surface, slots, lambda _: None)


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


def _is_frobenius(ring: JetRing, row: Sequence[Jet], free: Sequence[int]) -> bool:
    """Whether ω ∧ dω = 0 at the point, from the first-order jets of ω."""
    a = [constant_term(jet) for jet in row]
    rates = [[jet[1].get(1 << BITS * k, 0) for jet in row] for k in free]

    def curl(i: int, j: int) -> Any:
        return rates[i][j] - rates[j][i]

    return all(
        ring.arithmetic.vanishes(a[i] * curl(j, k) + a[j] * curl(k, i) + a[k] * curl(i, j))
        for i, j, k in combinations(range(len(a)), 3)
    )


def _surface(geometric: Sequence[sp.Expr] | Surface, slots: Slots) -> Surface:
    return geometric if isinstance(geometric, Surface) else Surface(geometric, slots.coordinates)


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


def _agreed(
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


def _compared(difference: sp.Expr) -> bool | None:
    try:
        return is_zero(difference)
    except DivisionByZeroError:
        return None
