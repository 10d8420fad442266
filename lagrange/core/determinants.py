"""Determinants that are to be evaluated, not read.

SymPy's `det` multiplies polynomials out on the way, by Berkowitz' method too: half a minute for three rows of a top's
linear equations, where the question whether it is zero takes some milliseconds.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp


def expanded_determinant(rows: Sequence[Sequence[sp.Expr]]) -> sp.Expr:
    """By expansion along the first row, again and again: nothing is divided or multiplied out."""
    if not rows:
        return sp.S.One
    first, *others = rows
    terms = []
    for j, a in enumerate(first):
        if a != 0:
            terms.append(sp.Mul((-1) ** j, a, expanded_determinant([[*r[:j], *r[j + 1 :]] for r in others])))
    return sp.Add(*terms)
