"""Conditions of rest as they are written: tan α ≤ μ_s, and not m g sin α − μ_s m g cos α ≤ 0.

Factors of known sign are divided out. A condition that is linear in one coefficient of friction is solved for it;
otherwise terms with a minus sign are taken to the left. If all terms have the same degree in sin θ and cos θ, they are
divided by cos θ and written in tan θ.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Signs, shortest


@record
class RestCondition:
    """left ≤ right."""

    left: sp.Expr
    right: sp.Expr


def bounded_by(
    friction: Sequence[sp.Expr], pressed: sp.Expr, coefficient: sp.Expr, signed: bool, signs: Signs
) -> list[RestCondition] | None:
    """|F| ≤ μ N, or μ |N| unless `signed`; None if it never holds."""
    sign = signs.of(pressed)
    if signed and sign == -1:
        return None
    size = friction[0] if len(friction) == 1 else sp.sqrt(shortest(sp.Add(*(f**2 for f in friction))))
    sense = signs.of(size)
    if sense == 0:
        return not_negative(pressed, (), signs) if signed else []
    size = size * sense if sense is not None else sp.Abs(size)
    if sign in (1, -1):
        return [RestCondition(_ratio(size, pressed * sign, signs), coefficient)]
    inside = size.args[0] if isinstance(size, sp.Abs) else size
    for factor in (f for f in sp.Mul.make_args(pressed) if f.is_positive):  # m g |sin θ| ≤ μ m g cos θ
        shorter = sp.cancel(inside / factor)
        if shorter.count_ops() < inside.count_ops():
            inside, pressed = sp.factor(shorter), pressed / factor
    size = sp.Abs(inside) if isinstance(size, sp.Abs) else inside
    if not signed:
        pressed = sp.Abs(pressed)
    return [RestCondition(size, coefficient * pressed)]


def _ratio(size: sp.Expr, pressed: sp.Expr, signs: Signs) -> sp.Expr:
    """|F|/N with what is positive in front of the modulus."""
    if not isinstance(size, sp.Abs):
        return _in_tangents(shortest(size / pressed))
    outside: list[sp.Expr] = []
    inside: list[sp.Expr] = []
    number, factors = shortest(size.args[0] / pressed).as_coeff_Mul()
    for factor in sp.Mul.make_args(factors):
        (outside if signs.of(factor.as_base_exp()[0]) == 1 else inside).append(factor)
    return sp.Abs(number) * sp.Mul(*outside) * sp.Abs(_in_tangents(sp.Mul(*inside)))


def not_negative(slack: sp.Expr, coefficients: Iterable[sp.Expr], signs: Signs) -> list[RestCondition]:
    """slack ≥ 0, as it is written; nothing if it always holds."""
    reduced = _without_signed_factors(shortest(slack), signs)
    if reduced is None or signs.of(reduced) in (0, 1):
        return []
    symbols = [c for c in coefficients if c.is_Symbol and c in reduced.free_symbols]
    if len(symbols) == 1:
        [mu] = symbols
        expanded = sp.expand(reduced)
        rate = expanded.coeff(mu, 1)
        rest = expanded - rate * mu
        if mu not in rest.free_symbols and signs.of(rate) in (1, -1):
            bound = _in_tangents(shortest(-rest / rate))
            return [RestCondition(bound, mu) if signs.of(rate) == 1 else RestCondition(mu, bound)]
    terms = sp.Add.make_args(_homogeneous(sp.expand(reduced), signs))
    minus = [t for t in terms if t.could_extract_minus_sign()]
    left, right = sp.Add(*(-t for t in minus)), sp.Add(*(t for t in terms if t not in minus))
    return [RestCondition(sp.factor(left), sp.factor(right))]


def _without_signed_factors(slack: sp.Expr, signs: Signs) -> sp.Expr | None:
    """The factors whose sign is not known, with the sign of the others; None if none is left and it is positive."""
    over, under = sp.fraction(slack)
    sign, kept = 1, []
    for factor, power in (*((f, 1) for f in sp.Mul.make_args(over)), *((f, -1) for f in sp.Mul.make_args(under))):
        base, exponent = factor.as_base_exp()
        if exponent.is_Integer and exponent % 2 == 0:
            continue
        known = signs.of(base)
        if known is None:
            kept.append(base**power)
        else:
            sign *= known or 1
    return _in_tangents(sp.Mul(sign, *kept)) if kept else None if sign > 0 else sp.S.NegativeOne


def _homogeneous(e: sp.Expr, signs: Signs) -> sp.Expr:
    """A sum whose terms have the same degree in sin θ and cos θ, divided by a power of cos θ > 0."""
    for angle in sorted({f.args[0] for f in e.atoms(sp.sin, sp.cos)}, key=str):
        s, c = sp.sin(angle), sp.cos(angle)
        if signs.of(c) != 1 or not e.is_polynomial(s, c):
            continue
        poly = sp.Poly(e, s, c)
        degrees = {sum(m) for m in poly.monoms()}
        if len(degrees) == 1 and degrees != {0} and len(poly.monoms()) > 1:
            x = sp.tan(angle)
            e = sp.expand(sp.Add(*(k * x ** m[0] for m, k in poly.terms())))
    return e


def _in_tangents(e: sp.Expr) -> sp.Expr:
    """sin θ/cos θ as tan θ, in each product and quotient."""
    e = e.replace(sp.Abs, lambda x: sp.Abs(_in_tangents(x)))
    for angle in sorted({f.args[0] for f in e.atoms(sp.sin, sp.cos)}, key=str):
        s, c = sp.sin(angle), sp.cos(angle)
        over, under = sp.fraction(sp.together(e))
        if not (over.is_polynomial(s, c) and under.is_polynomial(s, c)):
            continue
        top, bottom = sp.Poly(over, s, c), sp.Poly(under, s, c)
        degrees = {sum(m) for m in top.monoms()}, {sum(m) for m in bottom.monoms()}
        if len(degrees[0]) == len(degrees[1]) == 1 and degrees[0] == degrees[1] != {0}:
            x = sp.tan(angle)
            numerator = sp.Add(*(k * x ** m[0] for m, k in top.terms()))
            denominator = sp.Add(*(k * x ** m[0] for m, k in bottom.terms()))
            e = sp.factor(numerator / denominator)
    return e
