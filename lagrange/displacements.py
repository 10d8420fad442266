"""Possible and virtual displacements.

The constraints in differential form, A dq + a_t dt = 0, are what a possible displacement satisfies. Two of them in the
same dt differ by a virtual displacement, A δq = 0: time is frozen and a_t has dropped out. Solving A δq = 0 for m of
the δq leaves n − m independent ones; each pivot that is divided by must not vanish, and is stated.

Shapes: A (m, n), a_t (m,).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from lagrange.exact import Surface
from lagrange.kinematics import Load, MassPoint, Row
from lagrange.notation import Sign, Slots, differential, t, variation
from lagrange.textbook import textbook_form
from lagrange.vectors import Vector

MOST_FACTORED = 8
"""Symbols of a minor that is still factored."""


@dataclass(frozen=True)
class Elimination:
    """A δq = 0 solved for the dependent ones.

    independent  indices of the coordinates whose δq are free
    dependent    indices of the coordinates whose δq are given, in the order of the rows used
    solution     shape (number dependent, number independent): δq_D = solution · δq_I
    pivots       the factors of the minor that was divided by, constants left out: must not vanish
    unused       indices of rows that follow from the others
    """

    independent: tuple[int, ...]
    dependent: tuple[int, ...]
    solution: tuple[tuple[sp.Expr, ...], ...]
    pivots: tuple[sp.Expr, ...]
    unused: tuple[int, ...]

    def solved(self, slots: Slots) -> Mapping[sp.Symbol, sp.Expr]:
        """Each dependent δq in terms of the independent ones."""
        free = [variation(slots.coordinates[k]) for k in self.independent]
        return {
            variation(slots.coordinates[d]): sp.Add(*(c * v for c, v in zip(row, free, strict=True)))
            for d, row in zip(self.dependent, self.solution, strict=True)
        }


def possible_displacement(row: Row, slots: Slots) -> sp.Expr:
    """Σ a_i dq_i + a_t dt."""
    terms = (a * differential(q) for a, q in zip(row.coefficients, slots.coordinates, strict=True))
    return sp.Add(*terms, row.drift * differential(t))


def virtual_displacement(row: Row, slots: Slots) -> sp.Expr:
    """Σ a_i δq_i."""
    return sp.Add(*(a * variation(q) for a, q in zip(row.coefficients, slots.coordinates, strict=True)))


def displaced(point: MassPoint, slots: Slots, of: Callable[[sp.Symbol], sp.Symbol]) -> Vector:
    """Σ (∂r/∂q_k) dq_k with differentials and the drift, or with variations: δr, where time is frozen."""
    total = Vector.zero(point.position.triad)
    for q, partial in zip(slots.coordinates, point.partials, strict=True):
        total = total + partial * of(q)
    if of is differential:
        total = total + point.position.frozen_derivative(slots) * differential(t)
    return total


def displaced_force(load: Load, slots: Slots) -> Vector:
    """δr of the point where a force acts."""
    total = Vector.zero(load.point.triad)
    for q in slots.coordinates:
        total = total + load.point.partial(q) * variation(q)
    return total


def eliminate(rows: Sequence[Row], size: int, surface: Surface, first: Collection[int] = ()) -> Elimination:
    """Solves A δq = 0 by Gauss-Jordan elimination.

    rows   the forms, m of them, with `size` coefficients each
    first  indices of coordinates to be eliminated before any others

    A pivot is nonzero at generic points of the constraint surface; constants are preferred, then short expressions.
    """
    matrix = [list(row.coefficients) for row in rows]
    pivot_of: dict[int, int] = {}
    minor = sp.S.One
    unused: list[int] = []
    for r, row in enumerate(matrix):
        column = _pivot_column(row, surface, first)
        if column is None:
            unused.append(r)
            continue
        pivot = row[column]
        minor = sp.cancel(minor * pivot)
        matrix[r] = [_tidy(entry / pivot) for entry in row]
        for other in range(len(matrix)):
            factor = matrix[other][column]
            if other != r and factor != 0:
                matrix[other] = [
                    _tidy(a - factor * b) if b != 0 else a for a, b in zip(matrix[other], matrix[r], strict=True)
                ]
        pivot_of[r] = column
    dependent = tuple(pivot_of.values())
    independent = tuple(k for k in range(size) if k not in dependent)
    solution = tuple(tuple(-matrix[r][k] for k in independent) for r in pivot_of)
    return Elimination(independent, dependent, solution, _varying_factors(_tidy(minor)), tuple(unused))


def _pivot_column(row: Sequence[sp.Expr], surface: Surface, first: Collection[int]) -> int | None:
    """The column to divide by, or None where the row vanishes on the constraint surface."""
    ranked = sorted((k not in first, not e.is_number, e.count_ops(), k) for k, e in enumerate(row) if e != 0)
    for *_, k in ranked:
        if surface.is_zero(row[k]) is False:
            return k
    return None


def _varying_factors(minor: sp.Expr) -> tuple[sp.Expr, ...]:
    """The factors of the minor that can vanish, each once, constant ones dropped: of 2 l x² it is x."""
    numerator, _ = sp.fraction(sp.factor(minor) if len(minor.free_symbols) <= MOST_FACTORED else minor)
    bases = (f.as_base_exp()[0] for f in sp.Mul.make_args(numerator))
    varying = (b for b in bases if not b.is_number and not b.is_positive and not isinstance(b, Sign))
    return tuple(dict.fromkeys(varying))


def _tidy(entry: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, and with sin² + cos² put together."""
    if entry.is_number or entry.is_Symbol:
        return entry
    reduced = sp.cancel(entry)
    if not reduced.has(sp.sin, sp.cos, sp.tan):
        return reduced
    tidied = textbook_form(reduced)
    return tidied if tidied.count_ops() <= reduced.count_ops() else reduced
