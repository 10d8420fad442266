"""Results about rest and steady motion in the form in which the head of a page has them.

Only the cases of rest that the given values do not exclude are kept, and only the stronger of two inequalities a ≤ x, b
≤ x. A constant velocity is given by its square where it is a root: φ'² = 2 a g.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of

Inequality = tuple[sp.Expr, sp.Expr]
"""left ≤ right."""


def strictest_cases(
    cases: Sequence[Sequence[Inequality]], values: Mapping[sp.Symbol, sp.Expr]
) -> list[list[Inequality]]:
    """The cases that the values leave, without what is weaker than another condition; all if none is left."""
    possible = [case for case in cases if not any(_is_positive(a - b, values) for a, b in case)]
    return [[one for one in case if not any(_follows(one, o, values) for o in case)] for case in possible or cases]


def _follows(weak: Inequality, strong: Inequality, values: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Whether a condition holds with another one, s ≥ 4 cm with s ≥ 30 cm, and is not the same."""
    (a, b), (c, d) = weak, strong
    return _is_positive(c - a if b == d else b - d if a == c else sp.S.Zero, values)


def _is_positive(e: sp.Expr, values: Mapping[sp.Symbol, sp.Expr]) -> bool:
    return e.free_symbols <= values.keys() and sign_of(e.xreplace(dict(values))) == 1


def rate_or_square(v: sp.Symbol, value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """v and its value; v² and its value where that is free of a root, as the motion may go round in either sense."""
    has_root = value.is_nonnegative and any(p.exp == sp.S.Half for p in value.atoms(sp.Pow))
    square = sp.expand(value**2) if has_root else sp.S.Zero
    is_shorter = has_root and not square.is_Add and square.is_rational_function(*square.free_symbols)
    return (v**2, square) if is_shorter else (v, value)
