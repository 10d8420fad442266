"""Possible and virtual displacements.

A possible displacement satisfies the constraints in differential form, A dq + a_t dt = 0. Two of them in the same dt
differ by a virtual displacement, A δq = 0: time is frozen, and a_t drops out. So with any w for which A w + a_t = 0,

    dq = δq + w dt ,     dr = δr + (Σ (∂r/∂q_k) w_k + ∂r/∂t) dt ,

where w dt is the displacement imposed by the moving constraints. Solving A δq = 0 for m of the δq leaves n − m
independent ones; each pivot that is divided by must not vanish, and is reported. Where a constraint φ = 0 is not linear
in the velocities, the difference of two possible displacements satisfies no linear condition, and Σ ∂φ/∂q' δq = 0 is
Chetaev's rule, a postulate (N. G. Chetaev, On Gauss's principle, 1932).

Shapes: A (m, n), a_t (m,), w (n,).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.zero_test import Point, Surface
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.algebra.fourier.vector_cleanup import cleaned_up, in_differences, is_short, ordered_differences
from lagrange.core.expression_size import Sizes, count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Slots, differential, sign_in_range, t, variation
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem, Row
from lagrange.mechanics.constraints.kinematics import Load, MassPoint
from lagrange.mechanics.constraints.limits import (
    LONGEST_DISPLACEMENTS,
    LONGEST_FACTORED,
    MOST_CANCELLED_TERMS,
    MOST_DRIFTS,
    MOST_FACTORED_SYMBOLS,
    MOST_TURNED,
)
from lagrange.problem.model import AppliedMoment, Problem


@record
class Elimination:
    """A δq = 0 solved for the dependent ones.

    independent  indices of the coordinates whose δq are free
    dependent    indices of the coordinates whose δq are solved for, in the order of the rows used
    solution     shape (number dependent, number independent): δq_D = solution · δq_I
    drift        shape (number dependent,): dq_D = solution · dq_I + drift dt
    pivots       the factors of the minor divided by, without constants: must not vanish
    unused       indices of redundant rows
    is_closed    whether it is written out; otherwise solution, drift and pivots are empty: they would fill pages
    """

    independent: tuple[int, ...]
    dependent: tuple[int, ...]
    solution: tuple[tuple[sp.Expr, ...], ...]
    drift: tuple[sp.Expr, ...]
    pivots: tuple[sp.Expr, ...]
    unused: tuple[int, ...]
    is_closed: bool = True

    def solved(self, slots: Slots) -> Mapping[sp.Symbol, sp.Expr]:
        """Each dependent δq in terms of the independent ones; none if they are not written out."""
        if not self.is_closed:
            return {}
        free = [variation(slots.coordinates[k]) for k in self.independent]
        return {
            variation(slots.coordinates[d]): sp.Add(*(c * v for c, v in zip(row, free, strict=True)))
            for d, row in zip(self.dependent, self.solution, strict=True)
        }

    def shape(self, size: int) -> tuple[tuple[sp.Expr, ...], ...]:
        """N with δq = N δq_I, shape (size, number independent), `size` being the number of coordinates."""
        rows = dict(zip(self.dependent, self.solution, strict=True))
        unit = {k: tuple(sp.Integer(j == k) for j in self.independent) for k in self.independent}
        return tuple((rows | unit)[k] for k in range(size))


def possible_displacement(row: Row, slots: Slots) -> sp.Expr:
    """Σ a_i dq_i + a_t dt; φ of a constraint that is not linear in the velocities, where dq_i = q_i' dt."""
    if row.nonlinear is not None:
        return row.nonlinear
    terms = (a * differential(q) for a, q in zip(row.coefficients, slots.coordinates, strict=True))
    return sp.Add(*terms, row.drift * differential(t))


def virtual_displacement(row: Row, slots: Slots) -> sp.Expr:
    """Σ a_i δq_i."""
    return sp.Add(*(a * variation(q) for a, q in zip(row.coefficients, slots.coordinates, strict=True)))


def displaced(point: MassPoint, slots: Slots) -> Vector:
    """δr = Σ (∂r/∂q_k) δq_k."""
    return _moved(point, [variation(q) for q in slots.coordinates])


def transport_velocity(point: MassPoint, slots: Slots, rates: Sequence[sp.Expr]) -> Vector:
    """The velocity that the moving constraints impose on a particle: Σ (∂r/∂q_k) w_k + ∂r/∂t."""
    return (_moved(point, rates) + point.position.frozen_derivative(slots)).map(textbook_form)


def is_carried_as_a_whole(row: Row, velocity: Vector, rates: Sequence[sp.Expr], slots: Slots) -> bool:
    """Whether a moving curve or surface is carried along by a translation with this velocity w(t).

    f(r, t) = 0 with ∂f/∂t + w·∇f = 0 for the same w everywhere is f(r + w dt, t + dt) = f(r, t).
    """
    is_same_everywhere = not any(c.free_symbols & {*slots.coordinates, *slots.velocities} for c in velocity.components)
    change = row.drift + sp.Add(*(a * w for a, w in zip(row.coefficients, rates, strict=True)))
    return row.finite is not None and not velocity.is_zero and is_same_everywhere and sp.expand(change) == 0


def _moved(point: MassPoint, by: Sequence[sp.Expr]) -> Vector:
    """Σ (∂r/∂q_k) s_k, for s of shape (n,)."""
    total = Vector.zero(point.position.triad)
    for partial, step in zip(point.partials, by, strict=True):
        if step != 0:
            total = total + partial.map(_over_one_denominator) * step
    return total


def _over_one_denominator(e: sp.Expr) -> sp.Expr:
    """−a (3 − sin²s) sin s/(1 + sin²s)² for a sum of fractions; anything else as it is."""
    if not e.is_Add or not any(p.exp.is_negative and p.base.is_Add for p in e.atoms(sp.Pow)):
        return e
    return min(e, textbook_form(e), key=count_operations)


def displaced_force(load: Load, slots: Slots) -> Vector:
    """δr of the point of application of a force."""
    total = Vector.zero(load.point.triad)
    for q in slots.coordinates:
        total = total + load.point.partial(q) * variation(q)
    return total


def virtual_displacements(system: ConstrainedSystem, first: Collection[int] = ()) -> Elimination:
    """The virtual displacements A δq = 0, the dependent ones solved for; `first` are eliminated before any others."""
    try:
        return eliminate(system.rows, system.size, system.states, first, LONGEST_DISPLACEMENTS)
    except TooLongError:
        return _open(system, first)


def _open(system: ConstrainedSystem, first: Collection[int]) -> Elimination:
    """Which displacements are independent, found at a random point; nothing is solved.

    Where none is, and no constraint moves, all δq are zero, however long the forms.
    """
    order = sorted(range(system.size), key=lambda k: k not in first)

    def at(point: Point) -> tuple[list[int], list[int]]:
        values = point.matrix([[row.coefficients[k] for k in order] for row in system.rows])
        columns = row_reduced(point.arithmetic, values)[1]
        used = row_reduced(point.arithmetic, [list(column) for column in zip(*values, strict=True)])[1]
        return columns, used

    columns, used = max(system.states.sampled(at), key=lambda sample: len(sample[0]))
    dependent = tuple(order[k] for k in columns)
    independent = tuple(k for k in range(system.size) if k not in dependent)
    unused = tuple(k for k in range(len(system.rows)) if k not in used)
    if not independent and not any(row.drift for row in system.rows):
        return Elimination((), dependent, ((),) * system.size, (sp.S.Zero,) * system.size, (), unused)
    return Elimination(independent, dependent, (), (), (), unused, is_closed=False)


def not_driven(problem: Problem, system: ConstrainedSystem) -> list[int]:
    """All coordinates but the angle of the body on which the only given moment acts: the crank of a linkage stays free.

    Indices; none where constraints are on velocities, or no such angle is a coordinate.
    """
    moments = [f for f in problem.forces if isinstance(f, AppliedMoment)]
    if len(moments) != 1 or any(row.finite is None for row in system.rows):
        return []
    driven = next((b.angle for b in problem.bodies if b.name == moments[0].on), None)
    coordinates = system.slots.coordinates
    return [k for k, q in enumerate(coordinates) if q != driven] if driven in coordinates else []


def transport_rates(system: ConstrainedSystem, elimination: Elimination) -> tuple[sp.Expr, ...]:
    """The simplest w found with A w + a_t = 0, shape (n,): all zero if no constraint moves.

    w is not unique: any virtual displacement can be added. Of those with n − m coordinates at rest, the shortest is
    taken, or a rotation w = κ (−y, x) of two of them, as of what turns with a table. There is no w if a constraint is
    not linear in the velocities.
    """
    rows, size = system.rows, system.size
    if not system.is_pfaffian or not any(elimination.drift):
        return (sp.S.Zero,) * size
    moving = {k for row in rows if row.drift != 0 for k, a in enumerate(row.coefficients) if a != 0}
    others = sorted(moving - set(elimination.dependent))[:MOST_DRIFTS]
    eliminations = [elimination, *(virtual_displacements(system, (k,)) for k in others)]
    rates = [*(_rates(e, size) for e in eliminations), *_turning(system)]
    return min(rates, key=lambda w: (any(_has_denominator(r, system.slots) for r in w), _operations(w)))


def _turning(system: ConstrainedSystem) -> Iterator[tuple[sp.Expr, ...]]:
    """w = κ (−y, x) of each pair of coordinates for which a constant κ satisfies A w + a_t = 0."""
    q = system.slots.coordinates
    for m, n in combinations(range(min(system.size, MOST_TURNED)), 2):
        products = [row.coefficients[n] * q[m] - row.coefficients[m] * q[n] for row in system.rows]
        moved = next(((row, p) for row, p in zip(system.rows, products, strict=True) if row.drift != 0), None)
        if moved is None or moved[1] == 0:
            continue
        rate = _tidy(-moved[0].drift / moved[1])
        if rate.free_symbols & {*q, t}:
            continue
        pairs = zip(system.rows, products, strict=True)
        if all(system.states.is_zero(row.drift + rate * p) is True for row, p in pairs):
            turned = {m: -rate * q[n], n: rate * q[m]}
            yield tuple(turned.get(k, sp.S.Zero) for k in range(system.size))


def _has_denominator(rate: sp.Expr, slots: Slots) -> bool:
    below = sp.fraction(sp.together(rate))[1]
    return rate.has(sp.tan, sp.cot) or bool(below.free_symbols & {*slots.coordinates, t})


def _operations(rates: Sequence[sp.Expr]) -> int:
    return sum(1 + count_operations(r) for r in rates if r != 0)


def _rates(elimination: Elimination, size: int) -> tuple[sp.Expr, ...]:
    rates = [sp.S.Zero] * size
    for k, rate in zip(elimination.dependent, elimination.drift, strict=True):
        rates[k] = rate
    return tuple(rates)


class TooLongError(Exception):
    """The elimination has more operations than allowed."""


def eliminate(
    rows: Sequence[Row], size: int, surface: Surface, first: Collection[int] = (), most: int | None = None
) -> Elimination:
    """Solve A δq = 0, and with it A dq + a_t dt = 0, by Gauss-Jordan elimination.

    rows   the forms, m of them, with `size` coefficients each
    first  indices of coordinates to be eliminated before any others
    most   operations allowed for all entries together on the way; beyond that it raises TooLongError

    A pivot is nonzero at generic points of the constraint surface. Constants are preferred, then short expressions,
    because each pivot is a condition on the result and a denominator in it.
    """
    matrix = [[*row.coefficients, row.drift] for row in rows]
    pivot_of: dict[int, int] = {}
    pivots: list[sp.Expr] = []
    unused: list[int] = []
    for r, row in enumerate(matrix):
        column = _pivot_column(row[:size], surface, first)
        if column is None:
            unused.append(r)
            continue
        pivot = row[column]
        pivots.append(pivot)
        matrix[r] = [_tidy(entry / pivot) for entry in row]
        for other in range(len(matrix)):
            factor = matrix[other][column]
            if other != r and factor != 0:
                matrix[other] = [
                    _tidy(a - factor * b) if b != 0 else a for a, b in zip(matrix[other], matrix[r], strict=True)
                ]
        pivot_of[r] = column
        if most is not None and sum(count_operations(e) for entries in matrix for e in entries) > most:
            raise TooLongError
    dependent = tuple(pivot_of.values())
    independent = tuple(k for k in range(size) if k not in dependent)
    solution = tuple(tuple(_factored(-matrix[r][k]) for k in independent) for r in pivot_of)
    drift = tuple(_factored(-matrix[r][size]) for r in pivot_of)
    return Elimination(independent, dependent, solution, drift, _varying_factors(_minor(pivots)), tuple(unused))


def _pivot_column(row: Sequence[sp.Expr], surface: Surface, first: Collection[int]) -> int | None:
    """The column to divide by, or None if the row vanishes on the constraint surface."""
    ranked = sorted((k not in first, not e.is_number, count_operations(e), k) for k, e in enumerate(row) if e != 0)
    for *_, k in ranked:
        if surface.is_zero(row[k]) is False:
            return k
    return None


def _minor(pivots: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Factors of the minor divided by: the pivots themselves, if none has a denominator to cancel."""
    # The minor is the product of the pivots. The denominators of later pivots are earlier pivots, which cancel in it;
    # without denominators the product need not be multiplied out, and stays in factors.
    if all(sp.fraction(p)[1].is_number for p in pivots):
        return [_tidy(p) for p in pivots]
    minor = sp.S.One
    for p in pivots:
        minor = _cancelled(minor * p)
    return [_tidy(minor)]


def _varying_factors(minor: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """The factors of a minor that can vanish, each once, without constants: x in 2 l x²."""
    numerators = (sp.fraction(p)[0] for p in minor)
    parts = (
        sp.factor(p) if p.has(sp.Add) and len(p.free_symbols) <= MOST_FACTORED_SYMBOLS and _is_short(p) else p
        for p in numerators
    )
    bases = (f.as_base_exp()[0] for p in parts for f in sp.Mul.make_args(p))
    varying = (
        b
        for b in bases
        if not b.is_number and not b.is_positive and sign_in_range(b) is None and not isinstance(b, Sign)
    )
    return tuple(dict.fromkeys(varying))


@lru_cache(maxsize=256)
def _factored(quotient: sp.Expr) -> sp.Expr:
    """−(y² + 3x y)/(x² + x y) as −y (3x + y)/[x (x + y)], if factors make a quotient shorter."""
    if quotient.is_Atom or len(quotient.free_symbols) > MOST_FACTORED_SYMBOLS:
        return quotient
    if not is_short(quotient) or count_operations(quotient) > LONGEST_FACTORED or quotient.atoms(sp.Function):
        return quotient
    factors = sp.factor(quotient) if quotient.has(sp.Add) else quotient
    shorter = factors if count_operations(factors) < count_operations(quotient) else quotient
    return ordered_differences(in_differences(shorter, sorted(shorter.free_symbols, key=lambda s: str(s.name))))


def _is_short(expression: sp.Expr) -> bool:
    """Whether multiplying out takes little time: (x + y + z + w)^20 has 1771 terms."""
    return Sizes().of(expression).widest <= MOST_CANCELLED_TERMS


def _cancelled(expression: sp.Expr) -> sp.Expr:
    """In lowest terms, as a quotient of products is already."""
    return sp.cancel(expression) if expression.has(sp.Add) and _is_short(expression) else expression


@lru_cache(maxsize=256)
def _tidy(entry: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, with sin² + cos² = 1."""
    if entry.is_number or entry.is_Symbol:
        return entry
    reduced = _cancelled(entry)
    if not reduced.has(sp.sin, sp.cos, sp.tan) or not _is_short(reduced):
        return reduced
    tidied = cleaned_up(reduced)
    return tidied if count_operations(tidied) <= count_operations(reduced) else reduced
