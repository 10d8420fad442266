"""Motions q'' = A(t) + B(t) q', as of a rocket, whose mass is a function of time.

The equation is linear in the speed v = q'. With the integrating factor μ = exp(−∫ B dt), μ(0) = 1,

    v = (v_0 + ∫_0^t μ A dt)/μ ,     q = q_0 + ∫_0^t v dt .

The antiderivatives come from the table, with real logarithms of what is positive at t = 0: log X(t) is written as
log (X(t)/X(0)), so that a rocket has v = u log (m_0/m) − g t. They hold until X vanishes.

Where B = −c/X with X = X_0 + s t, as with drag beside the jet, μ is a power of R = X/X_0, and with κ = c/s

    ∫ R^p dt = X_0 (R^(p+1) − 1)/(s (p + 1)) .
"""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.closed_forms.limits import HIGHEST_RATIONAL_DEGREE
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.forms.antiderivatives import antiderivative
from lagrange.core.symbols import prime, t


def of_rates_in_time(q: sp.Symbol, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """q(t) and q'(t) for q'' = a, from q_0 and q'_0; None if a is not of this kind, or an integral not in the table."""
    v = prime(q)
    if t not in a.free_symbols or q in a.free_symbols or not a.is_polynomial(v) or sp.degree(a, v) > 1:
        return None
    factor = a.diff(v)
    source = a.xreplace({v: sp.S.Zero})
    integral = since_start(-factor)
    if integral is None:
        return None
    if (powers := _in_powers(factor, source, place, speed)) is not None:
        return powers
    mu = sp.powsimp(sp.exp(sp.logcombine(integral))) if integral != 0 else sp.S.One
    driven = since_start(mu * source)
    if driven is None:
        return None
    rate = (speed + driven) / mu
    way = since_start(rate)
    if way is None:
        return None
    return place + _with_ratios(way), sp.factor(rate) if rate.is_rational_function(t) else _with_ratios(rate)


def _in_powers(b: sp.Expr, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """q(t) and q'(t) where −B = c/X with X linear in t, κ = c/s no number, and A a sum of powers of X."""
    c, x = sp.fraction(sp.cancel(-b))
    if t in c.free_symbols or not x.is_polynomial(t) or sp.degree(x, t) != 1:
        return None
    slope, start = x.diff(t), x.xreplace({t: sp.S.Zero})
    kappa = sp.cancel(c / slope)
    if kappa.is_number or sign_of(start) not in (1, -1):
        return None
    letter = sp.Dummy("x", real=True)
    above, below = sp.fraction(sp.cancel(a.xreplace({t: (letter - start) / slope})))
    if not above.is_polynomial(letter) or len(sp.Poly(below, letter).terms()) != 1:
        return None
    [((power,), scale)] = sp.Poly(below, letter).terms()
    shares = [(n - power, share / scale) for (n,), share in sp.Poly(above, letter).terms() if share != 0]
    ratio = sp.expand(x / start)

    def power_since_start(p: sp.Expr) -> sp.Expr | None:
        """∫_0^t R^p dt; None where p + 1 may vanish."""
        higher = sp.cancel(p + 1)
        if higher == 0:
            return start / slope * sp.log(ratio)
        return sp.cancel(start / (slope * higher)) * (ratio**higher - 1) if sign_of(higher) in (1, -1) else None

    way, rate = power_since_start(-kappa), speed * ratio ** (-kappa)
    total = place if way is None else place + speed * way
    for n, share in shares:
        further, divisor = power_since_start(sp.Integer(n + 1)), sp.factor(kappa + n + 1)
        if way is None or further is None or sign_of(divisor) not in (1, -1):
            return None
        amount = sp.cancel(share * start ** (n + 1) / (slope * divisor))
        rate += amount * (ratio ** (n + 1) - ratio ** (-kappa))
        total += amount * (further - way)
    return total, rate


def since_start(e: sp.Expr) -> sp.Expr | None:
    """∫_0^t e dt; None where it is not in the table, or a logarithm is not real at t = 0."""
    if e == 0:
        return sp.S.Zero
    if e.is_rational_function(t):
        e = sp.cancel(e)
        if max(sp.degree(part, t) for part in sp.fraction(e)) > HIGHEST_RATIONAL_DEGREE:
            return None
        e = sp.apart(e, t)
    else:
        e = sp.expand(e, log=False, power_exp=False)
    integral = antiderivative(e, t)
    if integral is None:
        return None
    integral = integral.replace(sp.Abs, lambda x: x)
    rule = {}
    for x in integral.atoms(sp.log):
        sign = sign_of(x.args[0].xreplace({t: sp.S.Zero}))
        if t in x.free_symbols and sign not in (1, -1):
            return None
        rule[x] = sp.log(sp.expand(-x.args[0])) if sign == -1 else x
    integral = integral.xreplace(rule)
    return integral - integral.xreplace({t: sp.S.Zero})


def _with_ratios(e: sp.Expr) -> sp.Expr:
    """log (X(t)/X(0)), or −log (X(0)/X(t)) where X decreases, instead of log X(0) and log X(t); each once."""
    written: dict[sp.Symbol, sp.Expr] = {}
    for x in sorted((x for x in e.atoms(sp.log) if t in x.free_symbols), key=str):
        inside, start = x.args[0], sp.factor(x.args[0].xreplace({t: sp.S.Zero}))
        constant, ratio = sp.Dummy("c", real=True), sp.Dummy("R", real=True)
        grows = sign_of(inside.diff(t).xreplace({t: sp.S.Zero})) == 1
        put = sp.expand(
            e.xreplace({sp.log(x.args[0].xreplace({t: sp.S.Zero})): constant}).xreplace(
                {x: constant + (ratio if grows else -ratio)}
            )
        )
        if sp.cancel(put.diff(constant)) == 0:
            e = put.xreplace({constant: sp.S.Zero})
            written[ratio] = sp.log(inside / start if grows else start / inside)
    rest = e.xreplace(dict.fromkeys(written, sp.S.Zero))
    if rest.is_polynomial(t):
        rest = sp.Add(*(sp.factor(share) * power for power, share in sp.collect(rest, t, evaluate=False).items()))
    elif rest.is_rational_function(t):
        rest = sp.factor(rest)
    return sp.Add(rest, *(sp.factor(e.diff(r)) * log for r, log in written.items()))
