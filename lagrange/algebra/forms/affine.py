"""Whether a constraint is affine in the velocities, a(q, t) · q' + b(q, t), decided without multiplying out.

The function is a polynomial in the velocities and in whatever depends on them in another way, sin q' say. Where its
degree as written is one, it is affine. Otherwise terms may cancel, (q₁' + q₂')² − q₁'² − 2 q₁' q₂' − q₂'²: the
coefficients are read off at random velocities, and the form they make is compared at others (Schwartz, Zippel). Rows of
a bicycle have some thousand terms when they are multiplied out.
"""

from __future__ import annotations

from collections.abc import Set

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, Point, Surface, UnsupportedError
from lagrange.core.symbols import Slots


def is_affine(function: sp.Expr, slots: Slots) -> bool:
    """Whether a function is written as one that is affine in the velocities, or can be by multiplying out."""
    moving = frozenset(slots.velocities)
    written = _AsPolynomial(moving)
    polynomial = written.of(function)
    if written.degree(polynomial) <= 1 and not written.others:
        return True
    unknowns = [*sorted(moving & polynomial.free_symbols, key=str), *written.others.values()]

    def affine(point: Point) -> bool:
        row = point.affine([polynomial], unknowns)
        return row is not None and all(map(point.arithmetic.vanishes, row[0][len(unknowns) - len(written.others) : -1]))

    try:
        return all(Surface().sampled(affine))
    except (UnsupportedError, DivisionByZeroError, NoPointError):
        return False


class _AsPolynomial:
    """Functions as polynomials in the velocities and in `others`: whatever depends on velocities in another way."""

    def __init__(self, moving: Set[sp.Symbol]) -> None:
        self._moving = moving
        self.others: dict[sp.Expr, sp.Symbol] = {}
        self._known: dict[sp.Expr, sp.Expr] = {}
        self._degrees: dict[sp.Expr, float] = {}

    def of(self, e: sp.Expr) -> sp.Expr:
        """The polynomial; each distinct part is worked out once."""
        if e not in self._known:
            self._known[e] = self._written(e)
        return self._known[e]

    def _written(self, e: sp.Expr) -> sp.Expr:
        if not e.args or e.free_symbols.isdisjoint(self._moving):
            return e
        if e.is_Add or e.is_Mul:
            return e.func(*map(self.of, e.args))
        if e.is_Pow and e.exp.is_Integer and e.exp.is_positive:
            return self.of(e.base) ** e.exp
        return self.others.setdefault(e, sp.Dummy(real=True))

    def degree(self, e: sp.Expr) -> float:
        """An upper bound of the degree of a polynomial in the velocities."""
        if e not in self._degrees:
            self._degrees[e] = self._bound(e)
        return self._degrees[e]

    def _bound(self, e: sp.Expr) -> float:
        if e in self._moving:
            return 1
        if e.is_Add:
            return max(map(self.degree, e.args))
        if e.is_Mul:
            return sum(map(self.degree, e.args))
        return self.degree(e.base) * float(e.exp) if e.is_Pow and e.exp.is_Integer and e.exp.is_positive else 0
