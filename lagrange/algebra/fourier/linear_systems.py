"""Linear equations A x = b with symbolic coefficients, solved within bounds.

Gauss–Jordan elimination; the pivot is always the entry that is cheapest to divide by: a number, then what cannot
vanish, such as a mass, then short expressions in sparse rows. Every entry is brought to its textbook form as it arises.
A pivot is not zero at generic points of the constraint surface. The computation is abandoned where an entry grows
beyond `MOST_ENTRY_OPERATIONS`: a result that fills pages is of no use.

With a constant block M, as the masses in M y + B x = h, A y + C x = c, the other unknowns come first, from
(C − A M⁻¹ B) x = c − A M⁻¹ h; one or two of them by Cramer's rule in the ring of Fourier sums.

Shapes: A (m, n), b (m,), x (n,).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

import sympy as sp

from lagrange.algebra.fourier.division import exact_quotient
from lagrange.algebra.fourier.elements import Element
from lagrange.algebra.fourier.fractions import in_lowest_terms, lowest_terms, one_quotient
from lagrange.algebra.fourier.limits import (
    MOST_BY_DETERMINANTS,
    MOST_CANCELLED,
    MOST_COUPLED,
    MOST_ENTRY_OPERATIONS,
    MOST_WORK,
)
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.algebra.fourier.textbook_form import Textbook, common_factor, textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.records import record

Tidy = Callable[[sp.Expr], sp.Expr]


class Decides(Protocol):
    """Anything that decides whether an expression is zero, such as `zero_test.Surface`."""

    def is_zero(self, expression: sp.Expr) -> bool | None:
        """Whether an expression is zero; None: undecided."""


class TooLargeError(Exception):
    """The equations are beyond `MOST_ENTRY_OPERATIONS` or `MOST_WORK`."""


class _Bounded:
    """Tidies entries, and counts what that takes. Raises TooLargeError."""

    def __init__(self, tidy: Tidy) -> None:
        self.tidy = tidy
        self.work = 0

    def __call__(self, entry: sp.Expr) -> sp.Expr:
        operations = count_operations(entry)
        self.work += operations
        if operations > MOST_ENTRY_OPERATIONS or self.work > MOST_WORK:
            raise TooLargeError
        return self.tidy(entry)


def solved_linear(
    rows: Sequence[Sequence[sp.Expr]], right: Sequence[sp.Expr], surface: Decides, tidy: Tidy | None = None
) -> list[sp.Expr | None] | None:
    """The x with A x = b. An entry of x is None where the equations do not determine it; None where they are too large.

    The equations must not contradict one another.
    """
    tidied = _Bounded(tidy or tidy_quotient)
    x: list[sp.Expr | None] = [None] * (len(rows[0]) if rows else 0)
    try:
        work = [[tidied(e) for e in row] for row in rows]
        for block in _blocks(work):
            part = [[*(work[r][c] for c in block.columns), tidied(right[r])] for r in block.rows]
            width = len(block.columns)
            for r, c in _reduce(part, width, surface, tidied).items():
                if all(part[r][k] == 0 for k in range(width) if k != c):
                    x[block.columns[c]] = part[r][width]
    except TooLargeError:
        return None
    return x


@record
class _Block:
    """Equations that have unknowns in common, and all of these unknowns."""

    rows: tuple[int, ...]
    columns: tuple[int, ...]


def _blocks(rows: Sequence[Sequence[sp.Expr]]) -> list[_Block]:
    """Equations that can be solved apart from the others: those of each particle, where nothing ties them."""
    tied: list[tuple[set[int], set[int]]] = []
    for r, row in enumerate(rows):
        columns = {c for c, e in enumerate(row) if e != 0}
        together = [t for t in tied if not t[1].isdisjoint(columns)]
        tied = [t for t in tied if t[1].isdisjoint(columns)]
        tied.append(({r}.union(*(t[0] for t in together)), columns.union(*(t[1] for t in together))))
    return [_Block(tuple(sorted(r)), tuple(sorted(c))) for r, c in tied if c]


def solved_in_blocks(
    rows: Sequence[Sequence[sp.Expr]],
    right: Sequence[sp.Expr],
    size: int,
    surface: Decides,
    tidy: Tidy,
    constant: Callable[[sp.Expr], bool],
    leading: bool,
) -> list[sp.Expr | None] | None:
    """As `solved_linear`, where the first `size` equations have a constant block M in the first `size` unknowns,

        M y + B x = h ,   A y + C x = c ,     that is   (C − A M⁻¹ B) x = c − A M⁻¹ h ,   y = M⁻¹ (h − B x) .

    constant  whether an entry is constant
    leading   whether y is needed too; else it is None

    Far fewer entries arise than by elimination of all unknowns. Where M is not constant, `solved_linear` is used.
    """
    # A constant M, diagonal for particles in Cartesian coordinates, costs next to nothing to invert, and what remains
    # has one row a constraint. Elimination of all unknowns at once would spread the angles of A and B over every row.
    block = [list(row[:size]) for row in rows[:size]]
    inverse = _inverse(block, surface) if all(constant(e) for row in block for e in row) else None
    if not inverse:
        return solved_linear(rows, right, surface, tidy)
    width = len(rows[0]) - size
    if 0 < width <= MOST_BY_DETERMINANTS and len(rows) == size + width and not leading and tidy is tidy_quotient:
        return _by_determinants(rows, right, inverse, surface)
    others = [[*row[size:], b] for row, b in zip(rows[:size], right, strict=False)]
    tidied = _Bounded(tidy)
    try:
        moved = [[tidied(_dot(row, column)) for column in zip(*others, strict=True)] for row in inverse]
        columns = list(zip(*moved, strict=True))
        lower = [(*row[size:], b) for row, b in zip(rows[size:], right[size:], strict=True)]
        left = [
            [e - _dot(row[:size], column) for e, column in zip(entries, columns, strict=True)]
            for row, entries in zip(rows[size:], lower, strict=True)
        ]
        # Counted before the entries are tidied, which is what takes the time.
        if _most_coupled([row[:-1] for row in left], constant, surface) > MOST_COUPLED:
            return None
        reduced = [[tidied(e) for e in row] for row in left]
    except TooLargeError:
        return None
    x = solved_linear([row[:-1] for row in reduced], [row[-1] for row in reduced], surface, tidy)
    if x is None:
        return None
    return [*(_leading(row, x, tidied) if leading else None for row in moved), *x]


def _most_coupled(rows: Sequence[Sequence[sp.Expr]], constant: Callable[[sp.Expr], bool], surface: Decides) -> int:
    """The number of unknowns in the largest set that rows with entries that vary tie together."""
    sets: list[set[int]] = []
    for row in rows:
        tied = {c for c, e in enumerate(row) if e != 0 and surface.is_zero(e) is not True}
        if all(constant(row[c]) for c in tied):
            continue
        apart = [s for s in sets if s.isdisjoint(tied)]
        sets = [*apart, tied.union(*(s for s in sets if s not in apart))]
    return max(map(len, sets), default=0)


def _by_determinants(
    rows: Sequence[Sequence[sp.Expr]],
    right: Sequence[sp.Expr],
    inverse: Sequence[Sequence[sp.Expr]],
    surface: Decides,
) -> list[sp.Expr | None] | None:
    """One or two x by Cramer's rule in the ring of Fourier sums, y being None. None where the determinant is zero."""
    size = len(inverse)
    if sum(count_operations(e) for row in rows for e in row) + sum(count_operations(b) for b in right) > MOST_WORK:
        return None
    # In the ring nothing has to be tidied on the way: a tenth of the time of an elimination with quotients.
    ring = FourierRing()
    read = ring.from_sympy
    others = [[read(e) for e in (*row[size:], b)] for row, b in zip(rows[:size], right, strict=False)]
    moved = [[ring.dot([read(e) for e in row], column) for column in zip(*others, strict=True)] for row in inverse]
    reduced = [
        [
            read(e) - ring.dot([read(a) for a in row[:size]], column)
            for e, column in zip((*row[size:], b), zip(*moved, strict=True), strict=True)
        ]
        for row, b in zip(rows[size:], right[size:], strict=True)
    ]
    if len(reduced) == 1:
        [(determinant, p)] = reduced
        numerators = [p]
    else:
        (a, b, p), (c, d, q) = reduced
        determinant, numerators = a * d - b * c, [p * d - b * q, a * q - p * c]
    textbook = Textbook(ring)
    below = textbook.form(determinant)
    if surface.is_zero(below) is not False and not below.is_nonzero:
        return None
    return [*([None] * size), *(_quotient(n, determinant, textbook) for n in numerators)]


def _quotient(numerator: Element, denominator: Element, textbook: Textbook) -> sp.Expr:
    """A quotient without common factors of the terms; a polynomial where the denominator divides."""
    exact = exact_quotient(numerator, denominator)
    if exact is not None:
        return textbook.form(exact)
    reduced = lowest_terms(numerator, denominator)
    if reduced is not None:
        numerator, denominator = reduced
    written = one_quotient(numerator, denominator, textbook)
    if written is not None:
        return written
    below = textbook.form(denominator)
    above = textbook.form(numerator)
    if above == 0:
        return sp.S.Zero
    over, under = common_factor(above), common_factor(below)
    rest = over.divide(above) / under.divide(below)
    return textbook_form(over.expression / under.expression * rest)


def _leading(row: Sequence[sp.Expr], x_found: Sequence[sp.Expr | None], tidied: Tidy) -> sp.Expr | None:
    """b − Σ row_j x_j; None where an x_j that it needs is open, or where it is too large."""
    total = row[-1]
    for e, x in zip(row, x_found, strict=False):
        if e != 0:
            if x is None:
                return None
            total = total - e * x
    try:
        return tidied(total)
    except TooLargeError:
        return None


def _inverse(matrix: Sequence[Sequence[sp.Expr]], surface: Decides) -> list[list[sp.Expr]] | None:
    """M⁻¹ of a constant matrix, block by block; None where it is singular or large."""
    inverse = [[sp.S.Zero] * len(matrix) for _ in matrix]
    tidied = _Bounded(tidy_quotient)
    blocks = _blocks(matrix)
    if any(len(b.rows) != len(b.columns) for b in blocks) or sum(len(b.rows) for b in blocks) < len(matrix):
        return None
    for block in blocks:
        size = len(block.rows)
        work = [[*(matrix[r][c] for c in block.columns), *(sp.Integer(k == r) for k in block.rows)] for r in block.rows]
        try:
            pivot_of = _reduce(work, size, surface, tidied)
        except TooLargeError:
            return None
        if len(pivot_of) < size:
            return None
        for r, c in pivot_of.items():
            for k, e in zip(block.rows, work[r][size:], strict=True):
                inverse[block.columns[c]][k] = e
    return inverse


def _dot(row: Sequence[sp.Expr], column: Sequence[sp.Expr]) -> sp.Expr:
    return sp.Add(*(a * b for a, b in zip(row, column, strict=True) if a != 0 and b != 0))


def tidy_quotient(entry: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, in textbook form."""
    if entry.is_number or entry.is_Symbol:
        return entry
    formed = textbook_form(entry)
    if count_operations(formed) > MOST_CANCELLED or formed.is_polynomial() or _is_reduced(formed):
        return formed
    return in_lowest_terms(textbook_form(sp.cancel(formed)))


def _is_reduced(formed: sp.Expr) -> bool:
    """Whether nothing can cancel that textbook form does not cancel itself: only powers of symbols are divided by."""
    return all(p.exp.is_Integer and (p.exp > 0 or p.base.is_Symbol) for p in formed.atoms(sp.Pow))


def _reduce(work: list[list[sp.Expr]], width: int, surface: Decides, tidy: Tidy) -> dict[int, int]:
    """Reduces the rows [A | b] in place; the column of the pivot of each row that has one."""
    pivot_of: dict[int, int] = {}
    while True:
        place = _pivot(work, width, pivot_of, surface)
        if place is None:
            return pivot_of
        r, c = place
        pivot = work[r][c]
        work[r] = [sp.S.One if k == c else tidy(e / pivot) if e != 0 else e for k, e in enumerate(work[r])]
        for other, row in enumerate(work):
            factor = row[c]
            if other != r and factor != 0:
                work[other] = [
                    sp.S.Zero if k == c else tidy(a - factor * b) if b != 0 else a
                    for k, (a, b) in enumerate(zip(row, work[r], strict=True))
                ]
        pivot_of[r] = c


def _pivot(
    work: Sequence[Sequence[sp.Expr]], width: int, pivot_of: dict[int, int], surface: Decides
) -> tuple[int, int] | None:
    """The place of the next pivot; None where only zeros are left."""
    rows = [r for r in range(len(work)) if r not in pivot_of]
    columns = [c for c in range(width) if c not in pivot_of.values()]
    ranked = []
    for r in rows:
        filled = sum(work[r][c] != 0 for c in columns)
        for c in columns:
            entry = work[r][c]
            if entry != 0:
                # Markowitz: a pivot fills in at most (entries in its row − 1)(entries in its column − 1) places.
                below = sum(work[k][c] != 0 for k in rows)
                cheap = 0 if entry.is_number else 1 if entry.is_nonzero else 2
                ranked.append((cheap, (filled - 1) * (below - 1), count_operations(entry), r, c))
    for *_, r, c in sorted(ranked):
        if work[r][c].is_nonzero or surface.is_zero(work[r][c]) is False:
            return r, c
    return None
