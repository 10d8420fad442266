"""Antiderivatives of polynomials times exponentials times sines and cosines of linear arguments.

A product of sines and cosines is a sum of waves, cos a cos b = (cos(a + b) + cos(a - b))/2. With φ = βv + ... ,

    ∫ e^{αv} (c cos φ + s sin φ) dv = e^{αv} [(αc - βs) cos φ + (βc + αs) sin φ] / (α² + β²),

and a power v^n in front goes by parts: n times the same formula.
"""

from __future__ import annotations

import sympy as sp

WAVES = 64

Waves = dict[tuple[sp.Expr, bool], sp.Expr]


def of_waves(e: sp.Expr, v: sp.Symbol) -> sp.Expr | None:
    """∫ v^n e^{αv + ...} Π cos(β_k v + ...) Π sin(...), the product turned into a sum of waves."""
    degree, growth, waves = 0, sp.S.Zero, {(sp.S.Zero, True): sp.S.One}
    for factor in sp.Mul.make_args(e):
        inner, exponent = factor.as_base_exp() if not isinstance(factor, sp.exp) else (factor, sp.S.One)
        if not (exponent.is_Integer and 0 < exponent <= 12):
            return None
        if inner == v:
            degree += int(exponent)
        elif isinstance(inner, sp.exp) and _slope(inner.args[0], v) is not None:
            growth += exponent * inner.args[0]
        elif isinstance(inner, sp.sin | sp.cos) and _slope(inner.args[0], v) is not None:
            for _ in range(int(exponent)):
                waves = _beats(waves, sp.expand(inner.args[0]), isinstance(inner, sp.cos))
                if len(waves) > WAVES:
                    return None
        else:
            return None
    alpha = _slope(growth, v)
    parts = (
        amplitude * _wave_integral(degree, alpha, sp.diff(phase, v), phase, even, v)
        for (phase, even), amplitude in waves.items()
    )
    return sp.exp(growth) * sp.Add(*parts)


def _beats(waves: Waves, b: sp.Expr, even: bool) -> Waves:
    """The sum of waves A cos φ (True) and A sin φ (False), times cos b or sin b."""
    result: Waves = {}
    for (a, cosine), amplitude in waves.items():
        plus, minus = (1, 1) if even else ((1, -1) if cosine else (-1, 1))
        for phase, sign in ((a + b, plus), (a - b, minus)):
            kind = cosine is even
            if phase.could_extract_minus_sign():
                phase, sign = -phase, sign if kind else -sign
            if phase != 0 or kind:
                key = (sp.expand(phase), kind)
                result[key] = result.get(key, sp.S.Zero) + sign * amplitude / 2
    return {key: amplitude for key, amplitude in result.items() if amplitude != 0}


def _wave_integral(n: int, alpha: sp.Expr, beta: sp.Expr, phase: sp.Expr, even: bool, v: sp.Symbol) -> sp.Expr:
    """e^{-αv} ∫ v^n e^{αv} cos(phase) dv (or sin), where phase = βv + ...."""
    c, s = (sp.S.One, sp.S.Zero) if even else (sp.S.Zero, sp.S.One)
    if alpha == 0 and beta == 0:
        return v ** (n + 1) / (n + 1) * (c * sp.cos(phase) + s * sp.sin(phase))
    square, factor, total = alpha**2 + beta**2, sp.S.One, sp.S.Zero
    for k in range(n, -1, -1):
        c, s = (alpha * c - beta * s) / square, (beta * c + alpha * s) / square
        total += factor * v**k * (c * sp.cos(phase) + s * sp.sin(phase))
        factor *= -k
    return sp.expand(total)


def _slope(e: sp.Expr, v: sp.Symbol) -> sp.Expr | None:
    """∂e/∂v where e is linear in v."""
    rate = sp.diff(e, v)
    return rate if v not in rate.free_symbols else None
