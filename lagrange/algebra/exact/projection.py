"""Newton's iteration onto a constraint surface, in real numbers of eighty digits.

From a random start, f + (∂f/∂q) Δq = 0 is solved with the smallest Δq: Δq = −Jᵀ y with J Jᵀ y = f. The
coordinates move, the parameters keep their random values. With redundant constraints J Jᵀ is singular, and any
y will do. Reference: any book on numerical analysis under Gauss–Newton for underdetermined systems.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from lagrange.algebra.exact.graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.reals import DIGITS, RealPoint

_STEPS = 30


def newton_point(point: RealPoint, constraints: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> bool:
    """Move the coordinates of a point onto the surface; whether that succeeded. The point is changed."""
    if not constraints:
        return True
    try:
        graph = point.graph
        residual = [graph.node(f) for f in constraints]
        jacobian = [[graph.node(f.diff(q)) for q in coordinates] for f in constraints]
        return _iterate(point, residual, jacobian, coordinates)
    except (InadmissibleError, UnsupportedError, DivisionByZeroError):
        return False


def _iterate(
    point: RealPoint, residual: list[int], jacobian: list[list[int]], coordinates: Sequence[sp.Symbol]
) -> bool:
    values = [point.input(q) for q in coordinates]
    tiny = point.number(1, 10 ** (DIGITS - 8))
    for _ in range(_STEPS):
        here = point.with_values(dict(zip(coordinates, values, strict=True)))
        f = [here.at(n) for n in residual]
        if max(abs(x) for x in f) < tiny:
            point.move(dict(zip(coordinates, values, strict=True)))
            return True
        step = _smallest_step(here, [[here.at(n) for n in row] for row in jacobian], f)
        if step is None:
            return False
        values = [x + dx for x, dx in zip(values, step, strict=True)]
    return False


def _smallest_step(point: Any, J: list[list[Any]], f: list[Any]) -> list[Any] | None:
    """−Jᵀ y with J Jᵀ y = f. J of shape (m, n), f of shape (m,)."""
    normal = [[sum(a * b for a, b in zip(r, s, strict=True)) for s in J] for r in J]
    y = point.solution(normal, f)
    if y is None:
        return None
    return [-sum(row[k] * y[n] for n, row in enumerate(J)) for k in range(len(J[0]))]
