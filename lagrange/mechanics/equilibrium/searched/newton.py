"""Zeros of m functions of n unknowns: found from many places in floating point, confirmed with sixty digits.

The search takes Levenberg's and Marquardt's steps,

    (Jᵀ J + μ) δ = −Jᵀ f ,

with small μ near a zero, where they are Newton's, and large μ where a step makes |f| larger; J need be neither square
nor regular, so that equilibria which fill a curve are reached as well. A zero is confirmed by Newton's own steps with
many digits: at a regular zero, or a curve of such, each step doubles the number of right digits, and |f| < 10⁻⁴⁵ is
reached soon. A multiple zero, which is approached slowly, is not confirmed, and neither is a place where |f| is only
small. Reference: Nocedal and Wright, Numerical Optimization, ch. 10 and 11.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import mpmath

from lagrange.mechanics.equilibrium.limits import (
    CONFIRMING_DIGITS,
    CONFIRMING_STEPS,
    NEWTON_STEPS,
    SEARCH_DIGITS,
    SMALL_PIVOT,
    STILL,
)

Number = Any
NumericalFunctions = Callable[[Sequence[Number]], list[Number]]
"""f(x); raises ValueError or ArithmeticError where it has no value."""


def zero_near(f: NumericalFunctions, start: Sequence[float], largest: float) -> list[float] | None:
    """A zero to about ten digits; None if the iteration does not converge, or leaves |x| < largest."""
    x, damping = list(start), 1e-2
    try:
        value = f(x)
    except (ValueError, ArithmeticError):
        return None
    size = _square(value)
    for _ in range(NEWTON_STEPS):
        if size < STILL**2:
            return x
        try:
            slopes = _slopes(f, x, value, 1e-7)
        except (ValueError, ArithmeticError):
            return None
        normal = [[_inner(a, b) for b in slopes] for a in slopes]
        right = [-_inner(a, value) for a in slopes]
        for _ in range(6):
            step = _solved([[e + damping * (i == j) for j, e in enumerate(row)] for i, row in enumerate(normal)], right)
            moved = [a + b for a, b in zip(x, step, strict=True)] if step is not None else x
            try:
                there = f(moved) if step is not None and max(map(abs, moved)) < largest else None
            except (ValueError, ArithmeticError):
                there = None
            if there is not None and (less := _square(there)) < size:
                x, value, size, damping = moved, there, less, max(damping / 30, 1e-14)
                break
            damping *= 10
        else:
            return None
    return x if size < STILL**2 else None


def with_best(f: NumericalFunctions, start: Sequence[float], first: int) -> list[float]:
    """The start with the unknowns from `first` on, in which f is linear, such that |f| is least."""
    x = list(start)
    try:
        value = f(x)
        slopes = [[u - v for u, v in zip(f([*x[:k], x[k] + 1, *x[k + 1 :]]), value, strict=True)]
                  for k in range(first, len(x))]  # fmt: skip
    except (ValueError, ArithmeticError):
        return x
    normal = [[_inner(a, b) + 1e-12 * (i == j) for j, b in enumerate(slopes)] for i, a in enumerate(slopes)]
    step = _solved(normal, [-_inner(a, value) for a in slopes])
    return x if step is None else [*x[:first], *(a + b for a, b in zip(x[first:], step, strict=True))]


def confirmed(f: NumericalFunctions, guess: Sequence[float]) -> list[Number] | None:
    """The zero near a guess to many digits; None where it does not converge fast."""
    with mpmath.workdps(SEARCH_DIGITS):
        x = [mpmath.mpf(a) for a in guess]
        width = mpmath.mpf(10) ** (-SEARCH_DIGITS // 2)
        try:
            for _ in range(CONFIRMING_STEPS):
                value = f(x)
                if max(map(abs, value), default=0) < mpmath.mpf(10) ** -CONFIRMING_DIGITS:
                    return x if max(abs(a - b) for a, b in zip(x, guess, strict=True)) < 1e-4 else None
                step = _newton_step(_slopes(f, x, value, width), value)
                if step is None:
                    return None
                x = [a + b for a, b in zip(x, step, strict=True)]
        except (ValueError, ArithmeticError):
            pass
        return None


def numerical_rank(rows: Sequence[Sequence[Number]]) -> int:
    """The rank of a matrix of numbers, counting what is not small."""
    return len(_pivots([list(r) for r in rows]))


def _slopes(f: NumericalFunctions, x: Sequence[Number], value: Sequence[Number], width: Number) -> list[list[Number]]:
    """The columns of J, by differences."""
    columns = []
    for k, a in enumerate(x):
        part = width * (1 + abs(a))
        there = f([*x[:k], a + part, *x[k + 1 :]])
        columns.append([(u - v) / part for u, v in zip(there, value, strict=True)])
    return columns


def _square(value: Sequence[Number]) -> Number:
    return sum(v * v for v in value)


def _inner(a: Sequence[Number], b: Sequence[Number]) -> Number:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _solved(matrix: list[list[Number]], right: Sequence[Number]) -> list[Number] | None:
    """The solution of a square system; None where it is singular."""
    rows = [[*row, r] for row, r in zip(matrix, right, strict=True)]
    size = len(rows)
    for k in range(size):
        best = max(range(k, size), key=lambda n: abs(rows[n][k]))
        if not abs(rows[best][k]) > 0:
            return None
        rows[k], rows[best] = rows[best], rows[k]
        pivot = rows[k]
        for n in range(k + 1, size):
            factor = rows[n][k] / pivot[k]
            if factor:
                rows[n] = [a - factor * b for a, b in zip(rows[n], pivot, strict=True)]
    solution: list[Number] = [0] * size
    for k in reversed(range(size)):
        rest = rows[k][size] - _inner(rows[k][k + 1 : size], solution[k + 1 :])
        solution[k] = rest / rows[k][k]
    return solution


def _pivots(rows: list[list[Number]]) -> list[tuple[int, int]]:
    """The places of the pivots, by Gaussian elimination with full pivoting."""
    places: list[tuple[int, int]] = []
    largest = max((abs(e) for row in rows for e in row), default=0)
    open_rows, open_columns = {*range(len(rows))}, {*range(len(rows[0]) if rows else 0)}
    while open_rows and open_columns:
        size, i, j = max((abs(rows[i][j]), i, j) for i in open_rows for j in open_columns)
        if not size > SMALL_PIVOT * largest:
            break
        places.append((i, j))
        open_rows.remove(i)
        open_columns.remove(j)
        for n in open_rows:
            factor = rows[n][j] / rows[i][j]
            rows[n] = [a - factor * b for a, b in zip(rows[n], rows[i], strict=True)]
    return places


def _newton_step(slopes: Sequence[Sequence[Number]], value: Sequence[Number]) -> list[Number] | None:
    """The step that makes independent equations zero, with the unknowns that are left open unchanged."""
    places = _pivots([list(column) for column in slopes])
    unknowns, equations = [i for i, _ in places], [j for _, j in places]
    part = _solved([[slopes[i][j] for i in unknowns] for j in equations], [-value[j] for j in equations])
    if part is None:
        return None
    step: list[Number] = [mpmath.mpf(0)] * len(slopes)
    for i, a in zip(unknowns, part, strict=True):
        step[i] = a
    return step
