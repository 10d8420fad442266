"""Antiderivatives with a quadratic a v² + b v + c in the denominator or under a root.

With the discriminant Δ = 4ac - b² and s = 2av + b,

    ∫ dv/(a v² + b v + c) = 2/√Δ · arctan(s/√Δ)                  Δ > 0
                          = 1/√-Δ · log |(s - √-Δ)/(s + √-Δ)|    Δ < 0,
    ∫ dv/√(a v² + b v + c) = log |s/(2√a) + √(a v² + b v + c)| / √a     a > 0
                           = arcsin(-s/√-Δ) / √-a                       a < 0.

Where √Δ depends on other variables the angle is atan2(s, √Δ), which has the same derivative and no gap. A
quadratic whose Δ has no known sign has no antiderivative here.
"""

from __future__ import annotations

import sympy as sp

_ROOTS = (sp.S.Half, -sp.S.Half, -sp.Rational(3, 2))


def over_quadratic(top: sp.Poly, bottom: sp.Poly, v: sp.Symbol) -> sp.Expr | None:
    """∫ (p v + q)/(a v² + b v + c) dv."""
    a, b, c = (bottom.coeff_monomial(v**k) for k in (2, 1, 0))
    p, q = (top.coeff_monomial(v**k) for k in (1, 0))
    whole = p / (2 * a) * logarithm(bottom.as_expr()) if p != 0 else sp.S.Zero
    rest = sp.cancel(q - p * b / (2 * a))
    if rest == 0:
        return whole
    discriminant = sp.factor(4 * a * c - b**2)
    root = _root(discriminant)
    if root is None:
        return None
    if discriminant.is_negative:
        return whole + rest / root * logarithm((2 * a * v + b - root) / (2 * a * v + b + root))
    y, x = sp.fraction(sp.cancel((2 * a * v + b) / root))
    return whole + sp.cancel(2 * rest / root) * _arc(y, x)


def of_root(e: sp.Expr, v: sp.Symbol) -> sp.Expr | None:
    """∫ √(a v² + b v + c) dv, ∫ dv/√(...) and ∫ dv/√(...)³."""
    radicand, exponent = e.as_base_exp()
    if exponent not in _ROOTS or not radicand.is_polynomial(v) or sp.degree(radicand, v) != 2:
        return None
    a, b, c = (sp.Poly(radicand, v).coeff_monomial(v**k) for k in (2, 1, 0))
    slope, discriminant = 2 * a * v + b, sp.expand(4 * a * c - b**2)
    if exponent == _ROOTS[2]:
        return None if discriminant == 0 else 2 * slope / (discriminant * sp.sqrt(radicand))
    if a.is_positive:
        base = logarithm(slope / (2 * sp.sqrt(a)) + sp.sqrt(radicand)) / sp.sqrt(a)
    elif a.is_negative and discriminant.is_negative:
        base = sp.asin(-slope / sp.sqrt(-discriminant)) / sp.sqrt(-a)
    elif a.is_negative:
        base = sp.atan2(-slope / (2 * sp.sqrt(-a)), sp.sqrt(radicand)) / sp.sqrt(-a)
    else:
        return None
    return base if exponent < 0 else slope * sp.sqrt(radicand) / (4 * a) + discriminant / (8 * a) * base


def logarithm(e: sp.Expr) -> sp.Expr:
    """The logarithm of |e|, without the bars where e is known not to be negative."""
    e = sp.factor_terms(e)
    return sp.log(e) if e.is_nonnegative or _is_definite(e) else sp.log(sp.Abs(e))


def _root(d: sp.Expr) -> sp.Expr | None:
    """A square root of d or of -d, of either sign, where d is known not to change sign."""
    if d.is_negative:
        return sp.sqrt(-d)
    root = sp.sqrt(d).replace(sp.Abs, lambda x: x)
    return root if d.is_positive or root.is_rational_function() else None


def _is_definite(e: sp.Expr) -> bool:
    """Whether e is a quadratic in some symbol with 4ac ≥ b² and a > 0, or like 1 + cos θ."""
    for v in e.free_symbols:
        if e.is_polynomial(v) and sp.degree(e, v) == 2:
            a, b, c = (sp.Poly(e, v).coeff_monomial(v**k) for k in (2, 1, 0))
            if a.is_positive and sp.expand(4 * a * c - b**2).is_nonnegative:
                return True
    constant, rest = e.as_independent(sp.sin, sp.cos, as_Add=True)
    waves = [term.as_coeff_Mul() for term in sp.Add.make_args(rest)]
    return bool(
        constant.is_Rational
        and all(isinstance(f, sp.sin | sp.cos) for _, f in waves)
        and constant >= sum(abs(c) for c, _ in waves)
    )


def _arc(y: sp.Expr, x: sp.Expr) -> sp.Expr:
    """An angle with tangent y/x."""
    return sp.atan(y / x) if x.is_positive else sp.atan2(y, x)
