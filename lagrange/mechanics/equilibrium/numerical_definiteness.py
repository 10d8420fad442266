"""Whether a matrix of numbers is positive definite, by the signs of its principal minors in interval arithmetic.

At an equilibrium whose position is a number, nested roots may be too long to be judged in closed form. An interval that
is rounded outwards and does not contain 0 has the sign of the number in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.intervals import EmptyIntervalError, enclosure
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium


def is_definite(matrix: Sequence[Sequence[sp.Expr]], e: Equilibrium, at: Values) -> bool | None:
    """Whether K at a point is positive definite; False if it takes negative values; None: undecided."""
    size = len(matrix)
    letters = sp.Matrix(size, size, lambda i, j: sp.Symbol(f"K_{min(i, j)}{max(i, j)}", real=True))
    try:
        box = {letters[i, j]: enclosure(e.solution.at(at, matrix[i][j]), {}) for i in range(size) for j in range(i + 1)}
        leading = []
        for n in range(1, size + 1):
            for rows in combinations(range(size), n):
                low, high = enclosure(letters.extract(list(rows), list(rows)).det(method="berkowitz"), box)
                if high < 0:
                    return False
                if rows == tuple(range(n)):
                    leading.append(low > 0)
    except (NotAlgebraicError, DivisionByZeroError, EmptyIntervalError, ValueError, KeyError, OverflowError):
        return None
    return True if all(leading) else None
