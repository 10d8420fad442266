"""The frequency where an equilibrium given by its tangent is stable.

tan θ = a/g has two solutions, and on both ω² = [(a² + g²)/(g l)] cos θ. The one with cos θ > 0 is stable, and there
cos θ = g/√(a² + g²): ω² = √(a² + g²)/l, as it is printed in books.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.expression_size import count_operations
from lagrange.mechanics.equilibrium.linearization import SmallOscillations
from lagrange.mechanics.equilibrium.stability import Stability
from lagrange.mechanics.rewriting.readable_forms import divisors


def square_where_stable(square: sp.Expr, b: Branch, stability: Stability) -> sp.Expr | None:
    """ω² without the angle, where the sign of its cosine or sine decides stability; None if it is not shorter."""
    for r in b.equations:
        angle = r.lhs.args[0] if isinstance(r.lhs, sp.tan) else None
        if angle is None or angle not in square.free_symbols:
            continue
        cosine = _cosine(r, angle, stability)
        if cosine is None:
            return None
        without = square.xreplace({sp.cos(angle): cosine, sp.sin(angle): r.rhs * cosine, sp.tan(angle): r.rhs})
        without = sp.factor_terms(sp.together(without))
        is_shorter = count_operations(without) <= count_operations(square)
        return without if is_shorter and angle not in without.free_symbols else None
    return None


def _cosine(r: Relation, angle: sp.Expr, stability: Stability) -> sp.Expr | None:
    """cos θ where `cos θ > 0`, or sin θ > 0 and tan θ > 0, is what stability asks for."""
    if len(stability.conditions) != 1:
        return None
    [c] = stability.conditions
    sign = {">": 1, "<": -1}.get(c.relation)
    if sign is None or c.rhs != 0 or c.lhs not in (sp.cos(angle), sp.sin(angle)):
        return None
    if c.lhs == sp.sin(angle):
        if not (r.rhs.is_positive or r.rhs.is_negative):
            return None
        sign = sign if r.rhs.is_positive else -sign
    above, below = sp.fraction(sp.together(1 + r.rhs**2))
    return sign * sp.sqrt(below) / sp.sqrt(above)


def where_defined(s: SmallOscillations, b: Branch) -> SmallOscillations:
    """The verdict without conditions without which the branch has no place: φ' ≠ 0 for r = g/(φ'² sin α tan α)."""
    stability = s.judgement.stability
    below = divisors([r.rhs for r in b.relations])
    kept = tuple(c for c in stability.presupposed if c.relation != "≠" or c.lhs not in below)
    return replace(s, judgement=replace(s.judgement, stability=replace(stability, presupposed=kept)))
