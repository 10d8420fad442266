"""Motions q'' = A(t) + B(t) q', as of a rocket, whose mass is a function of time.

The equation is linear in the speed v = q'. With the integrating factor μ = exp(−∫ B dt), μ(0) = 1,

    v = (v_0 + ∫_0^t μ A dt)/μ ,     q = q_0 + ∫_0^t v dt .

The antiderivatives come from the table, with real logarithms of what is positive at t = 0: log X(t) is written as
log (X(0)/X(t)) or its opposite, so that a rocket has v = u log (m_0/m) − g t. They hold until X vanishes.
"""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.forms.antiderivatives import antiderivative
from lagrange.core.symbols import prime, t
from lagrange.mechanics.questions.limits import LONGEST_INTEGRATED

ZERO = sp.S.Zero


def of_rates_in_time(q: sp.Symbol, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> sp.Expr | None:
    """q(t) for q'' = a, from q_0 and q'_0; None where a is not of this kind, or an integral is not in the table."""
    v = prime(q)
    if t not in a.free_symbols or q in a.free_symbols or not a.is_polynomial(v) or sp.degree(a, v) > 1:
        return None
    factor = a.diff(v)
    source = a.xreplace({v: ZERO})
    integral = _since_start(-factor)
    if integral is None:
        return None
    mu = sp.powsimp(sp.exp(integral))
    driven = _since_start(sp.powsimp(mu * source) if mu != 1 else source)
    if driven is None:
        return None
    way = _since_start(sp.cancel((speed + driven) / mu) if mu.is_rational_function(t) else (speed + driven) / mu)
    return None if way is None else place + way


def _since_start(e: sp.Expr) -> sp.Expr | None:
    """∫_0^t e dt; None where it is not in the table, or a logarithm is not real at t = 0."""
    if e == 0:
        return ZERO
    prepared = sp.apart(sp.cancel(e), t) if e.is_rational_function(t) else sp.expand(e, log=False, power_exp=False)
    if prepared.count_ops() > LONGEST_INTEGRATED:
        return None
    found = antiderivative(prepared, t)
    if found is None:
        return None
    found = found.replace(sp.Abs, lambda x: x)
    logarithms = [x for x in found.atoms(sp.log) if t in x.free_symbols]
    now, then = found, found.xreplace({t: ZERO})
    for x in logarithms:
        inside, start = x.args[0], x.args[0].xreplace({t: ZERO})
        sign = sign_of(start)
        if sign not in (1, -1):
            return None
        constant = sp.Dummy("c", real=True)
        ratio = sp.factor(start / inside)
        now = now.xreplace({x: constant - sp.log(ratio)})
        then = then.xreplace({x.xreplace({t: ZERO}): constant})
        difference = sp.expand(now - then, log=False, power_exp=False)
        if sp.cancel(difference.coeff(constant, 1)) != 0:
            return None
        now, then = difference.coeff(constant, 0), ZERO
    return sp.expand(now - then, log=False, power_exp=False)
