"""Decimals in answers: each stands for all numbers that round to it.

An equation with decimals d_1, ..., d_k is right if there are numbers d_i*, each within half a unit of the last place
of d_i, with which it follows from the equations of motion. At a state its row [A | b] has a residue modulo the rows of
the derived equations, F(d), and

    F(d*) = 0  at all states,      |d_i* − d_i| ≤ h_i .

The residues at several real states, together, are solved for d by Newton's iteration with the smallest steps; where
that leaves some of the d_i* open (an equation may be multiplied by any number), the solution nearest to the intervals
is found by projecting on them and on the solutions in turn. All this has eighty digits, so that a wrong equation
passes only if numbers within the intervals make it right. What was found at some states is confirmed at others.
Reference for projections in turn: Cheney and Goldstein 1959.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import RowSpace
from lagrange.algebra.exact.points_needed import REAL_DIGITS
from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    InadmissibleError,
    NoPointError,
    Point,
    Surface,
    UnsupportedError,
    ZeroDivisorError,
)
from lagrange.answers.limits import (
    DECIMAL_STATES,
    FAR_SHIFT,
    MAX_DECIMALS,
    MAX_PROJECTIONS,
    NEGLIGIBLE_PIVOT,
    NEWTON_STEPS_OF_DECIMALS,
    ROUNDING_EDGE,
    SLOW_PROGRESS,
    TINY_RESIDUAL,
)
from lagrange.answers.readings import decimals_in
from lagrange.core.symbols import Decimal
from lagrange.mechanics.dynamics.comparison import System, affine_rows, random_state, symbols_of

DecimalValues = Mapping[Decimal, sp.Float]


def as_written(e: sp.Expr) -> sp.Expr:
    """An expression with its decimals as the numbers that they are as written."""
    return e.xreplace({d: d.written for d in decimals_in([e])})


def rounded_in_motion(equations: Sequence[sp.Expr], system: System) -> DecimalValues | None:
    """Numbers that round to the decimals, with which equations follow from a system; None if none are found."""
    configuration = system.configuration
    known = (*system.accelerated_constraints, *system.equations)
    unknowns = (*system.multipliers, *configuration.slots.accelerations)
    symbols = [s for s in symbols_of((*equations, *known)) if not isinstance(s, Decimal)]

    def prepared(point: Point) -> tuple[Point, RowSpace]:
        moving = random_state(point, configuration, symbols)
        return moving, RowSpace(moving.arithmetic, affine_rows(moving, known, unknowns))

    return _rounded(equations, unknowns, configuration.states, prepared)


def numbers_rounding_to(expressions: Sequence[sp.Expr], surface: Surface | None = None) -> DecimalValues | None:
    """Numbers that round to the decimals, with which expressions vanish on a surface; None if none are found."""
    space = surface or Surface()
    for choice in product(*(_factors(e) for e in expressions)):
        values = _rounded(choice, (), space, lambda p: (p, RowSpace(p.arithmetic)))
        if values is not None:
            return values
    return None


def _factors(e: sp.Expr) -> list[sp.Expr]:
    """The factors one of which vanishes; Newton's iteration is slow where two nearly do."""
    return [f for f in sp.Mul.make_args(e) if decimals_in([f])] or [e]


def remark_on(values: DecimalValues) -> str:
    """The exact values assumed for the decimals of a correct equation."""
    changed = [d for d, v in values.items() if abs(v - d.written) > d.half_width / 10**6]
    shown = dict.fromkeys(f"{d.text} is taken as {sp.Float(values[d], _digits(d)):.{_digits(d)}g}" for d in changed)
    return f"{' and '.join(shown)}, rounded" if shown else ""


def _digits(d: Decimal) -> int:
    return len(d.text.partition("e")[0].replace(".", "").lstrip("0")) + 2


def _rounded(
    expressions: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    surface: Surface,
    prepared: Callable[[Point], tuple[Point, RowSpace]],
) -> DecimalValues | None:
    decimals = decimals_in(expressions)
    if not decimals or len(decimals) > MAX_DECIMALS:
        return None
    system = _Residues(expressions, decimals, unknowns)

    def at(point: Point) -> tuple[Point, RowSpace]:
        moving, space = prepared(point)
        system.at(moving, space, [moving.number(0)] * len(decimals))  # it can be evaluated here
        return moving, space

    try:
        *states, beside = surface.sampled(at, DECIMAL_STATES + 1, real=True)
        shifts = _solved(system, states)
        if shifts is None or not _vanish(system, [beside], shifts):
            return None
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ZeroDivisorError):
        return None
    values = system.values(states[0][0], shifts)
    return {d: sp.Float(str(values[d]), REAL_DIGITS) for d in decimals}


class _Residues:
    """F(s) and ∂F/∂s at a state, for d_i = (d_i as written) + h_i s_i, scaled to rows of size 1."""

    def __init__(self, expressions: Sequence[sp.Expr], decimals: Sequence[Decimal], unknowns: Sequence[sp.Symbol]):
        self.decimals = decimals
        self.unknowns = unknowns
        self.expressions = expressions
        self.slopes = [e.diff(d) for e in expressions for d in decimals]

    def values(self, point: Point, shifts: Sequence[Any]) -> dict[Decimal, Any]:
        """The values of the decimals."""
        return {
            d: point.number(*d.written.as_numer_denom()) + point.number(*d.half_width.as_numer_denom()) * s
            for d, s in zip(self.decimals, shifts, strict=True)
        }

    def at(self, moving: Point, space: RowSpace, shifts: Sequence[Any]) -> list[tuple[list[Any], Any]]:
        """Pairs of ∂F/∂s and F, one for each component. Raises InadmissibleError, also if F is not affine."""
        numbers = self.values(moving, shifts)
        here = moving.with_values(numbers)
        table = here.affine_each([*self.expressions, *self.slopes], self.unknowns)
        pairs: list[tuple[list[Any], Any]] = []
        k = len(self.decimals)
        widths = [moving.number(*d.half_width.as_numer_denom()) for d in self.decimals]
        for n in range(len(self.expressions)):
            rows = [table[n], *table[len(self.expressions) + n * k : len(self.expressions) + (n + 1) * k]]
            if any(row is None for row in rows):
                raise InadmissibleError
            weights = [1, *(numbers[d] for d in self.decimals)]  # without unknowns, the value itself is to vanish
            size = max(abs(w * x) for w, row in zip(weights, rows, strict=True) for x in row or ())
            if size == 0:
                raise InadmissibleError
            value, *slopes = (space.residue([x / size for x in row or ()]) for row in rows)
            for column, f in enumerate(value):
                pairs.append(([s[column] * w for s, w in zip(slopes, widths, strict=True)], f))
        return pairs


DecimalState = tuple[Point, RowSpace]


def _solved(system: _Residues, states: Sequence[DecimalState]) -> list[Any] | None:
    """Shifts −1 ≤ s_i ≤ 1 with F(s) = 0 at the states; None if none are found."""
    shifts = [states[0][0].number(0)] * len(system.decimals)
    least, stalled = None, 0
    for _ in range(NEWTON_STEPS_OF_DECIMALS):
        pairs = [pair for moving, space in states for pair in system.at(moving, space, shifts)]
        size = max(abs(f) for _, f in pairs)
        if size < TINY_RESIDUAL:
            return shifts if all(abs(s) <= ROUNDING_EDGE for s in shifts) else None
        stalled = stalled + 1 if least is not None and size > SLOW_PROGRESS * least else 0
        if stalled > 4:
            return None  # a wrong equation: nothing makes it vanish
        least = size if least is None else min(size, least)
        shifts = _nearest(pairs, shifts)
        if any(abs(s) > FAR_SHIFT for s in shifts):
            return None
    return None


def _vanish(system: _Residues, states: Sequence[DecimalState], shifts: Sequence[Any]) -> bool:
    return all(abs(f) < TINY_RESIDUAL for moving, space in states for _, f in system.at(moving, space, shifts))


def _nearest(pairs: Sequence[tuple[list[Any], Any]], shifts: list[Any]) -> list[Any]:
    """The solution of J (s' − s) = −F, in the sense of least squares, that is nearest to −1 ≤ s' ≤ 1."""
    k = len(shifts)
    sizes = [max(abs(slopes[i]) for slopes, _ in pairs) or 1 for i in range(k)]
    scaled = [([x / size for x, size in zip(slopes, sizes, strict=True)], f) for slopes, f in pairs]
    right = [sum(s * size * x for s, size, x in zip(shifts, sizes, slopes, strict=True)) - f for slopes, f in scaled]
    normal = [[sum(row[i] * row[j] for row, _ in scaled) for j in range(k)] for i in range(k)]
    sums = [sum(row[i] * b for (row, _), b in zip(scaled, right, strict=True)) for i in range(k)]
    rows = _eliminated([[*normal[i], sums[i]] for i in range(k)])
    rows = [[*(x * size for x, size in zip(row, sizes, strict=False)), row[k]] for row in rows]
    inside = shifts
    for _ in range(MAX_PROJECTIONS if len(rows) < k else 1):
        inside = _projected([min(max(s, -1), 1) for s in inside], rows)
        if all(abs(s) <= 1 for s in inside):
            break
    return inside


def _projected(s: list[Any], rows: Sequence[Sequence[Any]]) -> list[Any]:
    """The solution of R s = b that is nearest to s; rows [R | b]."""
    table = []
    for row in rows:
        scale = max(abs(x) for x in row[:-1])
        table.append([x / scale for x in row])
    k = len(s)
    products = [[sum(a[i] * b[i] for i in range(k)) for b in table] for a in table]
    residuals = [sum(a[i] * s[i] for i in range(k)) - a[k] for a in table]
    solved = _eliminated([[*line, r] for line, r in zip(products, residuals, strict=True)])
    y = [line[-1] for line in solved]
    return [s[i] - sum(a[i] * m for a, m in zip(table, y, strict=False)) for i in range(k)]


def _eliminated(rows: list[list[Any]]) -> list[list[Any]]:
    """The reduced echelon form of [A | b] for a matrix A of size 1, without the rows that vanish."""
    work, done = [list(row) for row in rows], 0
    for column in range(len(work[0]) - 1 if work else 0):
        best = max(range(done, len(work)), key=lambda n: abs(work[n][column]), default=None)
        if best is None or abs(work[best][column]) < NEGLIGIBLE_PIVOT:
            continue
        work[done], work[best] = work[best], work[done]
        work[done] = [x / work[done][column] for x in work[done]]
        for n, row in enumerate(work):
            if n != done:
                work[n] = [x - row[column] * y for x, y in zip(row, work[done], strict=True)]
        done += 1
    return work[:done]
