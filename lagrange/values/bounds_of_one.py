"""Inequalities in one quantity that are not linear in it: A v² − B ≥ 0, A − B/tan θ ≥ 0, A sin θ − B cos θ ≥ 0.

The quantity u > 0 is the symbol itself, if that is positive, or a function of it: of an acute angle the sine, the
cosine, the tangent. Sines and cosines that occur in the same power throughout, A sin θ − B cos θ, are divided by that
of the cosine, which is positive, and leave the tangent. Multiplied by its denominator where that is a power of u, the
inequality is p(u) ≥ 0 with a polynomial p. With one simple positive root u_1 it says u ≥ u_1 or u ≤ u_1; with two,
that u lies between them or outside, of which only the former is one statement.
"""

from __future__ import annotations

import sympy as sp

from lagrange.core.records import record
from lagrange.values.limits import MOST_DEGREES
from lagrange.values.quantities import real_value


@record
class NumberRange:
    """low ≤ wanted ≤ high; None where there is no such end. Without both, the inequality holds always."""

    wanted: sp.Expr
    low: sp.Expr | None
    high: sp.Expr | None


def ends_of_one(e: sp.Expr, symbol: sp.Symbol) -> NumberRange | None:
    """e ≥ 0 with numbers for all but one symbol; None where it is no statement of this kind."""
    waves = {f.func: f for f in e.atoms(sp.sin, sp.cos, sp.tan) if f.args[0] == symbol}
    letter = sp.Dummy(positive=True)
    if not waves:
        wanted = symbol
        if not symbol.is_positive:
            return None
    elif len(waves) == 1:
        [wanted] = waves.values()
    else:
        wanted = sp.tan(symbol)
        e = _by_tangent(e.xreplace({wanted: sp.sin(symbol) / sp.cos(symbol)}), symbol)
    above, below = sp.fraction(sp.together(e.xreplace({wanted: letter})))
    if (above.free_symbols | below.free_symbols) - {letter}:
        return None
    scale, power = sp.expand(below).as_independent(letter)
    if not above.is_polynomial(letter) or not (power == letter or power == 1 or power.as_base_exp()[0] == letter):
        return None
    function = sp.Poly(sp.expand(above / scale), letter)
    if not 0 < function.degree() <= MOST_DEGREES:
        return None
    return _where_positive(function, wanted)


def _by_tangent(e: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """The expression, over a power of the cosine, in tangents only; as it is where no power does that."""
    s, c, tangent = sp.Dummy(positive=True), sp.Dummy(positive=True), sp.tan(symbol)
    above, below = sp.fraction(sp.together(e.xreplace({sp.sin(symbol): s, sp.cos(symbol): c})))
    forms = [sp.Poly(part, s, c) if part.is_polynomial(s, c) else None for part in (above, below)]
    if any(f is None or not f.is_homogeneous for f in forms):
        return e
    return (above / below).subs({s: tangent, c: 1})


def _where_positive(function: sp.Poly, wanted: sp.Expr) -> NumberRange | None:
    """Where a polynomial is not negative for a positive quantity."""
    roots = sorted(set(map(real_value, _positive_roots(function))))
    grows = real_value(function.LC()) > 0
    if not roots and grows and _is_simple(function):
        return NumberRange(wanted, None, None)
    if len(roots) == 1:
        return NumberRange(wanted, roots[0], None) if grows else NumberRange(wanted, None, roots[0])
    if len(roots) == 2 and not grows:
        return NumberRange(wanted, roots[0], roots[1])
    return None


def _positive_roots(function: sp.Poly) -> list[sp.Expr]:
    """Its positive roots; none where some root is not simple, so that the sign changes at each."""
    if not _is_simple(function):
        return []
    return [sp.re(r) for r in function.nroots(n=30) if abs(sp.im(r)) < sp.Float("1e-20") and sp.re(r) > 0]


def _is_simple(function: sp.Poly) -> bool:
    return all(count == 1 or part.total_degree() == 0 for part, count in function.sqf_list()[1])
