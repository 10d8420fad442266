"""The finite relation F = const as a person would write it.

If dF = μω, then any function of F will do as well, with another factor: d(Φ(F)) = Φ'(F) μω. So fractional and negative
powers are cleared (3 x^{1/3} y^{2/3} z: x y² z³ = const), sums of logarithms become products, an inverse function alone
is taken off, and constants are dropped.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import reduce
from math import gcd, lcm

import sympy as sp

from lagrange.algebra.forms.factor_candidates import factored
from lagrange.algebra.forms.potentials import cleared
from lagrange.core.symbols import Slots, Unspecified, base

STEPS = 4
MOST_FACTORS = 8
LARGEST_POWER = 12
_MONOTONIC = (sp.log, sp.exp, sp.atan, sp.asin, sp.sinh, sp.tanh, sp.tan, sp.asinh)


def tidy_relation(
    f: sp.Expr, variables: Sequence[sp.Symbol], slots: Slots, angles: Collection[sp.Symbol] = ()
) -> tuple[sp.Expr, sp.Expr]:
    """(F, Φ'): the relation F = Φ(f) in a simple form, and Φ' but for a constant factor.

    angles  variables that no exponential is made of: log x + ψ = const stays
    """
    moving = {*variables, *slots.prescribed}
    factor = sp.S.One
    for _ in range(STEPS):
        f = cleared(_without_constants(_shorter(f), moving), variables, slots)
        step = _freed(f) or _of_logarithms(f, moving, angles) or _of_powers(f, moving)
        if step is None:
            break
        f, rate = step
        factor *= rate
    return f, factor


def moves(e: sp.Expr, moving: Collection[sp.Symbol]) -> bool:
    """Whether an expression contains something of `moving`, a rate of it, or an undefined function."""
    return any(base(s) in moving for s in e.free_symbols) or bool(e.has(Unspecified))


def _unbarred(e: sp.Expr) -> sp.Expr:
    """g for |g|: signs do not change where nothing vanishes."""
    return e.args[0] if isinstance(e, sp.Abs) else e


def _without_constants(f: sp.Expr, moving: set[sp.Symbol]) -> sp.Expr:
    return sp.Add(*(term for term in sp.Add.make_args(f) if moves(term, moving)))


def _shorter(f: sp.Expr) -> sp.Expr:
    """The function as one fraction in factors, if that is shorter."""
    if not f.is_Add:
        return f
    product = factored(f)
    return product if product.is_Mul and sp.count_ops(product) <= sp.count_ops(f) else f


def _freed(f: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """h(g) = const, for a monotonic h alone: g = const."""
    if isinstance(f, _MONOTONIC):
        g = _unbarred(f.args[0])
        return g, 1 / f.func(g).fdiff()
    return None


def _of_logarithms(f: sp.Expr, moving: set[sp.Symbol], angles: Collection[sp.Symbol]) -> tuple[sp.Expr, sp.Expr] | None:
    """Σ c_k log g_k + Σ b_i q_i = const: Π g_k^{c_k} · exp Σ b_i q_i = const."""
    product: dict[sp.Expr, sp.Expr] = {}
    growth = sp.S.Zero
    for term in sp.Add.make_args(f):
        if _is_linear(term, moving) and not term.free_symbols & {*angles}:
            growth += term
            continue
        logs = [a for a in sp.Mul.make_args(term) if isinstance(a, sp.log)]
        if len(logs) != 1 or moves(term / logs[0], moving):
            return None
        g = _unbarred(logs[0].args[0])
        product[g] = product.get(g, sp.S.Zero) + term / logs[0]
    if not product or len(product) > MOST_FACTORS:
        return None
    scale = _clearing(list(product.values()))
    if scale is None:
        return None
    found = sp.Mul(*(g ** sp.cancel(c * scale) for g, c in product.items())) * sp.exp(sp.expand(scale * growth))
    return found, found


def _is_linear(term: sp.Expr, moving: set[sp.Symbol]) -> bool:
    """Whether a term is a constant times a coordinate."""
    constant, rest = term.as_independent(*moving, as_Add=False)
    return bool(rest in moving and not moves(constant, moving))


def _of_powers(f: sp.Expr, moving: set[sp.Symbol]) -> tuple[sp.Expr, sp.Expr] | None:
    """Π g_k^{e_k} = const with exponents that are not whole, have a common divisor, or are negative for the most."""
    powers: dict[sp.Expr, sp.Expr] = {}
    growth = sp.S.Zero
    for factor in sp.Mul.make_args(f):
        if not moves(factor, moving):
            continue
        if isinstance(factor, sp.exp):
            growth += factor.args[0]
        else:
            g, e = factor.as_base_exp()
            g = _unbarred(g)
            powers[g] = powers.get(g, sp.S.Zero) + e
    if not powers or any(moves(e, moving) for e in powers.values()) or len(powers) > MOST_FACTORS:
        return None
    scale = _clearing(list(powers.values()))
    if scale is None:
        return None
    scale = -scale if _is_upside_down(powers, growth) else scale
    if scale == 1:
        return None
    found = sp.Mul(*(g ** sp.cancel(e * scale) for g, e in powers.items())) * sp.exp(scale * growth)
    return found, found / f


def _is_upside_down(powers: dict[sp.Expr, sp.Expr], growth: sp.Expr) -> bool:
    """Whether all stands below the line, or more than above it."""
    below = [g for g, e in powers.items() if _is_negative(e)]
    above = [g for g in powers if g not in below]
    if not above:
        return True
    lengths = [sum(int(sp.count_ops(g)) + 1 for g in part) for part in (below, above)]
    return bool(growth == 0) and lengths[0] > lengths[1]


def _is_negative(e: sp.Expr) -> bool:
    return bool(e.could_extract_minus_sign())


def _clearing(exponents: Sequence[sp.Expr]) -> sp.Expr | None:
    """The number that makes all exponents whole and coprime, or polynomials in the parameters."""
    fractions = [sp.fraction(sp.together(e)) for e in exponents]
    if all(n.is_Integer and d.is_Integer for n, d in fractions):
        whole = lcm(*(int(d) for _, d in fractions))
        common = reduce(gcd, (int(n) * whole // int(d) for n, d in fractions), 0)
        largest = max((abs(int(n) * whole // int(d)) // (common or 1) for n, d in fractions), default=0)
        return sp.Rational(whole, common) if common and largest <= LARGEST_POWER else None
    denominators = [d for _, d in fractions]
    return reduce(sp.lcm, denominators, sp.S.One)
