"""Results about rest and steady motion in the form in which the head of a page has them.

Only the cases of rest that the given values do not exclude are kept, and only the stronger of two inequalities a ≤ x, b
≤ x. A constant velocity is given by its square where it is a root: φ'² = 2 a g.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition


def strictest_cases(
    cases: Sequence[Sequence[RestCondition]], values: Mapping[sp.Symbol, sp.Expr]
) -> list[list[RestCondition]]:
    """The cases that the values leave, without what is weaker than another condition; all if none is left."""
    possible = [case for case in cases if not any(_fails(c, values) for c in case)]
    return [[one for one in case if not any(_follows(one, o, values) for o in case)] for case in possible or cases]


def _fails(c: RestCondition, values: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Whether a condition does not hold with the values."""
    sense = _sign(c.left - c.right, values)
    return sense == 1 or (sense == 0 and c.relation == "<") or (sense == -1 and c.relation == "=")


def _follows(weak: RestCondition, strong: RestCondition, values: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Whether a condition holds with another one, s ≥ 4 cm with s ≥ 30 cm, and is not the same."""
    a, b, c, d = weak.left, weak.right, strong.left, strong.right
    if "=" in (weak.relation, strong.relation):
        return False
    return _sign(c - a if b == d else b - d if a == c else sp.S.Zero, values) == 1


def _sign(e: sp.Expr, values: Mapping[sp.Symbol, sp.Expr]) -> int | None:
    return sign_of(e.xreplace(dict(values))) if e.free_symbols <= values.keys() else None


def rate_or_square(v: sp.Symbol, value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """v and its value; v² and its value where that is free of a root, as the motion may go round in either sense."""
    has_root = value.is_nonnegative and any(p.exp == sp.S.Half for p in value.atoms(sp.Pow))
    square = sp.expand(value**2) if has_root else sp.S.Zero
    is_shorter = has_root and not square.is_Add and square.is_rational_function(*square.free_symbols)
    return (v**2, square) if is_shorter else (v, value)
