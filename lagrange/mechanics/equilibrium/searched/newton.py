"""Zeros of m functions of n unknowns: found from many places in floating point, confirmed with sixty digits.

The search takes Levenberg's and Marquardt's steps,

    (Jᵀ J + μ) δ = −Jᵀ f ,

with small μ near a zero, where they are Newton's, and large μ where a step makes |f| larger; J need be neither square
nor regular, so that equilibria which fill a curve are reached as well. A zero is confirmed by Newton's own steps with
many digits: at a regular zero, or a curve of such, each step doubles the number of right digits, and |f| < 10⁻⁴⁵ is
reached soon. A multiple zero, which is approached slowly, is not confirmed, and neither is a place where |f| is only
small. Reference: Nocedal and Wright, Numerical Optimization, ch. 10 and 11.

Expressions as one list of operations, to be evaluated many times, in floating point or with many digits.

A subexpression that occurs several times is one operation. The second arithmetic is the judge of the first: a zero of
floats is only a guess, which `newton.confirmed` follows to sixty digits.

Numbers for parameters, and places from which a search begins.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from random import Random
from typing import Any

import mpmath
import sympy as sp

from lagrange.core.floats import FUNCTIONS
from lagrange.core.records import record
from lagrange.core.symbols import Bounded, Sign
from lagrange.mechanics.equilibrium.limits import (
    BOX,
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
    """The zero near a guess to many digits; None if it does not converge fast."""
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
    """The solution of a square system; None if it is singular."""
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


# Tape


class NoTapeError(Exception):
    """An expression has a part that is not evaluated: an undefined function, a case distinction."""


@record
class Arithmetic:
    """The implementation of operations. They raise ValueError or ArithmeticError if there is no real value."""

    rational: Callable[[int, int], Number]
    pi: Callable[[], Number]
    root: Callable[[Number], Number]
    power: Callable[[Number, Number], Number]
    functions: Mapping[type[sp.Basic], Callable[..., Number]]


def _real(function: Callable[..., Number]) -> Callable[..., Number]:
    """A function of mpmath that refuses complex values."""

    def real(*arguments: Number) -> Number:
        value = function(*arguments)
        if isinstance(value, mpmath.mpc):
            raise ValueError
        return value

    return real


_NAMES = {f: f.__name__.lower() for f in FUNCTIONS} | {sp.Abs: "fabs", sp.sign: "sign"}

FLOATS = Arithmetic(lambda p, q: p / q, lambda: math.pi, math.sqrt, math.pow, FUNCTIONS)
DIGITS = Arithmetic(
    lambda p, q: mpmath.mpf(p) / q,
    lambda: +mpmath.mp.pi,
    _real(mpmath.sqrt),
    _real(mpmath.power),
    {f: _real(getattr(mpmath, name)) for f, name in _NAMES.items()},
)


class Tape:
    """Several expressions of the same symbols; `carried_out` counts operations."""

    def __init__(self, expressions: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]) -> None:
        self._places: dict[sp.Basic, int] = {s: n for n, s in enumerate(symbols)}
        self._given = len(symbols)
        self._operations: list[tuple[str, Any, tuple[int, ...]]] = []
        self._results = [self._placed(e) for e in expressions]
        self.carried_out = 0

    def values(self, given: Sequence[Number], by: Arithmetic = FLOATS) -> list[Number]:
        """The values of the expressions. Raises ValueError or ArithmeticError if one has none."""
        self.carried_out += len(self._operations)
        v = list(given)
        for kind, data, needs in self._operations:
            match kind:
                case "+":
                    v.append(sum([v[n] for n in needs]))
                case "*":
                    product = v[needs[0]]
                    for n in needs[1:]:
                        product = product * v[n]
                    v.append(product)
                case "^":
                    v.append(v[needs[0]] ** data if data > 0 else 1 / v[needs[0]] ** -data)
                case "root":
                    root = by.root(v[needs[0]])
                    v.append(root**data if data > 0 else 1 / root**-data)
                case "number":
                    v.append(by.rational(*data))
                case "pi":
                    v.append(by.pi())
                case "power":
                    v.append(by.power(*(v[n] for n in needs)))
                case _:
                    v.append(by.functions[data](*(v[n] for n in needs)))
        return [v[n] for n in self._results]

    def _placed(self, e: sp.Basic) -> int:
        place = self._places.get(e)
        if place is None:
            operation = self._operation(e)
            place = self._places[e] = self._given + len(self._operations)
            self._operations.append(operation)
        return place

    def _operation(self, e: sp.Basic) -> tuple[str, Any, tuple[int, ...]]:
        """The operation that an expression ends with. Raises NoTapeError."""
        if isinstance(e, sp.Rational):
            return "number", (int(e.p), int(e.q)), ()
        if e == sp.pi:
            return "pi", None, ()
        if isinstance(e, sp.Pow) and e.exp.is_Integer:
            return "^", int(e.exp), (self._placed(e.base),)
        if isinstance(e, sp.Pow) and e.exp.is_Rational and e.exp.q == 2:
            return "root", int(e.exp.p), (self._placed(e.base),)
        kind = "+" if e.is_Add else "*" if e.is_Mul else "power" if e.is_Pow else "f" if e.func in FUNCTIONS else None
        if kind is None:
            raise NoTapeError
        return kind, e.func, tuple(self._placed(a) for a in e.args)


# Random starts


def random_value(s: sp.Symbol, spread: float, random: Random) -> float:
    """A number for a parameter, of the sign or in the range that is declared."""
    if isinstance(s, Sign):
        return random.choice((-1.0, 1.0))
    if isinstance(s, Bounded):
        return float(s.low) + (float(s.high) - float(s.low)) * random.uniform(0.1, 0.9)
    size = 2 ** random.uniform(-spread, spread)
    if s.is_nonnegative or s.is_nonpositive:
        return size if s.is_nonnegative else -size
    return random.choice((-size, size))


def random_start(
    u: sp.Symbol, coordinates: Collection[sp.Symbol], angles: Collection[sp.Expr], random: Random
) -> float:
    """Where the search for an unknown begins: an angle anywhere, a force at 0."""
    if u not in coordinates:
        return 0.0
    return random.uniform(-3.1, 3.1) if u in angles else random.uniform(-BOX, BOX)
