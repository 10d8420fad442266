"""A conserved quantity without the velocities that constraints give.

Where a choice of coordinates keeps kinematic constraints, ẋ + R θ̇ = 0, its equations of motion end without θ̇. The
energy ½ m ẋ² + ½ I θ̇² is then ½ (m + I/R²) ẋ²: a quadratic form in the velocities that remain, whose coefficients are
collected. Where the coordinate itself occurs, as in a potential, both stay.
"""

from __future__ import annotations

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.core.symbols import Unspecified, prime
from lagrange.mechanics.dynamics.equations import EquationsOfMotion


def in_remaining_velocities(e: sp.Expr, motion: EquationsOfMotion) -> sp.Expr:
    """The expression with the eliminated velocities substituted, collected where that is shorter."""
    closed = motion.closed
    if closed is None or e.has(Unspecified) or not e.free_symbols & {*closed.velocities}:
        return e
    if any(prime(q) in closed.velocities and e.has(q) for q in motion.configuration.slots.coordinates):
        return e
    substituted = e.xreplace(dict(closed.velocities))
    remaining = [v for v in motion.configuration.slots.velocities if v not in closed.velocities]
    at_rest = substituted.xreplace(dict.fromkeys(remaining, sp.S.Zero))
    moving = sp.expand(substituted - at_rest)
    if not moving.is_polynomial(*remaining):
        return substituted
    terms = sp.Poly(moving, *remaining).terms()
    powers = (sp.Mul(*(v**n for v, n in zip(remaining, exponents, strict=True))) for exponents, _ in terms)
    kinetic = (_shorter(c) * p for p, (_, c) in zip(powers, terms, strict=True))
    collected = sp.Add(*kinetic, at_rest)
    return min(substituted, collected, key=count_operations)


def _shorter(coefficient: sp.Expr) -> sp.Expr:
    return min(sp.factor(coefficient), sp.factor_terms(coefficient), key=count_operations)
