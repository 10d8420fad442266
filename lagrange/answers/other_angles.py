"""The other angles that a stated one stands for: with the same tangent, sine or cosine.

A book that answers θ = atan(u), or θ = 53.1°, has found tan θ = u and prints the angle that is meant. Whether the
others are equilibria as well is for the comparison to say, so the equation is read a second time, as tan θ = u.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.answers.limits import SAME_ANGLE

_INVERSE: dict[type, sp.FunctionClass] = {sp.atan: sp.tan, sp.acos: sp.cos, sp.asin: sp.sin}


def widened(e: sp.Expr, wave: sp.FunctionClass | None = None) -> sp.Expr:
    """θ − atan(u) as tan θ − u; with the function f given, θ − 0.93 as f(θ) − f(0.93), where 0.93 is a principal value.

    Not so θ = 0, where sin θ = 0: the opposite position is known to be another one.
    """
    terms = sp.Add.make_args(e)
    if len(terms) != 2:
        return e
    for angle, other in (terms, terms[::-1]):
        c, inverse = other.as_coeff_Mul()
        d, theta = angle.as_coeff_Mul()
        if wave is not None and theta.is_Symbol and other.is_number:
            value = -other / d
            principal = next(inverse(wave(value)) for inverse, of in _INVERSE.items() if of is wave)
            off = sp.N(principal - value)
            is_meant = (off.is_Float and abs(off) < SAME_ANGLE) or off == 0
            return wave(theta) - wave(value) if is_meant and not (2 * value / sp.pi).is_integer else e
        function = _INVERSE.get(type(inverse))
        if theta.is_Symbol and function is not None and abs(c) == abs(d):
            return function(theta) - function(-c / d * inverse)
    return e


def widened_system(system: Sequence[tuple[sp.Expr, ...]], wave: sp.FunctionClass | None) -> list[tuple[sp.Expr, ...]]:
    """Every equation of a system `widened`."""
    return [tuple(widened(e, wave) for e in es) for es in system]


def as_waves(angles: Mapping[sp.Symbol, sp.Expr]) -> list[sp.Expr]:
    """u = α as cos u = cos α and sin u = sin α, each as an expression that is zero."""
    return [f(u) - f(angle) for u, angle in angles.items() for f in (sp.cos, sp.sin)]


def on_circle(e: sp.Expr, angles: Collection[sp.Symbol]) -> sp.Expr:
    """θ1 = θ2 as cos(θ1 − θ2) = 1, if angles occur outside sines and cosines."""
    inside = {s for f in e.atoms(*CIRCULAR) for s in f.free_symbols}
    bare = sorted((e.free_symbols & {*angles}) - inside, key=str)
    rates = [e.diff(u) for u in bare]
    if not bare or not all(r.is_Rational and r != 0 for r in rates):
        return e
    return sp.cos(sp.expand(e / rates[0])) - 1
