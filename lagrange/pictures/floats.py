"""Values of expressions and vectors in ordinary floating point, for drawing only: no verdict depends on them.

A value that is not real or does not exist raises NoValueError; so does a symbol without a value, and an undefined
function, unless the values have a symbol of its name.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.core.floats import FUNCTIONS
from lagrange.core.symbols import Unspecified
from lagrange.core.vectors import Vector
from lagrange.pictures.limits import LARGEST_VALUE

FloatValues = Mapping[sp.Symbol, float]
FloatVector = tuple[float, float, float]


class NoValueError(ValueError):
    """An expression has no real value of reasonable size."""


def value(expression: sp.Expr, values: FloatValues) -> float:
    """The value of an expression. Raises NoValueError, also for a symbol without a value."""
    try:
        number = _value(expression, values)
    except (ArithmeticError, ValueError) as error:
        raise NoValueError(str(error)) from None
    if not abs(number) < LARGEST_VALUE:  # the negation also catches nan
        raise NoValueError("too large")
    return number


def _value(e: sp.Basic, values: FloatValues) -> float:
    if isinstance(e, sp.Symbol):
        if e not in values:
            raise NoValueError(e.name)
        return values[e]
    if isinstance(e, sp.Number | sp.NumberSymbol):
        return float(e)
    if e.is_Add:
        return math.fsum(_value(a, values) for a in e.args)
    if e.is_Mul:
        return math.prod(_value(a, values) for a in e.args)
    if isinstance(e, sp.Pow):
        power = _value(e.base, values) ** _value(e.exp, values)
        if isinstance(power, complex):
            raise NoValueError("a root of a negative number")
        return float(power)
    if isinstance(e, Unspecified) and not any(e.orders) and sp.Symbol(e.name, real=True) in values:
        return values[sp.Symbol(e.name, real=True)]
    function = FUNCTIONS.get(type(e))
    if function is None:
        raise NoValueError(type(e).__name__)
    return float(function(*(_value(a, values) for a in e.args)))


def place(vector: Vector, values: FloatValues) -> FloatVector:
    """A vector's components along i, j, k. Raises NoValueError."""
    x, y, z = (value(c, values) for c in vector.fixed().components)
    return x, y, z


def minus(a: FloatVector, b: FloatVector) -> FloatVector:
    """a − b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def plus(a: FloatVector, b: FloatVector, times: float = 1.0) -> FloatVector:
    """a + times · b."""
    return a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]


def inner(a: Sequence[float], b: Sequence[float]) -> float:
    """a·b."""
    return math.fsum(x * y for x, y in zip(a, b, strict=True))


def outer(a: FloatVector, b: FloatVector) -> FloatVector:
    """a × b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def unit(a: FloatVector) -> FloatVector:
    """a/|a|. Raises NoValueError."""
    size = math.hypot(*a)
    if size < 1e-9:
        raise NoValueError("no direction")
    return a[0] / size, a[1] / size, a[2] / size


def solved(matrix: Sequence[Sequence[float]], right: Sequence[float]) -> list[float]:
    """The solution of a square system by Gaussian elimination with pivoting. Raises NoValueError if it is singular."""
    rows = [[*row, r] for row, r in zip(matrix, right, strict=True)]
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        if abs(rows[k][k]) < 1e-12:
            raise NoValueError("singular")
        for i in range(n):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k], strict=True)]
    return [rows[k][n] / rows[k][k] for k in range(n)]


def projected(
    relations: Sequence[sp.Expr], slopes: Sequence[Sequence[sp.Expr]], moving: Sequence[sp.Symbol], start: FloatValues
) -> dict[sp.Symbol, float]:
    """Values near the start at which the relations f vanish, by Newton's iteration.

    With fewer relations than coordinates, the step is the shortest one, δq = −Jᵀ (J Jᵀ)⁻¹ f.

    slopes  J, the derivatives of each relation by the coordinates that may change, shape (m, n)

    Raises NoValueError if it does not converge.
    """
    values = dict(start)
    if not relations:
        return values
    for _ in range(40):
        residuals = [value(f, values) for f in relations]
        if max(map(abs, residuals)) < 1e-11:
            return values
        rows = [[value(e, values) for e in row] for row in slopes]
        gram = [[inner(a, b) for b in rows] for a in rows]
        weights = solved(gram, residuals)
        for k, q in enumerate(moving):
            values[q] -= sum(w * row[k] for w, row in zip(weights, rows, strict=True))
    raise NoValueError("no point near the start")
