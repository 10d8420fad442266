"""Long roots by letters: with d = √(a² + 2a l (sin θ₂ − sin θ₁) + ...) the force of a spring is c (d − a)."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.algebra.exact.zero_test import kept_surface

FACTORS = tuple(sp.Rational(n) for n in ("1", "2", "4", "8", "1/2", "1/4", "1/8"))
"""By which radicands may differ where common factors have been divided out."""


def is_root_of(value: sp.Expr, radicand: sp.Expr) -> bool:
    """Whether the square of a value is the radicand, in whatever form."""
    return kept_surface().is_zero(value**2 - radicand) is True


def roots_by_letters(e: sp.Expr, lengths: Mapping[sp.Expr, sp.Symbol]) -> sp.Expr:
    """The expression with letters for the roots of these radicands."""
    powers = [p for p in e.atoms(sp.Pow) if p.exp.is_Rational and p.base.is_Add]
    powers = [p for p in powers if p.exp.q == 2 or p.exp == -1]  # √(...), and what the force of a damper divides by
    return e.xreplace({p: new for p in powers if (new := _by_letter(p, lengths)) is not None})


def _by_letter(power: sp.Pow, lengths: Mapping[sp.Expr, sp.Symbol]) -> sp.Expr | None:
    """A power of d for the root itself, and √2 d for that of twice the radicand."""
    for radicand, letter in lengths.items():
        if power.base.free_symbols != radicand.free_symbols:
            continue
        for factor in FACTORS:
            if power.base == radicand or sp.expand(power.base - factor * radicand) == 0:
                times = sp.S.One if power.base == radicand else factor
                return sp.Pow(times, power.exp) * letter ** (2 * power.exp)
    return None
