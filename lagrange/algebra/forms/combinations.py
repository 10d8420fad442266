"""One form as a combination of others: ω = Σ c_j ω_j, with functions c_j of the configuration.

Whether there is such a combination, and which of the ω_j it needs, is read off at random points of the constraint
surface. The c_j follow from as many columns as forms are needed, by Cramer's rule; constants are reconstructed directly
from their residues. Every column is verified on the surface. What would be too long to read is not worked out: then the
result is None.

Shapes: ω (n,), ω_j (m, n), c (m,).
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.exact.points_needed import ZERO_POINTS
from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, Point, Surface, UnsupportedError
from lagrange.algebra.forms.limits import LARGEST_COMBINED, LONGEST_COMBINATION, MOST_COMBINED_FORMS
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations

Form = Sequence[sp.Expr]
Combination = tuple[sp.Expr, ...]


def combination(form: Form, others: Sequence[Form], surface: Surface) -> Combination | None:
    """The c_j, shape (m,), with form = Σ c_j others_j on the surface; None: there is none, or it is not short.

    form (n,), others (m, n) of rank m.
    """
    try:
        values_at_points = surface.sampled(lambda point: _values(point, form, others), ZERO_POINTS)
        if any(values is None for values in values_at_points):
            return None
        needed = [j for j in range(len(others)) if any(values and values[j] for values in values_at_points)]
        # The same small fractions at two points: the c_j are constants, and no determinant is needed.
        numbers = surface.sampled(lambda point: _rational(point, form, others), ZERO_POINTS)
        constant = numbers[0] if numbers[0] == numbers[1] else None
        candidate = constant or _by_cramer(form, others, needed, surface)
        if candidate is None or not _holds(candidate, form, others, surface):
            return None
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return None
    return candidate if sum(count_operations(c) for c in candidate) <= LONGEST_COMBINATION else None


def _values(point: Point, form: Form, others: Sequence[Form]) -> list[object] | None:
    """The values of the c_j at a point."""
    rows = point.matrix(others)
    solution = point.solution([list(column) for column in zip(*rows, strict=True)], point.values(form))
    return None if solution is None else [None if point.arithmetic.vanishes(c) else c for c in solution]


def _rational(point: Point, form: Form, others: Sequence[Form]) -> Combination | None:
    """The c_j as rational numbers, where they all look like some."""
    values = _values(point, form, others)
    if values is None or not hasattr(point, "reconstructed"):
        return None
    numbers = [sp.S.Zero if c is None else point.reconstructed(c) for c in values]
    return None if None in numbers else tuple(numbers)


def _by_cramer(form: Form, others: Sequence[Form], needed: Sequence[int], surface: Surface) -> Combination | None:
    if not 0 < len(needed) <= MOST_COMBINED_FORMS:
        return None
    rows = [others[j] for j in needed]
    columns = independent_columns(rows, surface, form)
    if len(columns) < len(rows):
        return None
    matrix = sp.Matrix([[row[k] for row in rows] for k in columns])
    right = sp.Matrix([form[k] for k in columns])
    if sum(count_operations(e) for e in (*matrix, *right)) > LARGEST_COMBINED:
        return None
    below = textbook_form(matrix.det(method="berkowitz"))
    coefficients = [sp.S.Zero] * len(others)
    for n, j in enumerate(needed):
        replaced = matrix.copy()
        replaced[:, n] = right
        coefficients[j] = _lowest(textbook_form(replaced.det(method="berkowitz")), below)
    return tuple(coefficients)


def independent_columns(rows: Sequence[Form], surface: Surface, beside: Form = ()) -> list[int]:
    """As many columns as there are rows in which the rows (m, n) of rank m are independent, short ones first.

    `beside`, (n,), is one more row whose length counts. Fewer columns where that is undecided.
    """
    chosen: list[int] = []
    everything = [*rows, beside] if beside else rows
    for k in sorted(range(len(rows[0])), key=lambda k: (sum(count_operations(r[k]) for r in everything), k)):
        if surface.rank([[row[c] for row in rows] for c in (*chosen, k)]) == len(chosen) + 1:
            chosen.append(k)
        if len(chosen) == len(rows):
            break
    return chosen


def _lowest(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, in textbook form where that is shorter."""
    reduced = sp.cancel(above / below)
    tidied = textbook_form(reduced)
    return min((above / below, reduced, tidied), key=lambda e: count_operations(e))


def _holds(candidate: Combination, form: Form, others: Sequence[Form], surface: Surface) -> bool:
    columns = zip(form, *others, strict=True)
    return all(
        surface.is_zero(sp.Add(a, *(-c * b for c, b in zip(candidate, column, strict=True)))) is True
        for a, *column in columns
    )
