"""The motion by quadratures, where the rate of the only quasi-velocity contains the time only: u' = f(t), q' = g(u, t).

Then u = C_1 + ∫ f dt, and each coordinate whose velocity then contains the time only follows by a second integral.
Only trigonometric polynomials in t are integrated; each result is differentiated as a check.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from sympy.simplify.fu import TR8

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.operations import count_operations
from lagrange.core.symbols import free_letter, prime, t
from lagrange.document.builders import display, listed, math, prose
from lagrange.document.derivation import Block, Emphasis, Equation
from lagrange.explain.words import plural
from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm
from lagrange.problem.model import Problem

LONGEST = 40
"""The most operations of what is integrated."""


def by_quadrature(problem: Problem, form: QuasiVelocityForm | None) -> Iterator[Block]:
    """`Motion: v̇ contains the time only, so v = v₀ + ..., and from ẋ = v cos Ωt`, with the coordinates."""
    if form is None or form.equations is None or form.velocities.completing:
        return
    if len(form.velocities.definitions) != 1 or len(form.equations.expressions) != 1:
        return
    slots = problem.slots
    letter = free_letter("C", "K", "c", taken={*problem.scope.names()})
    constants = [sp.Symbol(f"{letter}_{n + 1}", real=True) for n in range(len(slots.coordinates) + 1)]
    [u], [equation] = form.velocities.definitions, form.equations.expressions
    factor = equation.diff(prime(u))
    if factor == 0:
        return
    speed = _integral(-(equation - factor * prime(u)) / factor, constants[0])
    if speed is None:
        return
    lines = [Equation((u, speed), label=f"quadrature-{u.name}")]
    for q, v in zip(slots.coordinates, slots.velocities, strict=True):
        rate = form.velocities.kinematic.get(v)
        value = None if rate is None else _integral(rate.xreplace({u: speed}), constants[len(lines)])
        lines += [Equation((q, value), label=f"quadrature-{q.name}")] if value is not None else []
    whole = plural(len(lines), "a constant ", "constants ")
    yield prose(Emphasis("Motion"), ": ", math(prime(u)), f" contains the time only. With {whole}",
                *listed(map(math, constants[: len(lines)])), ", integration gives")  # fmt: skip
    yield display(*lines)


def _integral(rate: sp.Expr, constant: sp.Symbol) -> sp.Expr | None:
    """constant + ∫ rate dt; None where the rate is no trigonometric polynomial in t."""
    rate = sp.expand(rate)
    moving = {s for s in rate.free_symbols if s != t and not s.is_positive and not s.is_real}
    if count_operations(rate) > LONGEST or moving or any(s.name.endswith("'") for s in rate.free_symbols):
        return None
    terms = []
    parts = [term.as_independent(t, as_Add=False) for term in sp.Add.make_args(rate)]
    products = sp.expand(sp.Add(*(factor * TR8(f) for factor, f in parts)))
    for term in sp.Add.make_args(products):
        factor, f = term.as_independent(t, as_Add=False)
        slope = f.args[0].diff(t) if isinstance(f, sp.sin | sp.cos) else sp.S.Zero
        if f == 1:
            terms.append(factor * t)
        elif slope != 0 and not slope.has(t):
            terms.append(factor * (-sp.cos(f.args[0]) if isinstance(f, sp.sin) else sp.sin(f.args[0])) / slope)
        else:
            return None
    value = sp.Add(constant, *terms)
    return value if is_zero(value.diff(t) - rate) is True else None
