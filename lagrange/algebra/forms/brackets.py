"""What two displacements and both back again leave: the commutator of two directions that a form admits.

For ω = a dx + b dy + c dz let X and Y be directions with ω(X) = ω(Y) = 0. To go ε along X, ε along Y, back along X and
back along Y ends ε² [X, Y] from the start, up to higher orders, with [X, Y] = (X·∇) Y − (Y·∇) X. Since
ω([X, Y]) = −dω(X, Y), where ω ∧ dω is not zero, this is a direction that the form forbids at every single step.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.forms.limits import LONGEST_DIRECTION
from lagrange.core.operations import count_operations
from lagrange.core.records import record

Direction = tuple[sp.Expr, ...]


@record
class Manoeuvre:
    """Two admitted directions, and what going along both and back along both leaves."""

    first: Direction
    second: Direction
    left_over: Direction


def manoeuvre(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol]) -> Manoeuvre | None:
    """For a form in three variables with one coefficient 0 and short others; None for any other."""
    if (
        len(variables) != 3
        or sum(a == 0 for a in form) != 1
        or sum(count_operations(a) for a in form) > LONGEST_DIRECTION
    ):
        return None
    n = next(k for k, a in enumerate(form) if a == 0)
    m, k = (j for j in range(3) if j != n)
    first = [sp.S.Zero] * 3
    first[m], first[k] = -form[k], form[m]
    second = [sp.S.Zero] * 3
    second[n] = sp.S.One
    if first[m].could_extract_minus_sign() and not first[k].is_number:
        first = [-a for a in first]
    left = [
        sum((x * b.diff(v) - y * a.diff(v) for v, x, y in zip(variables, first, second, strict=True)), sp.S.Zero)
        for a, b in zip(first, second, strict=True)
    ]
    return Manoeuvre(tuple(first), tuple(second), tuple(map(sp.expand, left)))
