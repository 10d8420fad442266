"""One form as a combination of others: ω = Σ c_j ω_j, with functions c_j of the configuration.

That there is such a combination, and which of the ω_j it needs, is read off at random points of the constraint surface.
The c_j are then found from as many columns as forms are needed, by Cramer's rule; constants directly. Every column is
verified on the surface. What would be too long to be read is not worked out: then the c_j are None.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, NoPointError, Point, Surface, UnsupportedError
from lagrange.algebra.fourier.textbook import textbook_form

MOST_FORMS = 3
MOST_OPERATIONS = 60
LONGEST = 60

Form = Sequence[sp.Expr]
Combination = tuple[sp.Expr, ...]


def combination(form: Form, others: Sequence[Form], surface: Surface) -> Combination | None:
    """The c_j, shape (m,), with form = Σ c_j others_j on the surface; None: there is none, or it is not short.

    form (n,), others (m, n) of rank m.
    """
    try:
        found = surface.sampled(lambda point: _values(point, form, others), 2)
        if any(values is None for values in found):
            return None
        needed = [j for j in range(len(others)) if any(values and values[j] for values in found)]
        numbers = surface.sampled(lambda point: _rational(point, form, others), 2)
        constant = numbers[0] if numbers[0] == numbers[1] else None
        candidate = constant or _by_cramer(form, others, needed, surface)
        if candidate is None or not _holds(candidate, form, others, surface):
            return None
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return None
    return candidate if sum(c.count_ops() for c in candidate) <= LONGEST else None


def _values(point: Point, form: Form, others: Sequence[Form]) -> list[object] | None:
    """The values of the c_j at a point."""
    rows = point.matrix(others)
    found = point.solution([list(column) for column in zip(*rows, strict=True)], point.values(form))
    return None if found is None else [None if point.arithmetic.vanishes(c) else c for c in found]


def _rational(point: Point, form: Form, others: Sequence[Form]) -> Combination | None:
    """The c_j as rational numbers, where they all look like some."""
    values = _values(point, form, others)
    if values is None or not hasattr(point, "reconstructed"):
        return None
    numbers = [sp.S.Zero if c is None else point.reconstructed(c) for c in values]
    return None if None in numbers else tuple(numbers)


def _by_cramer(form: Form, others: Sequence[Form], needed: Sequence[int], surface: Surface) -> Combination | None:
    if not 0 < len(needed) <= MOST_FORMS:
        return None
    rows = [others[j] for j in needed]
    columns = independent_columns(rows, surface, form)
    if len(columns) < len(rows):
        return None
    matrix = sp.Matrix([[row[k] for row in rows] for k in columns])
    right = sp.Matrix([form[k] for k in columns])
    if sum(e.count_ops() for e in (*matrix, *right)) > MOST_OPERATIONS:
        return None
    below = textbook_form(matrix.det(method="berkowitz"))
    found = [sp.S.Zero] * len(others)
    for n, j in enumerate(needed):
        replaced = matrix.copy()
        replaced[:, n] = right
        found[j] = _lowest(textbook_form(replaced.det(method="berkowitz")), below)
    return tuple(found)


def independent_columns(rows: Sequence[Form], surface: Surface, beside: Form = ()) -> list[int]:
    """As many columns as there are rows in which the rows (m, n) of rank m are independent, short ones first.

    `beside`, (n,), is one more row whose length counts. Fewer columns where that is undecided.
    """
    chosen: list[int] = []
    everything = [*rows, beside] if beside else rows
    for k in sorted(range(len(rows[0])), key=lambda k: (sum(r[k].count_ops() for r in everything), k)):
        if surface.rank([[row[c] for row in rows] for c in (*chosen, k)]) == len(chosen) + 1:
            chosen.append(k)
        if len(chosen) == len(rows):
            break
    return chosen


def _lowest(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, in textbook form where that is shorter."""
    reduced = sp.cancel(above / below)
    tidied = textbook_form(reduced)
    return min((above / below, reduced, tidied), key=lambda e: e.count_ops())


def _holds(candidate: Combination, form: Form, others: Sequence[Form], surface: Surface) -> bool:
    columns = zip(form, *others, strict=True)
    return all(
        surface.is_zero(sp.Add(a, *(-c * b for c, b in zip(candidate, column, strict=True)))) is True
        for a, *column in columns
    )
