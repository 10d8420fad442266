"""Real solutions of equations found by brute force, for comparison: nothing here knows how `lagrange` solves them.

One unknown: the function is evaluated on a fine grid, each change of sign is refined by bisection, and so is each change
of sign of the derivative, where the function itself may touch zero. Several unknowns: Newton's iteration from many
random starts.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from random import Random

import mpmath
import sympy as sp

Function = Callable[..., float]
GRID = 700
STEP = 1e-6


def function(expression: sp.Expr, unknowns: Sequence[sp.Symbol]) -> Function:
    """The expression as a function of numbers; NaN where it is not real."""
    names = ("sin", "cos", "tan", "sqrt")
    compiled = sp.lambdify(list(unknowns), expression, [{n: getattr(cmath, n) for n in names}])

    def real(*values: float) -> float:
        try:
            found = complex(compiled(*values))
        except ZeroDivisionError:
            return math.nan
        return found.real if abs(found.imag) < 1e-12 else math.nan

    return real


def roots(f: Function, left: float, right: float, number: int = GRID) -> list[float]:
    """The roots of f from left to right."""
    shift = (right - left) / 3 / number
    grid = [left - shift + (right - left) * n / number for n in range(number + 2)]
    values = [f(x) for x in grid]
    size = max(abs(v) for v in values if not math.isnan(v))

    def slope(x: float) -> float:
        return f(x + STEP) - f(x - STEP)

    found: list[float] = []
    slopes = [slope(x) for x in grid]
    for g, at_grid in ((f, values), (slope, slopes)):
        for n in range(len(grid) - 1):
            a, b = at_grid[n], at_grid[n + 1]
            if math.isnan(a) or math.isnan(b) or a * b > 0:
                continue
            x = bisected(g, grid[n], grid[n + 1])
            if abs(f(x)) < size * 1e-9 and all(abs(x - y) > 1e-6 for y in found):
                found.append(x)
    return found


def bisected(f: Function, a: float, b: float) -> float:
    """Where f changes its sign."""
    low = f(a)
    for _ in range(60):
        middle = (a + b) / 2
        value = f(middle)
        if value == 0:
            return middle
        if low * value < 0:
            b = middle
        else:
            a, low = middle, value
    return (a + b) / 2


def newton_solutions(
    expressions: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol], random: Random, starts: int = 120, width: float = 4
) -> list[list[mpmath.mpf]]:
    """Solutions of a square system that Newton's iteration meets from random starts."""
    f = sp.lambdify(list(unknowns), sp.Matrix(expressions), "mpmath")
    jacobian = sp.lambdify(list(unknowns), sp.Matrix(expressions).jacobian(list(unknowns)), "mpmath")
    found: list[list[mpmath.mpf]] = []
    for _ in range(starts):
        x = mpmath.matrix([random.uniform(-width, width) for _ in unknowns])
        try:
            for _ in range(60):
                step = mpmath.lu_solve(jacobian(*x), f(*x))
                x = x - step
                if mpmath.norm(step) < 1e-13:
                    break
            if mpmath.norm(f(*x)) < 1e-10 and all(abs(mpmath.im(v)) < 1e-10 for v in x):
                found.append([mpmath.re(v) for v in x])
        except (ZeroDivisionError, ValueError, OverflowError):
            continue
    return found
