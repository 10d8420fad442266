"""a sin θ + b θ cos θ = 0 within a quarter turn of θ = 0, whose other roots have no closed form.

tan θ/θ is even, and rises from 1 at θ = 0 without bound up to θ = π/2: its derivative is (2θ − sin 2θ)/(2θ² cos² θ).
So there is one pair of roots ±θ₁ beside θ = 0 where −b/a > 1, and none elsewhere. There the derivative of the left
side, with b θ = −a tan θ,

    a (1/cos θ − sin θ/θ) ,

has the sign of a, since 1/cos θ > 1 > sin θ/θ. A plank that rocks on a cylinder: h sin θ − R θ cos θ = 0.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.exact.zero_test import is_zero


def tangent_coefficients(e: sp.Expr, q: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """a and b of a sin q + b q cos q; None if the expression is not of this form, or a has no known sign."""
    a = e.xreplace({q: sp.pi / 2})
    b = -e.xreplace({q: sp.pi}) / sp.pi
    if a.has(sp.nan, sp.zoo) or b.has(sp.nan, sp.zoo) or sign_of(a) not in (1, -1):
        return None
    return (a, b) if is_zero(e - a * sp.sin(q) - b * q * sp.cos(q)) else None


def beside_zero(b: Branch, q: sp.Symbol) -> Branch | None:
    """The roots of such a branch with q ≠ 0, |q| ≤ π/2, and where they exist; None: nowhere. Others are unchanged."""
    found = tangent_coefficients(b.left[0], q) if len(b.left) == 1 and not b.relations else None
    if found is None or b.conditions != (SignCondition(q, "≠", sp.S.Zero),):
        return b
    steeper = -(found[0] + found[1]) * (sign_of(found[0]) or 1)
    sign = sign_of(steeper)
    if sign in (0, -1):
        return None
    conditions = b.conditions if sign == 1 else (more_than_zero(steeper), *b.conditions)
    return replace(b, conditions=conditions, occupied=True)


def slope(e: sp.Expr, q: sp.Symbol) -> tuple[sp.Expr, int] | None:
    """The derivative of such an expression at its roots beside zero, and its sign; None for other expressions."""
    found = tangent_coefficients(e, q)
    return None if found is None else (found[0] * (1 / sp.cos(q) - sp.sin(q) / q), sign_of(found[0]) or 0)
