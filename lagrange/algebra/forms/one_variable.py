"""Integrating factors μ(s) of one variable, or of one simple combination s of two.

With d(log μ) = h ds the condition d(μω) = 0 determines h from any pair of coefficients,

    h = (∂_j a_i - ∂_i a_j) / (s_i a_j - s_j a_i),

and μ = exp ∫ h ds is one if h depends on s alone. The combinations are x + y, x - y, x y, x/y and x² + y². A factor
of other functions may stand beside: μ = Π g_k^{e_k} · exp ∫ h ds, with exponents that are known already (Bernoulli's
equation: a power of x times a function of t).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, is_zero
from lagrange.algebra.forms.factor_candidates import factored, is_small
from lagrange.algebra.forms.one_forms import OneForm
from lagrange.algebra.forms.potentials import at_some_value, primitive
from lagrange.algebra.fourier.textbook import textbook_form

MOST_VARIABLES = 3
LARGEST = 200

Combination = tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]


def factor_beside(omega: OneForm, known: sp.Expr, direction: int) -> sp.Expr | None:
    """μ = g exp ∫ h dv for a known g and the variable number `direction`, or None."""
    v = omega.variables[direction]
    inner = OneForm(omega.times(known), omega.variables, omega.slots)
    others = [j for j in range(omega.size) if j != direction and inner.coefficients[j] != 0]
    if not others:
        return None
    j = min(others, key=lambda k: sp.count_ops(inner.coefficients[k]))
    h: sp.Expr | None = shortened(-inner.curl(direction, j) / inner.coefficients[j])
    for other in omega.variables:
        if h is not None and other != v:
            h = at_some_value(h, other) if other in h.free_symbols else h
    phi = None if h is None or sp.count_ops(h) > LARGEST else primitive([h], [v], omega.slots)
    return None if phi is None else known * exponential(phi)


def factors_of_combinations(omega: OneForm) -> Iterator[sp.Expr]:
    """Factors of x + y, x - y, x y, x/y, x² + y² for two of at most three variables."""
    if omega.size > MOST_VARIABLES:
        return
    s = sp.Dummy("s", real=True)
    for i, j in combinations(range(omega.size), 2):
        for combined, solved in _combinations(omega.variables[i], omega.variables[j], s):
            found = _of_combination(omega, i, j, combined, solved, s)
            if found is not None:
                yield found


def _combinations(p: sp.Symbol, q: sp.Symbol, s: sp.Symbol) -> Iterator[Combination]:
    """s, and p in terms of s and q."""
    yield p + q, {p: s - q}
    yield p - q, {p: s + q}
    yield p * q, {p: s / q}
    yield p / q, {p: s * q}
    yield p**2 + q**2, {p: sp.sqrt(s - q**2)}


def _of_combination(
    omega: OneForm, i: int, j: int, combined: sp.Expr, solved: dict[sp.Symbol, sp.Expr], s: sp.Symbol
) -> sp.Expr | None:
    a, b = omega.coefficients[i], omega.coefficients[j]
    across = shortened(omega.rate(combined, i) * b - omega.rate(combined, j) * a)
    if _vanishes(across):
        return None
    h = shortened(-omega.curl(i, j) / across)
    if not _vanishes(omega.rate(h, i) * omega.rate(combined, j) - omega.rate(h, j) * omega.rate(combined, i)):
        return None
    there: sp.Expr | None = h.xreplace(solved)
    for v in omega.variables:
        there = None if there is None else at_some_value(there, v) if v in there.free_symbols else there
    if there is None or sp.count_ops(there) > LARGEST:
        return None
    phi = primitive([shortened(there)], [s], omega.slots)
    return None if phi is None else exponential(phi).xreplace({s: combined})


def _vanishes(e: sp.Expr) -> bool:
    """Whether an expression is zero, or divides by zero."""
    try:
        return is_zero(e) is True
    except DivisionByZeroError:
        return True


def exponential(phi: sp.Expr) -> sp.Expr:
    """e^φ, with its logarithms as powers and without bars."""
    powers, rest = [], []
    for term in sp.Add.make_args(sp.expand(phi) if is_small(phi) else phi):
        logs = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.log)]
        if len(logs) == 1:
            g = logs[0].args[0]
            g = g.args[0] if isinstance(g, sp.Abs) else g
            powers.append(g ** (term / logs[0]))
        else:
            rest.append(term)
    return sp.Mul(*powers) * sp.exp(sp.Add(*rest))


def shortened(e: sp.Expr) -> sp.Expr:
    """The shortest of some equal forms: as it is, cancelled, in factors, sines and cosines put together."""
    forms = [e]
    if is_small(e):
        forms.append(factored(e))
        if e.has(sp.sin, sp.cos, sp.tan):
            forms += [textbook_form(sp.cancel(e)), factored(textbook_form(sp.cancel(e)))]
        if e.has(sp.exp) or any(not p.exp.is_Integer for p in e.atoms(sp.Pow)):
            forms += [sp.powsimp(f) for f in forms]
    return min(forms, key=sp.count_ops)


def shortest(expressions: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """Each of several expressions in its shortest form."""
    return tuple(shortened(e) for e in expressions)
