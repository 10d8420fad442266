"""Which constraints are finite relations in disguise.

A form ω = Σ a_i dq_i + a_t dt (t counts as a coordinate here) is exact if ∂a_i/∂q_k = ∂a_k/∂q_i for all
pairs, and then ω = df. It is integrable if ω = μ df, and by Frobenius' theorem it is so just when

    ω ∧ dω = Σ_{i<j<k} c_ijk dq_i ∧ dq_j ∧ dq_k = 0,
    c_ijk = a_i (∂_j a_k - ∂_k a_j) + a_j (∂_k a_i - ∂_i a_k) + a_k (∂_i a_j - ∂_j a_i).

Exact implies integrable; y dx - x dy shows that the converse fails. Several constraints may hide finite
relations that none of them shows: the derived flag counts them (see `flags`).

Geometric constraints hold at all times, so that ranks and Frobenius' condition are taken on their surface:
with z = 0 the form dx + y z du is dx. There, at a generic point in a prime field, the surface is written as
a graph over part of the coordinates, all as jets, and the forms are pulled back to it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import combinations
from typing import Any, TypeVar

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, NoPointError, Point, Surface, UnsupportedError, is_zero
from lagrange.algebra.exact.graph import SIGNED
from lagrange.algebra.forms.charts import SingularSurfaceError, chart, independent_constraints, pulled_back
from lagrange.algebra.forms.flags import Distribution, derived, kernel
from lagrange.algebra.forms.jets import BITS, Jet, Ring, WorkLimitError, constant_term
from lagrange.algebra.forms.potentials import differentiated
from lagrange.algebra.forms.taylor import NoExpansionError
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Slots

T = TypeVar("T")

HIGHEST_ORDER = 10
WORK_LIMIT = 6_000_000
POINTS = 2
ROOT_POINTS = 8
BRANCH_POINTS = 20
REAL_POINTS = 4
LONGEST_TIDIED = 60
LONGEST_FORM = 40


@record
class Flag:
    """The derived flag of a system of constraints.

    ranks            of the system, of its first derived system, ..., as far as they were found
    integrable_rank  number of independent finite relations in the constraints (the last rank), or None
    reason           why it is undecided
    """

    ranks: tuple[int, ...]
    integrable_rank: int | None
    reason: str = ""

    @property
    def bound(self) -> int | None:
        """What `integrable_rank` is at most, None where nothing is known."""
        return self.ranks[-1] if self.ranks else None


@record
class Comparison:
    """∂a/∂k = ∂b/∂i, for the coefficients a of di and b of dk; `equal` is None where it is undecided."""

    variables: tuple[sp.Symbol, sp.Symbol]
    coefficients: tuple[sp.Expr, sp.Expr]
    derivatives: tuple[sp.Expr, sp.Expr]
    equal: bool | None


@record
class Exactness:
    """All pairs of partial derivatives of one form; `exact` is None where it hangs on an undecided pair."""

    comparisons: tuple[Comparison, ...]
    exact: bool | None

    @property
    def differing(self) -> tuple[Comparison, ...]:
        """The pairs that differ."""
        return tuple(c for c in self.comparisons if c.equal is False)


@record
class Component:
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
        comparisons.append(Comparison((q, r), (a, b), (left, right), equal))
    return Exactness(tuple(comparisons), _all(c.equal for c in comparisons))


def frobenius_form(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> tuple[Component, ...]:
    """The components of ω ∧ dω, in the order of the variables; those written as 0 are left out."""
    components = []
    written = writer(form)
    indices = range(len(form))
    d = {(i, j): differentiated(form[j], variables[i], slots) for i in indices for j in indices if i != j}
    for i, j, k in combinations(indices, 3):
        cyclic = ((i, j, k), (j, k, i), (k, i, j))
        coefficient = written(sp.Add(*(form[a] * (d[b, c] - d[c, b]) for a, b, c in cyclic)))
        if coefficient != 0:
            zero = _compared(coefficient)
            triple = (variables[i], variables[j], variables[k])
            components.append(Component(triple, coefficient, None if zero is None else not zero))
    return tuple(components)


def writer(form: Sequence[sp.Expr]) -> Callable[[sp.Expr], sp.Expr]:
    """How components of ω ∧ dω are written: in textbook form, unless that would be too long for anybody to read."""
    if sum(a.count_ops() for a in form) > LONGEST_FORM:
        return lambda coefficient: coefficient
    return lambda coefficient: textbook_form(coefficient) if coefficient.count_ops() <= LONGEST_TIDIED else coefficient


def derived_flag(
    forms: Sequence[Sequence[sp.Expr]],
    slots: Slots,
    geometric: Sequence[sp.Expr] | Surface = (),
    *,
    highest_order: int = HIGHEST_ORDER,
    work_limit: int = WORK_LIMIT,
) -> Flag:
    """The derived flag of all constraints together, at generic points of the geometric ones.

    forms      (m, n + 1): coefficients of dq_1 ... dq_n, dt; rows of geometric constraints may be among them
    geometric  functions f(q, t) whose vanishing is the geometric constraints, or their surface

    Random points must agree. Undecided where no point is found, an expression has no Taylor series, or the
    limits on order and work (products of coefficients, all points together) are reached.
    """
    surface = _surface(geometric, slots)
    rows = _beyond(surface.constraints, [tuple(sp.sympify(a, strict=True) for a in form) for form in forms], slots)
    left = work_limit

    def at(point: Point, finite: Sequence[sp.Expr]) -> Flag:
        nonlocal left
        if not rows:
            return Flag((len(finite),), len(finite))
        ring = Ring(point.arithmetic, left)
        try:
            flag = _flag_at(ring, point, rows, slots, finite, highest_order)
        finally:
            left -= ring.work
        if flag.integrable_rank is None:
            raise _OpenFlagError(flag)
        return flag

    try:
        return _agreed(at, [a for row in rows for a in row], surface, slots, lambda why: Flag((), None, why))
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
        ring = Ring(point.arithmetic, WORK_LIMIT)
        there = chart(ring, point, finite, slots, 2 if finite else 1)
        (row,) = pulled_back(ring, there, [omega])
        return _is_frobenius(ring, row, there.free)

    return _agreed(at, omega, surface, slots, lambda _: None)


def _flag_at(
    ring: Ring,
    point: Point,
    forms: Sequence[Sequence[sp.Expr]],
    slots: Slots,
    geometric: Sequence[sp.Expr],
    highest_order: int,
) -> Flag:
    """The flag at one point, with as high an order as it takes."""
    best: list[int] = []
    for order in range(1, highest_order + 1):
        found: list[int] = []
        try:
            there = chart(ring, point, geometric, slots, order + 1 if geometric else order)
            d: Distribution | None = kernel(ring, pulled_back(ring, there, forms), there.free, order)
            while d is not None:
                found.append(len(there.graph) + len(d.bound))
                if len(found) > 1 and found[-2] == found[-1]:
                    return Flag(tuple(found[:-1]), found[-1])
                d = derived(ring, d)
        except WorkLimitError:
            best = found if len(found) > len(best) else best
            return Flag(tuple(best), None, "the computation would be too large")
        best = found
    return Flag(tuple(best), None, f"brackets of more than {highest_order} levels would be needed")


class _OpenFlagError(Exception):
    """A flag that a limit left open; no other point would do better."""

    def __init__(self, flag: Flag) -> None:
        super().__init__(flag.reason)
        self.flag = flag


def _is_frobenius(ring: Ring, row: Sequence[Jet], free: Sequence[int]) -> bool:
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
    """What random points say if all say the same; a real one too where expressions are branches or opaque."""
    everything = (*surface.constraints, *expressions)
    try:
        marks = {surface.graph.marks[surface.graph.node(e)] for e in everything}
        signs = any(isinstance(s, Sign) for e in everything for s in e.free_symbols)
        branches = signs or any(mark & SIGNED for mark in marks)
        count = BRANCH_POINTS if branches else ROOT_POINTS if _has_roots(surface) else POINTS
        finite = independent_constraints(surface, slots)
        found = surface.sampled(lambda point: evaluate(point, finite), count if expressions else 1)
        if surface.exact and any(marks):
            reals = REAL_POINTS if branches else 1
            found += surface.sampled(lambda point: evaluate(point, finite), reals, real=True)
    except (UnsupportedError, NoExpansionError) as error:
        return undecided(f"there is no Taylor series of {error}")
    except (NoPointError, DivisionByZeroError):
        return undecided("no point was found where the geometric constraints hold")
    except SingularSurfaceError:
        return undecided("the geometric constraints are not regular where they hold")
    except WorkLimitError:
        return undecided("the computation would be too large")
    if all(other == found[0] for other in found):
        return found[0]
    return undecided("different points of the constraint surface give different answers")


def _has_roots(surface: Surface) -> bool:
    """Whether points of the surface are chosen between several: the sphere has two over every (x, y)."""
    return bool(surface.constraints) and (surface.order is None or bool(surface.order.roots))


def _compared(difference: sp.Expr) -> bool | None:
    try:
        return is_zero(difference)
    except DivisionByZeroError:
        return None


def _all(verdicts: Iterable[bool | None]) -> bool | None:
    known = list(verdicts)
    return False if False in known else None if None in known else True
