"""Sines and cosines put together where vectors were multiplied out.

A file says `cross(omega, r)` or `dot(r', n)`; the components come out with sin²φ sin θ + cos²φ sin θ, or with
sin θ sin(θ + φ) + cos θ cos(θ + φ), which nobody would write. An expression with such products is put into textbook
form, and that is kept where it is shorter. What has no such products stays as the file has it.
"""

from __future__ import annotations

import sympy as sp

from lagrange.textbook import textbook_form

LONGEST = 300
"""Operations of an expression that is still tidied."""


def tidied(expression: sp.Expr) -> sp.Expr:
    """The expression, shorter where sin² + cos² = 1 or cos(a − b) = cos a cos b + sin a sin b makes it so."""
    if _degree(expression, sp.sin) < 2 or _degree(expression, sp.cos) < 2 or expression.count_ops() > LONGEST:
        return expression
    form = textbook_form(expression)
    return form if form.count_ops() < expression.count_ops() else expression


def _degree(expression: sp.Expr, function: type[sp.Function]) -> int:
    """How many sines, or cosines, are multiplied in one term, at most."""
    if isinstance(expression, function):
        return 1
    if expression.is_Add:
        return max(_degree(term, function) for term in expression.args)
    if expression.is_Mul:
        return sum(_degree(f, function) for f in expression.args)
    if expression.is_Pow and expression.exp.is_Integer and expression.exp > 0:
        return int(expression.exp) * _degree(expression.base, function)
    return 0
