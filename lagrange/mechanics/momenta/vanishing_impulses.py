"""Where the impulse of a reaction vanishes: a hand that holds a rod is not jarred where 3 a = 2 l.

An impulse is a quotient of polynomials in the parameters. It vanishes, and where it does so to an odd power it changes
its sense, where a factor of its numerator does: a sum of terms of both signs in positive parameters. Such a place
counts only if the position that it belongs to exists, that is if the constraints remain real there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.mechanics.limits import MOST_VANISHING_TERMS


@record
class Vanishing:
    """left = right, where the impulse is zero; `turns` if it has opposite senses on the two sides."""

    left: sp.Expr
    right: sp.Expr
    turns: bool


def vanishings(value: sp.Expr, coefficients: Sequence[sp.Expr]) -> Iterator[Vanishing]:
    """The places where an impulse vanishes; `coefficients`: of the constraints in the position of the impact."""
    for factor in sp.Mul.make_args(sp.factor(sp.fraction(sp.together(value))[0])):
        base, exponent = factor.as_base_exp()
        terms = sp.Add.make_args(base)
        if len(terms) != MOST_VANISHING_TERMS or not exponent.is_Integer or not base.is_polynomial(*base.free_symbols):
            continue
        first, second = (a for a in sorted(terms, key=lambda a: a.could_extract_minus_sign()))
        if not first.is_positive or not second.is_negative or not _exists(first, -second, coefficients):
            continue
        yield Vanishing(first, -second, exponent % 2 == 1)


def _exists(left: sp.Expr, right: sp.Expr, coefficients: Sequence[sp.Expr]) -> bool:
    """Whether the constraints are real there, tried at one place."""
    symbols = sorted({s for e in (left - right, *coefficients) for s in e.free_symbols}, key=lambda s: s.name)
    for s in sorted((left - right).free_symbols, key=lambda s: s.name):
        if sp.degree(left - right, s) != 1:
            continue
        [place] = sp.solve(left - right, s)
        values = {other: sp.Rational(n + 7, 7) for n, other in enumerate(symbols) if other != s}
        at = {**values, s: place.xreplace(values)}
        return all(e.xreplace(at).is_real is not False for e in coefficients)
    return False
