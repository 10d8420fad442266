"""Times ∫ dq/√f(q) with S = sin(c q) as variable, where f is a rational function of S and cos²(c q).

    (dS/dt)² = c² (1 − S²) f ,

of which `quadrature` knows the integral where that is a quadratic: so in the well U_0 tan²(a x), whose period is
elementary for every energy (Landau and Lifshitz, Mechanics, § 11). S increases with c q between −π/2 and π/2.
"""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.mechanics.questions.limits import LONGEST_INTEGRATED


@record
class InSine:
    """S, (dS/dt)² as a function of it, and its values at both ends."""

    letter: sp.Symbol
    square: sp.Expr
    ends: tuple[sp.Expr, sp.Expr]


def in_sine(q: sp.Symbol, square: sp.Expr, start: sp.Expr, end: sp.Expr) -> InSine | None:
    """q'² = f(q) with the sine as variable; None where it is no rational function of it, or turns between the ends."""
    rates = {f.args[0].diff(q) for f in square.atoms(sp.sin, sp.cos, sp.tan, sp.cot)}
    if len(rates) != 1 or count_operations(square) > LONGEST_INTEGRATED:
        return None
    [rate] = rates
    rising = all(sign_of(sp.cos(rate * x)) in (0, 1) for x in (start, end)) and sign_of(rate) == 1
    letter, cosine = sp.Dummy("S", real=True), sp.Dummy()
    plain = square.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)).replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))
    plain = plain.xreplace({sp.sin(rate * q): letter, sp.cos(rate * q): cosine})
    parts = sp.fraction(sp.together(plain))
    if not rising or q in plain.free_symbols or not all(p.is_polynomial(cosine) for p in parts):
        return None
    terms = [sp.Poly(p, cosine).terms() for p in parts]
    if any(n % 2 for several in terms for (n,), _ in several):
        return None
    above, below = (sp.Add(*(c * (1 - letter**2) ** (n // 2) for (n,), c in several)) for several in terms)
    changed = sp.factor(sp.together(rate**2 * (1 - letter**2) * above / below))
    return InSine(letter, changed, (sp.sin(rate * start), sp.sin(rate * end)))
