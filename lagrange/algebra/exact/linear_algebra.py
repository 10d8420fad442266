"""Gauss–Jordan elimination over any numbers: residues mod p, reals of eighty digits, the field of an algebraic root.

A of shape (m, n) is brought to reduced row echelon form; rank, null space {x : A x = 0}, a solution of A x = b and
membership of a row space are read off from it. Residues are exact, and any pivot that is not zero serves. With reals
the largest pivot is taken, and a rank is given only where a clear gap separates the pivots from what rounding leaves:
no small number is called zero by a guess.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Protocol

NumberRow = list[Any]


class NumberField(Protocol):
    """The numbers at a point."""

    exact: bool
    random: Any

    def number(self, numerator: int, denominator: int = 1) -> Any:
        """A rational number."""

    def reduce(self, x: Any) -> Any:
        """The canonical form of a sum of products."""

    def less(self, row: Sequence[Any], factor: Any, other: Sequence[Any]) -> NumberRow:
        """row − factor · other."""

    def inverse(self, x: Any) -> Any:
        """1/x. Raises ZeroDivisorError."""

    def vanishes(self, x: Any) -> bool:
        """Whether x is 0. Raises InadmissibleError when that is undecidable."""

    def root(self, x: Any) -> Any:
        """√x. Raises InadmissibleError when it does not exist."""

    def sample(self) -> Any:
        """A random number."""


def row_reduced(arithmetic: NumberField, rows: Sequence[Sequence[Any]]) -> tuple[list[NumberRow], list[int]]:
    """Reduced row echelon form without its zero rows, and pivot columns: (m, n) -> (r, n), (r,)."""
    work = [[arithmetic.reduce(x) for x in row] for row in rows]
    width = len(work[0]) if work else 0
    pivots: list[int] = []
    for column in range(width):
        top = len(pivots)
        chosen = _pivot(arithmetic, work, top, column)
        if chosen is None:
            continue
        work[top], work[chosen] = work[chosen], work[top]
        scale = arithmetic.inverse(work[top][column])
        pivot = work[top] = [arithmetic.reduce(x * scale) for x in work[top]]
        for n, row in enumerate(work):
            factor = row[column]
            if n != top and factor != 0:
                row[column:] = arithmetic.less(row[column:], factor, pivot[column:])  # pivot has zeros before that
                row[column] = arithmetic.number(0)
        pivots.append(column)
        if len(pivots) == len(work):
            break
    return work[: len(pivots)], pivots


class RowSpace:
    """The span of some rows of one width; rows may be added. One pass decides whether a row lies in it."""

    def __init__(self, arithmetic: NumberField, rows: Iterable[Sequence[Any]] = ()) -> None:
        self.arithmetic = arithmetic
        self._echelon: list[tuple[int, NumberRow]] = []
        for row in rows:
            self.add(row)

    @property
    def rank(self) -> int:
        """The number of independent rows."""
        return len(self._echelon)

    def residue(self, row: Sequence[Any]) -> NumberRow:
        """The residue of a row modulo these; linear in the row."""
        left = [self.arithmetic.reduce(x) for x in row]
        for pivot, known in self._echelon:
            if left[pivot] != 0:
                left = self.arithmetic.less(left, left[pivot], known)
        return left

    def __contains__(self, row: Sequence[Any]) -> bool:
        return all(self.arithmetic.vanishes(x) for x in self.residue(row))

    def add(self, row: Sequence[Any]) -> bool:
        """Add a row; return whether it is independent of those before."""
        arithmetic = self.arithmetic
        left = self.residue(row)
        pivot = _pivot(arithmetic, [[x] for x in left], 0, 0)
        if pivot is None:
            return False
        scale = arithmetic.inverse(left[pivot])
        self._echelon.append((pivot, [arithmetic.reduce(x * scale) for x in left]))
        return True


def rank(arithmetic: NumberField, rows: Sequence[Sequence[Any]]) -> int:
    """The rank of a matrix of shape (m, n)."""
    return len(row_reduced(arithmetic, rows)[1])


def nullspace(arithmetic: NumberField, rows: Sequence[Sequence[Any]], width: int) -> list[NumberRow]:
    """A basis of the x with A x = 0: A of shape (m, width), basis vectors of shape (width,)."""
    reduced, pivots = row_reduced(arithmetic, rows)
    basis = []
    for free in (c for c in range(width) if c not in pivots):
        vector = [arithmetic.number(0)] * width
        vector[free] = arithmetic.number(1)
        for row, pivot in zip(reduced, pivots, strict=True):
            vector[pivot] = arithmetic.reduce(-row[free])
        basis.append(vector)
    return basis


def solution(
    arithmetic: NumberField,
    rows: Sequence[Sequence[Any]],
    right: Sequence[Any],
    free: Sequence[Any] | None = None,
) -> NumberRow | None:
    """An x with A x = b, or None when there is none. A of shape (m, n), b of shape (m,), x of shape (n,).

    Unknowns that stay free take their values from `free`, shape (n,), or 0.
    """
    width = len(rows[0]) if rows else len(free or ())
    reduced, pivots = row_reduced(arithmetic, [[*row, b] for row, b in zip(rows, right, strict=True)])
    if width in pivots:
        return None
    x = list(free) if free is not None else [arithmetic.number(0)] * width
    others = [c for c in range(width) if c not in pivots]
    for row, pivot in zip(reduced, pivots, strict=True):
        x[pivot] = arithmetic.reduce(row[width] - sum(row[c] * x[c] for c in others))
    return x


def _pivot(arithmetic: NumberField, rows: list[NumberRow], top: int, column: int) -> int | None:
    candidates = range(top, len(rows))
    # What is not zero mod p is exactly not zero. A real pivot must be the largest, lest rounding errors grow, and when
    # even that one vanishes, all do.
    if arithmetic.exact:
        return next((n for n in candidates if rows[n][column] != 0), None)
    best = max(candidates, key=lambda n: abs(rows[n][column]), default=None)
    return None if best is None or arithmetic.vanishes(rows[best][column]) else best
