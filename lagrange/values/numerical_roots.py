"""All real roots of n equations in n unknowns in a box, by interval arithmetic.

A box is excluded where the range of some equation over it, enclosed with outward rounding, does not contain 0. With
the midpoint m and C an approximate inverse of the Jacobian there, Krawczyk's operator

    K(X) = m − C f(m) + (1 − C F'(X)) (X − m)

lies inside X only if X contains exactly one root. Otherwise a box is cut, across its longest side. The list is
complete if every box was excluded or belongs to a root; a box that stays undecided, near a double root, makes it
incomplete, and so does the bound on the number of boxes. With three unknowns and more the search ends after a few of
these: roots that fill a curve would need ever more. The boxes that are tested are a little larger than those cut,
so that a root on the edge of two is found. Reference: Neumaier, Interval Methods for Systems of Equations, ch. 5.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import combinations
from itertools import product as combined
from typing import Any, TypeAlias

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.intervals import Interval, IntervalProgram, outward, product, scaled, total
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.values.limits import (
    CUT,
    INFLATION,
    MOST_BOXES,
    MOST_OPERATIONS,
    MOST_STEPS,
    MOST_UNDECIDED,
    SMALLEST_BOX,
    STARTS,
    WORKING_DIGITS,
)

RootBox: TypeAlias = list[Interval]


@record
class NumericalRoot:
    """One root, to `WORKING_DIGITS`, the only one in a box around it."""

    values: tuple[sp.Float, ...]
    box: tuple[tuple[float, float], ...]


@record
class Roots:
    """The roots in a box; `complete`: whether these are proved to be all."""

    roots: tuple[NumericalRoot, ...]
    complete: bool


def real_roots(
    equations: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    search: Sequence[tuple[float, float]],
    starts: Sequence[float] = (),
) -> Roots:
    """All common zeros of the expressions, whose other constants are numbers, in a box.

    starts  where Newton's iteration starts, as parts of the width of the search, also with one or two unknowns
    """
    system = _System(equations, unknowns)
    waiting: list[RootBox] = [[(float(low), float(high)) for low, high in search]]
    widths = [float(high) - float(low) for low, high in search]
    roots: list[NumericalRoot] = []
    undecided: list[RootBox] = []
    most, boxes = min(MOST_BOXES, MOST_OPERATIONS // system.operations), 0
    several = len(unknowns) > 2
    if several or starts:
        roots += _from_starts(system, search, starts or STARTS)
    while waiting and boxes < most:
        boxes += 1
        box = waiting.pop()
        if system.excludes(box) or any(_contains(r.box, box) for r in roots):
            continue
        larger = [_inflated(x) for x in box]
        mapped = system.krawczyk(larger)
        if several and mapped is not None:
            smaller = _common(mapped, box)
            if smaller is None:
                continue
            if _size(smaller, widths) < 0.5 * _size(box, widths):
                box = smaller
        root = _confirmed(system, larger, mapped)
        if root is not None:
            if not any(_same(root, other) for other in roots):
                roots.append(root)
            if _contains(root.box, box):
                continue
        if all(_width(x) < SMALLEST_BOX * w for x, w in zip(box, widths, strict=True)):
            undecided.append(box)
            if several and len(undecided) > MOST_UNDECIDED:
                break
            continue
        waiting += _halves(box, widths)
    inside = [r for r in roots if all(lo <= v <= hi for v, (lo, hi) in zip(r.values, search, strict=True))]
    left = [b for b in (*waiting, *undecided) if not any(_contains(r.box, b) for r in roots)]
    return Roots(tuple(sorted(inside, key=lambda r: [float(v) for v in r.values])), not left)


def sign_at(e: sp.Expr, unknowns: Sequence[sp.Symbol], root: NumericalRoot) -> int | None:
    """The sign of an expression at a root; None if the enclosure contains 0."""
    return _sign(_value_at(e, unknowns, root))


def signs_of_minors(
    matrix: Sequence[Sequence[sp.Expr]], unknowns: Sequence[sp.Symbol], root: NumericalRoot
) -> dict[tuple[int, ...], int | None]:
    """The signs of all principal minors of a symmetric matrix at a root, by their rows, likewise."""
    entries = [_all([_value_at(x, unknowns, root) for x in row]) for row in matrix]
    known = [row for row in entries if row is not None]
    size = range(len(matrix))
    every = (rows for n in size for rows in combinations(size, n + 1))
    return {rows: _sign(_determinant(known, rows)) if len(known) == len(matrix) else None for rows in every}


def _determinant(
    entries: Sequence[Sequence[Interval]], rows: Sequence[int], columns: Sequence[int] | None = None
) -> Interval:
    """By expansion: the entries are enclosed tightly, and rows are few."""
    columns = rows if columns is None else columns
    if not rows:
        return 1.0, 1.0
    whole = (0.0, 0.0)
    for n, k in enumerate(columns):
        minor = _determinant(entries, rows[1:], [*columns[:n], *columns[n + 1 :]])
        whole = total(whole, scaled((-1) ** n, product(entries[rows[0]][k], minor)))
    return whole


def _value_at(e: sp.Expr, unknowns: Sequence[sp.Symbol], root: NumericalRoot) -> Interval | None:
    tight = [(v - abs(v) * 1e-12 - 1e-14, v + abs(v) * 1e-12 + 1e-14) for v in map(float, root.values)]
    return IntervalProgram([e], unknowns).at(tight)[0]


def _sign(value: Interval | None) -> int | None:
    return None if value is None else 1 if value[0] > 0 else -1 if value[1] < 0 else None


def _width(x: Interval) -> float:
    return x[1] - x[0]


def _inflated(x: Interval) -> Interval:
    margin = INFLATION * _width(x) + 1e-300
    return x[0] - margin, x[1] + margin


def _contains(outer: Sequence[tuple[float, float]], box: RootBox) -> bool:
    return all(low <= a and b <= high for (low, high), (a, b) in zip(outer, box, strict=True))


def _same(root: NumericalRoot, other: NumericalRoot) -> bool:
    """Whether two roots are one: each box has one root only."""
    pairs = ((root, other), (other, root))
    return any(all(lo <= v <= hi for v, (lo, hi) in zip(a.values, b.box, strict=True)) for a, b in pairs)


def _halves(box: RootBox, widths: Sequence[float]) -> list[RootBox]:
    at = max(range(len(box)), key=lambda n: _width(box[n]) / widths[n])
    low, high = box[at]
    cut = low + CUT * (high - low)
    return [[*box[:at], ends, *box[at + 1 :]] for ends in ((low, cut), (cut, high))]


class _System:
    """The equations and their Jacobian, as they are and as programs."""

    def __init__(self, equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> None:
        self.equations, self.unknowns = equations, unknowns
        self.jacobian = [[e.diff(u) for u in unknowns] for e in equations]
        self.operations = sum(count_operations(e) + 1 for row in (equations, *self.jacobian) for e in row)
        self._ranges = IntervalProgram(equations, unknowns)
        self._slopes = IntervalProgram(self.entries, unknowns)

    @property
    def entries(self) -> list[sp.Expr]:
        """The Jacobian, row by row."""
        return [d for row in self.jacobian for d in row]

    def excludes(self, box: RootBox) -> bool:
        """Whether some equation has no zero in a box."""
        return any(value is not None and not value[0] <= 0 <= value[1] for value in self._ranges.at(box))

    def krawczyk(self, box: RootBox) -> RootBox | None:
        """K(X), which contains every root in X; None if it has no value."""
        size = range(len(box))
        middle = [(low + high) / 2 for low, high in box]
        at = [(m, m) for m in middle]
        f, slopes, enclosed = _all(self._ranges.at(at)), _all(self._slopes.at(at)), _all(self._slopes.at(box))
        if f is None or slopes is None or enclosed is None:
            return None
        centred = [(low + high) / 2 for low, high in slopes]
        inverse = _inverse([centred[len(box) * n : len(box) * (n + 1)] for n in size])
        if inverse is None:
            return None
        mapped = []
        for n in size:
            value = at[n]
            for k in size:
                value = total(value, scaled(-inverse[n][k], f[k]))
            for j in size:
                entry = (1.0, 1.0) if n == j else (0.0, 0.0)
                for k in size:
                    entry = total(entry, scaled(-inverse[n][k], enclosed[len(box) * k + j]))
                value = total(value, product(entry, outward(box[j][0] - middle[j], box[j][1] - middle[j])))
            mapped.append(value)
        return mapped


def _all(values: Sequence[Interval | None]) -> list[Interval] | None:
    """The values, if there is none without one."""
    known = [v for v in values if v is not None]
    return known if len(known) == len(values) else None


def _confirmed(system: _System, box: RootBox, mapped: RootBox | None) -> NumericalRoot | None:
    """The root in a box, if Krawczyk's operator proves that there is exactly one."""
    if mapped is None or not all(k[0] > x[0] and k[1] < x[1] for k, x in zip(mapped, box, strict=True)):
        return None
    values = _refined(system, [(low + high) / 2 for low, high in box])
    if values is None or not all(low < v < high for v, (low, high) in zip(values, box, strict=True)):
        return None
    return NumericalRoot(values, tuple(box))


def _common(mapped: RootBox, box: RootBox) -> RootBox | None:
    """What two boxes have in common; None if that is nothing."""
    both = [(max(k[0], x[0]), min(k[1], x[1])) for k, x in zip(mapped, box, strict=True)]
    return None if any(low > high for low, high in both) else both


def _size(box: RootBox, widths: Sequence[float]) -> float:
    return math.prod(_width(x) / w for x, w in zip(box, widths, strict=True))


def _from_starts(
    system: _System, search: Sequence[tuple[float, float]], starts: Sequence[float]
) -> list[NumericalRoot]:
    """Roots to which Newton's iteration leads from a grid, each proved in a small box around it.

    With three unknowns and more the boxes of the search are many, and these roots are known whether it ends or not.
    """
    roots: list[NumericalRoot] = []
    size = len(system.unknowns)
    program = _Program([*system.equations, *system.entries], system.unknowns)
    grid = [[low + (high - low) * part for part in starts] for low, high in search]
    for start in combined(*grid):
        place = _iterated(program, size, start)
        if place is None or not all(low <= x <= high for x, (low, high) in zip(place, search, strict=True)):
            continue
        if any(all(low <= x <= high for x, (low, high) in zip(place, r.box, strict=True)) for r in roots):
            continue
        for part in (1e-2, 1e-4, 1e-6):
            margins = [part * (high - low) for low, high in search]
            near = [(x - margin, x + margin) for x, margin in zip(place, margins, strict=True)]
            root = _confirmed(system, near, system.krawczyk(near))
            if root is not None:
                roots += [root] if not any(_same(root, other) for other in roots) else []
                break
    return roots


def _iterated(program: _Program, size: int, start: Sequence[float]) -> list[float] | None:
    """Newton's iteration in floating point; None if it does not converge soon."""
    place = list(start)
    for _ in range(MOST_STEPS):
        try:
            values = program.at(place)
            f, slopes = values[:size], values[size:]
            inverse = _inverse([slopes[size * n : size * (n + 1)] for n in range(size)])
        except (ValueError, ZeroDivisionError, OverflowError):
            return None
        if inverse is None:
            return None
        steps = [sum(a * b for a, b in zip(row, f, strict=True)) for row in inverse]
        place = [x - s for x, s in zip(place, steps, strict=True)]
        if all(abs(s) < 1e-11 * (1 + abs(x)) for s, x in zip(steps, place, strict=True)):
            return place
    return None


class _Program:
    """Expressions as a list of operations in floating point, each common part once.

    Raises ValueError, ZeroDivisionError, OverflowError where one has no value.
    """

    def __init__(self, expressions: Sequence[sp.Basic], unknowns: Sequence[sp.Symbol]) -> None:
        self.places: dict[sp.Basic, int] = {u: n for n, u in enumerate(unknowns)}
        self.start: list[float] = [0.0] * len(unknowns)
        self.operations: list[tuple[int, Callable[[list[float]], float], list[int]]] = []
        self.results = [self._place(e) for e in expressions]

    def _place(self, e: sp.Basic) -> int:
        if e not in self.places:
            parts = [self._place(a) for a in e.args]
            self.places[e] = len(self.start)
            self.start.append(0.0 if parts else float(e))
            if parts:
                self.operations.append((self.places[e], _operation(e), parts))
        return self.places[e]

    def at(self, point: Sequence[float]) -> list[float]:
        """The values of the expressions at a point."""
        values = [*point, *self.start[len(point) :]]
        for place, operation, parts in self.operations:
            values[place] = operation([values[n] for n in parts])
        return [values[n] for n in self.results]


def _operation(e: sp.Basic) -> Callable[[list[float]], float]:
    if e.is_Add:
        return math.fsum
    if e.is_Mul:
        return math.prod
    if e.is_Pow:
        return lambda parts: math.pow(*parts)
    function = _FUNCTIONS.get(e.func, _no_value)
    return lambda parts: function(*parts)


def _no_value(*_: float) -> float:
    raise ValueError


_FUNCTIONS: Mapping[Any, Callable[[float], float]] = {
    sp.sin: math.sin, sp.cos: math.cos, sp.tan: math.tan, sp.exp: math.exp, sp.log: math.log, sp.Abs: abs,
}  # fmt: skip


def _inverse(matrix: Sequence[Sequence[float]]) -> list[list[float]] | None:
    """The inverse of a matrix, roughly; None if it is singular."""
    size = len(matrix)
    rows = [[*map(float, row), *(float(n == k) for k in range(size))] for n, row in enumerate(matrix)]
    for n in range(size):
        best = max(range(n, size), key=lambda k: abs(rows[k][n]))
        if rows[best][n] == 0:
            return None
        rows[n], rows[best] = rows[best], rows[n]
        pivot = [x / rows[n][n] for x in rows[n]]
        rows = [pivot if k == n else [x - row[n] * y for x, y in zip(row, pivot, strict=True)]
                for k, row in enumerate(rows)]  # fmt: skip
    return [row[size:] for row in rows]


def _refined(system: _System, start: Sequence[float]) -> tuple[sp.Float, ...] | None:
    """Newton's iteration to full precision."""
    values = [sp.Float(x, 2 * WORKING_DIGITS) for x in start]
    for _ in range(60):
        rule = dict(zip(system.unknowns, values, strict=True))
        residual = sp.Matrix([e.xreplace(rule).evalf(2 * WORKING_DIGITS) for e in system.equations])
        slope = sp.Matrix([[d.xreplace(rule).evalf(2 * WORKING_DIGITS) for d in row] for row in system.jacobian])
        if not all(x.is_number and x.is_real for x in (*residual, *slope)):
            return None
        step = _solved(slope, residual)
        if step is None:
            return None
        values = [sp.Float(v - s, 2 * WORKING_DIGITS) for v, s in zip(values, step, strict=True)]
        if all(
            abs(s) <= sp.Float(10) ** (-WORKING_DIGITS - 5) * (1 + abs(v)) for v, s in zip(values, step, strict=True)
        ):
            return tuple(sp.Float(v, WORKING_DIGITS) for v in values)
    return None


def _solved(slope: sp.Matrix, residual: sp.Matrix) -> list[sp.Float] | None:
    """The step of Newton's iteration; None if the matrix is singular.

    By mpmath, with pivots by size: SymPy takes the first one that is not zero, be it zero but for rounding.
    """
    digits = 2 * WORKING_DIGITS
    with mpmath.workdps(digits):
        rows = [[mpmath.mpf(sp.Float(x, digits)._mpf_) for x in slope.row(n)] for n in range(slope.rows)]
        right = [mpmath.mpf(sp.Float(x, digits)._mpf_) for x in residual]
        try:
            return [sp.Float(x, digits) for x in mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix(right))]
        except (ZeroDivisionError, ValueError):
            return None
