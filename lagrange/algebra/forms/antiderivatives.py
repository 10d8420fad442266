"""Antiderivatives from a table: ∫ e dv for the coefficients that constraints have.

Term by term: powers, sines and cosines of linear arguments with polynomials and exponentials before them,
rational functions with denominators of degree two, roots of a quadratic; by substitution, ∫ h(u) u' dv = ∫
h(u) du; by parts, for logarithms and angles; and an undefined function's own derivatives, c ∂f/∂X = d(c
f)/dv - ....

Every rule is applied to something smaller, at most `DEPTH` deep, and nothing larger than `LARGEST`
operations is expanded, so that the work is bounded. None means that the table does not have it, not that it
does not exist. The constant of integration is 0, ∫ dv/v = log|v|, and conditions on parameters (ω ≠ 0) are
those of the formula.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import comb, prod

import sympy as sp
from sympy.polys.polyerrors import BasePolynomialError

from lagrange.algebra.forms.quadratics import logarithm, of_root, over_quadratic
from lagrange.algebra.forms.waves import of_waves
from lagrange.core.symbols import Unspecified

DEPTH = 5
LARGEST = 200
TERMS = 500


def antiderivative(e: sp.Expr, v: sp.Symbol, depth: int = DEPTH) -> sp.Expr | None:
    """∫ e dv, or None."""
    if v not in e.free_symbols:
        return e * v
    if depth <= 0 or sp.count_ops(e) > LARGEST:
        return None
    e = e.replace(lambda f: isinstance(f, _RATIOS), _in_sine_and_cosine)
    found = _by_terms(e, v, depth)
    if found is None:
        expanded = multiplied_out(e)
        if expanded != e:
            found = _by_terms(expanded, v, depth)
        if found is None and expanded.has(Unspecified):
            found = _through_undefined(expanded, v, depth)
        if found is None and expanded.has(sp.sinh, sp.cosh):
            found = antiderivative(multiplied_out(expanded.rewrite(sp.exp)), v, depth - 1)
    return found


def _by_terms(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    parts = []
    for term in sp.Add.make_args(e):
        constant, varying = term.as_independent(v, as_Add=False)
        part = _of_product(varying, v, depth) if v in varying.free_symbols else varying * v
        if part is None:
            return None
        whole = constant * part
        parts.append(sp.expand_mul(whole) if sp.fraction(constant)[1].free_symbols else whole)
    return sp.Add(*parts)


def _of_product(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    """∫ of a product without constant factors."""
    for rule in _RULES:
        found = rule(e, v, depth - 1)
        if found is not None:
            return found
    return None


def _from_table(e: sp.Expr, v: sp.Symbol, _: int) -> sp.Expr | None:
    """Powers and functions of v itself; of linear arguments through the substitution."""
    power, exponent = e.as_base_exp()
    if power == v and v not in exponent.free_symbols:
        return logarithm(v) if exponent == -1 else v ** (exponent + 1) / (exponent + 1)
    if exponent == -2 and power in (sp.cos(v), sp.sin(v)):
        return sp.tan(v) if power == sp.cos(v) else -sp.cot(v)
    if exponent == -2 and power == sp.cosh(v):
        return sp.tanh(v)
    if exponent == -1 and power in (sp.cos(v), sp.sin(v)):
        ratio = (1 + sp.sin(v)) / sp.cos(v) if power == sp.cos(v) else (1 - sp.cos(v)) / sp.sin(v)
        return logarithm(ratio)
    if exponent == -1 and power in (1 + sp.cos(v), 1 - sp.cos(v)):
        return sp.sin(v) / power if power == 1 + sp.cos(v) else -sp.sin(v) / power
    if exponent == -1 and power in (1 + sp.sin(v), 1 - sp.sin(v)):
        return -sp.cos(v) / power if power == 1 + sp.sin(v) else sp.cos(v) / power
    if e == sp.Abs(v):
        return v * sp.Abs(v) / 2
    if e == sp.sign(v):
        return sp.Abs(v)
    table = {
        sp.sin: -sp.cos(v),
        sp.cos: sp.sin(v),
        sp.exp: sp.exp(v),
        sp.sinh: sp.cosh(v),
        sp.cosh: sp.sinh(v),
    }
    return table.get(e.func) if e.args == (v,) else None


def _by_substitution(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    """∫ h(u) u' dv; where u = αv + β is under a root, v = (u - β)/α elsewhere."""
    w = sp.Dummy("w", real=True)
    for u in _inner(e, v):
        rate = sp.diff(u, v)
        if rate == 0:
            continue
        h = (sp.factor_terms(e) / sp.factor_terms(rate)).xreplace({u: w})
        if v not in rate.free_symbols and any(p.base == u and not p.exp.is_Integer for p in e.atoms(sp.Pow)):
            h = h.xreplace({v: (w - (u - rate * v).expand()) / rate})
        if v not in h.free_symbols:
            found = antiderivative(h, w, depth)
            if found is not None:
                return found.xreplace({w: u}).replace(_is_log_of_size, lambda e: logarithm(e.args[0].args[0]))
    return None


def _is_log_of_size(e: sp.Expr) -> bool:
    return isinstance(e, sp.log) and isinstance(e.args[0], sp.Abs)


def _inner(e: sp.Expr, v: sp.Symbol) -> list[sp.Expr]:
    """What could be substituted: arguments, bases, functions, functions whose derivatives occur."""
    found: set[sp.Expr] = set()
    for f in sp.preorder_traversal(e):
        if isinstance(f, Unspecified):
            found.update(lowered for lowered, _ in _lowered(f, v))
        elif isinstance(f, sp.Function):
            found.update((f, *f.args))
        elif isinstance(f, sp.Pow):
            found.add(f.base)
    usable = [u for u in found if u != v and v in u.free_symbols]
    return sorted(usable, key=lambda u: (sp.count_ops(u), sp.default_sort_key(u)))[:12]


def _of_rational(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    if not e.is_rational_function(v) or not _is_small(e):
        return None
    numerator, denominator = sp.fraction(sp.together(e))
    if not (numerator.is_polynomial(v) and denominator.is_polynomial(v)):
        return None
    top, bottom = sp.Poly(numerator, v), sp.Poly(denominator, v)
    if max(top.degree(), bottom.degree()) > 6 or bottom.degree() == 0:
        return None
    try:
        if bottom.degree() == 2 and top.degree() < 2 and bottom.is_irreducible:
            return over_quadratic(top, bottom, v)
        pieces = sp.apart(e, v)
    except BasePolynomialError:  # coefficients that SymPy does not factor
        return None
    return _by_terms(pieces, v, depth) if pieces.is_Add else None


def _of_sine_over_cosine(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    """∫ sin^m cos^n of one angle, m ≥ 2, n < 0 (or the other way round): sin² = 1 - cos² above."""
    powers = e.as_powers_dict()
    for f, m in powers.items():
        if isinstance(f, sp.sin | sp.cos) and m.is_Integer and m >= 2:
            other = (sp.cos if isinstance(f, sp.sin) else sp.sin)(f.args[0])
            if powers.get(other, sp.S.Zero).is_negative:
                return antiderivative(multiplied_out(e / f**2 * (1 - other**2)), v, depth)
    return None


def _by_parts(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    """∫ p' L dv = p L - ∫ p L' dv, for a logarithm or an angle L, one of at most two."""
    candidates = [f for f in sp.Mul.make_args(e) if isinstance(f, sp.log | sp.atan | sp.asin | sp.acos | sp.atan2)]
    if len(candidates) <= 2:
        for factor in candidates:
            p = antiderivative(e / factor, v, depth)
            moved = None if p is None else p * sp.diff(factor, v)
            rest = antiderivative(sp.cancel(moved), v, depth) if moved is not None and _is_small(moved) else None
            if p is not None and rest is not None:
                return p * factor - rest
    return None


def _through_undefined(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    """Terms c ∂f/∂X are traded for d(c f)/dv; what is left must be in the table."""
    found = sp.S.Zero
    for _ in range(20):
        trade = next(_trades(e, v), None)
        if trade is None:
            break
        found += trade
        e = multiplied_out(e - sp.diff(trade, v))
        if sp.count_ops(e) > LARGEST:
            return None
    rest = _by_terms(e, v, depth)
    return None if rest is None else found + rest


def _trades(e: sp.Expr, v: sp.Symbol) -> Iterator[sp.Expr]:
    """Functions c f with a term of e in their derivative, of the highest derivatives first."""
    terms = [(f, term) for term in sp.Add.make_args(e) for f in sp.Mul.make_args(term) if isinstance(f, Unspecified)]
    for f, term in sorted(terms, key=lambda pair: -sum(pair[0].orders)):
        for lowered, rate in _lowered(f, v):
            yield term / f / rate * lowered


def _lowered(f: Unspecified, v: sp.Symbol) -> Iterator[tuple[Unspecified, sp.Expr]]:
    """The functions F with ∂F/∂X_k = f, and ∂X_k/∂v, where that is not 0."""
    for k, (order, argument) in enumerate(zip(f.orders, f.arguments, strict=True)):
        rate = sp.diff(argument, v)
        if order and rate != 0:
            orders = [n - (j == k) for j, n in enumerate(f.orders)]
            yield f.func(f.args[0], f.args[1], sp.Tuple(*orders), *f.arguments), rate


def multiplied_out(e: sp.Expr) -> sp.Expr:
    """The expression expanded, unless it would become too large."""
    return sp.expand(e) if _terms(e) <= TERMS else e


def _is_small(e: sp.Expr) -> bool:
    return bool(sp.count_ops(e) <= LARGEST // 4) and _terms(e) <= TERMS


def _terms(e: sp.Expr) -> int:
    """How many terms an expression has, at most, when it is multiplied out."""
    if e.is_Add:
        return sum(_terms(a) for a in e.args)
    if e.is_Mul:
        return prod(_terms(a) for a in e.args)
    if e.is_Pow and e.exp.is_Integer:
        n, k = _terms(e.base), abs(int(e.exp))
        return comb(n + k - 1, k) if k < LARGEST else n
    return max((_terms(a) for a in e.args if isinstance(a, sp.Expr)), default=1)


_RATIOS = (sp.tan, sp.cot, sp.sec, sp.csc, sp.tanh)


def _in_sine_and_cosine(e: sp.Expr) -> sp.Expr:
    (a,) = e.args
    match e:
        case sp.tan():
            return sp.sin(a) / sp.cos(a)
        case sp.cot():
            return sp.cos(a) / sp.sin(a)
        case sp.sec():
            return 1 / sp.cos(a)
        case sp.csc():
            return 1 / sp.sin(a)
        case _:
            return sp.sinh(a) / sp.cosh(a)


def _of_waves(e: sp.Expr, v: sp.Symbol, _: int) -> sp.Expr | None:
    return of_waves(e, v)


def _of_root(e: sp.Expr, v: sp.Symbol, _: int) -> sp.Expr | None:
    return of_root(e, v)


_RULES = (
    _from_table,
    _by_substitution,
    _of_waves,
    _of_rational,
    _by_parts,
    _of_sine_over_cosine,
    _of_root,
)
