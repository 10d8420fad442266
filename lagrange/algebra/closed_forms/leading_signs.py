"""Signs as a book writes them: 2 μ/(1 − μ ν), and not −2 μ/(μ ν − 1)."""

from __future__ import annotations

import sympy as sp


def without_leading_minus(e: sp.Expr) -> sp.Expr:
    """A product with a minus sign before it and a sum in it, without the sign: (R − h)/R for −(h − R)/R."""
    if e.is_Add:
        return sp.Add(*(without_leading_minus(a) for a in e.args))
    if not e.is_Mul:
        return e
    factors = [_turned(f) for f in e.args]
    if not e.could_extract_minus_sign():
        return sp.Mul(*factors)
    for n, f in enumerate(factors):
        base, exponent = f.as_base_exp()
        if base.is_Add and exponent.is_Integer and exponent % 2 and _negative(base) >= _negative(-base):
            rest = [*factors[:n], *factors[n + 1 :]]
            return sp.Mul(sp.S.NegativeOne, *rest) * sp.Pow(sp.Add(*(-a for a in base.args)), exponent)
    return sp.Mul(*factors)


def _negative(e: sp.Expr) -> int:
    return sum(a.could_extract_minus_sign() for a in sp.Add.make_args(sp.expand_mul(e)))


def _turned(f: sp.Expr) -> sp.Expr:
    base, exponent = f.as_base_exp()
    if base.is_Mul and exponent.is_Rational:
        return sp.Pow(without_leading_minus(base), exponent)
    return f


def with_whole_contents(e: sp.Expr) -> sp.Expr:
    """A product with the common numbers of its sums before it: 4 a (1 − M/m) for 2 a (2 − 2 M/m)."""
    number, factors = sp.S.One, []
    for f in sp.Mul.make_args(e):
        base, exponent = f.as_base_exp()
        if base.is_Add and exponent.is_Integer:
            content, rest = base.primitive()
            if content.is_Integer:  # not that of decimals, 0.3 x + 9.81
                number, f = number * content**exponent, rest**exponent
        factors.append(f)
    return e if number == 1 or len(factors) < 2 else sp.Mul(number, *factors)
