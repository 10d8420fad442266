"""Antiderivatives from a table: ∫ e dv for the coefficients that constraints have.

Term by term: powers; rational functions with quadratic denominators; roots of a quadratic; by substitution,
∫ h(u) u' dv = ∫ h(u) du; by parts, for logarithms and angles; an undefined function's own derivatives,
c ∂f/∂X = d(c f)/dv − ....
With the discriminant Δ = 4ac − b² of a v² + b v + c and s = 2av + b,

    ∫ dv/(a v² + b v + c)  = 2/√Δ · arctan(s/√Δ)  (Δ > 0),   1/√−Δ · log |(s − √−Δ)/(s + √−Δ)|  (Δ < 0),
    ∫ dv/√(a v² + b v + c) = log |s/(2√a) + √(...)|/√a  (a > 0),   arcsin(−s/√−Δ)/√−a  (a < 0),
    ∫ e^{αv} (c cos φ + s sin φ) dv = e^{αv} [(αc − βs) cos φ + (βc + αs) sin φ]/(α² + β²),   φ = βv + ... .

Where √Δ depends on other variables the angle is atan2(s, √Δ), which has the same derivative and no gap. Products of
sines and cosines are sums of waves, and a factor v^n goes by parts. Every rule leaves something smaller
(`INTEGRATION_DEPTH`, `LARGEST_INTEGRAND`), so that the work is bounded; None means not in the table, not that there is
none. The constant of integration is 0, ∫ dv/v = log|v|, and conditions on parameters (ω ≠ 0) are those of the formula.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import comb, prod

import sympy as sp
from sympy.polys.polyerrors import BasePolynomialError

from lagrange.algebra.forms.limits import (
    INTEGRATION_DEPTH,
    LARGEST_INTEGRAND,
    MOST_EXPANDED_TERMS,
    MOST_UNDEFINED,
    MOST_WAVES,
)
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Unspecified

_ROOTS = (sp.S.Half, -sp.S.Half, -sp.Rational(3, 2))


def over_quadratic(top: sp.Poly, bottom: sp.Poly, v: sp.Symbol) -> sp.Expr | None:
    """∫ (p v + q)/(a v² + b v + c) dv."""
    a, b, c = (bottom.coeff_monomial(v**k) for k in (2, 1, 0))
    p, q = (top.coeff_monomial(v**k) for k in (1, 0))
    logarithmic = p / (2 * a) * logarithm(bottom.as_expr()) if p != 0 else sp.S.Zero
    rest = sp.cancel(q - p * b / (2 * a))
    if rest == 0:
        return logarithmic
    discriminant = sp.factor(4 * a * c - b**2)
    root = _root(discriminant)
    if root is None:
        return None
    if discriminant.is_negative:
        return logarithmic + rest / root * logarithm((2 * a * v + b - root) / (2 * a * v + b + root))
    y, x = sp.fraction(sp.cancel((2 * a * v + b) / root))
    return logarithmic + sp.cancel(2 * rest / root) * _arc(y, x)


def of_root(e: sp.Expr, v: sp.Symbol) -> sp.Expr | None:
    """∫ √(a v² + b v + c) dv, ∫ dv/√(...) and ∫ dv/√(...)³."""
    radicand, exponent = e.as_base_exp()
    if exponent not in _ROOTS or not radicand.is_polynomial(v) or sp.degree(radicand, v) != 2:
        return None
    a, b, c = (sp.Poly(radicand, v).coeff_monomial(v**k) for k in (2, 1, 0))
    slope, discriminant = 2 * a * v + b, sp.expand(4 * a * c - b**2)
    if exponent == _ROOTS[2]:
        return None if discriminant == 0 else 2 * slope / (discriminant * sp.sqrt(radicand))
    if a.is_positive:
        base = logarithm(slope / (2 * sp.sqrt(a)) + sp.sqrt(radicand)) / sp.sqrt(a)
    elif a.is_negative and discriminant.is_negative:
        base = sp.asin(-slope / sp.sqrt(-discriminant)) / sp.sqrt(-a)
    elif a.is_negative:
        base = sp.atan2(-slope / (2 * sp.sqrt(-a)), sp.sqrt(radicand)) / sp.sqrt(-a)
    else:
        return None
    return base if exponent < 0 else slope * sp.sqrt(radicand) / (4 * a) + discriminant / (8 * a) * base


def logarithm(e: sp.Expr) -> sp.Expr:
    """The logarithm of |e|, without the bars where e is known not to be negative."""
    e = sp.factor_terms(e)
    return sp.log(e) if e.is_nonnegative or _is_definite(e) else sp.log(sp.Abs(e))


def _root(d: sp.Expr) -> sp.Expr | None:
    """A square root of d or of -d, of either sign, where d is known not to change sign."""
    if d.is_negative:
        return sp.sqrt(-d)
    root = sp.sqrt(d).replace(sp.Abs, lambda x: x)
    return root if d.is_positive or root.is_rational_function() else None


def _is_definite(e: sp.Expr) -> bool:
    """Whether e is a quadratic in some symbol with 4ac ≥ b² and a > 0, or like 1 + cos θ."""
    for v in e.free_symbols:
        if e.is_polynomial(v) and sp.degree(e, v) == 2:
            a, b, c = (sp.Poly(e, v).coeff_monomial(v**k) for k in (2, 1, 0))
            if a.is_positive and sp.expand(4 * a * c - b**2).is_nonnegative:
                return True
    constant, rest = e.as_independent(sp.sin, sp.cos, as_Add=True)
    waves = [term.as_coeff_Mul() for term in sp.Add.make_args(rest)]
    return bool(
        constant.is_Rational
        and all(isinstance(f, sp.sin | sp.cos) for _, f in waves)
        and constant >= sum(abs(c) for c, _ in waves)
    )


def _arc(y: sp.Expr, x: sp.Expr) -> sp.Expr:
    """An angle with tangent y/x."""
    return sp.atan(y / x) if x.is_positive else sp.atan2(y, x)


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
                if len(waves) > MOST_WAVES:
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


def antiderivative(e: sp.Expr, v: sp.Symbol, depth: int = INTEGRATION_DEPTH) -> sp.Expr | None:
    """∫ e dv, or None."""
    if v not in e.free_symbols:
        return e * v
    if depth <= 0 or count_operations(e) > LARGEST_INTEGRAND:
        return None
    # Unexpanded first: multiplying out hides u' beside h(u), and lengthens the result.
    if _repeated(e, _RATIOS) > LARGEST_INTEGRAND:
        return None
    e = e.replace(lambda f: isinstance(f, _RATIOS), in_sine_and_cosine)
    result = _by_terms(e, v, depth)
    if result is None:
        expanded = multiplied_out(e)
        if expanded != e:
            result = _by_terms(expanded, v, depth)
        if result is None and 0 < len(expanded.atoms(Unspecified)) <= MOST_UNDEFINED:
            result = _through_undefined(expanded, v, depth)
        if result is None and 0 < _repeated(expanded, _HYPERBOLIC) <= LARGEST_INTEGRAND:
            plain = expanded.replace(lambda f: isinstance(f, _HYPERBOLIC), lambda f: f.rewrite(sp.exp, deep=False))
            result = antiderivative(multiplied_out(plain), v, depth - 1)
    return result


def _by_terms(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    parts = []
    for term in sp.Add.make_args(e):
        constant, varying = term.as_independent(v, as_Add=False)
        part = _of_product(varying, v, depth) if v in varying.free_symbols else varying * v
        if part is None:
            return None
        summand = constant * part
        parts.append(sp.expand_mul(summand) if sp.fraction(constant)[1].free_symbols else summand)
    return sp.Add(*parts)


def _of_product(e: sp.Expr, v: sp.Symbol, depth: int) -> sp.Expr | None:
    """∫ of a product without constant factors."""
    for rule in _RULES:
        result = rule(e, v, depth - 1)
        if result is not None:
            return result
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
            result = antiderivative(h, w, depth)
            if result is not None:
                return result.xreplace({w: u}).replace(_is_log_of_size, lambda e: logarithm(e.args[0].args[0]))
    return None


def _is_log_of_size(e: sp.Expr) -> bool:
    return isinstance(e, sp.log) and isinstance(e.args[0], sp.Abs)


def _inner(e: sp.Expr, v: sp.Symbol) -> list[sp.Expr]:
    """Candidates for substitution: arguments, bases, functions, functions whose derivatives occur."""
    inner: set[sp.Expr] = set()
    for f in sp.preorder_traversal(e):
        if isinstance(f, Unspecified):
            inner.update(lowered for lowered, _ in _lowered(f, v))
        elif isinstance(f, sp.Function):
            inner.update((f, *f.args))
        elif isinstance(f, sp.Pow):
            inner.add(f.base)
    usable = [u for u in inner if u != v and v in u.free_symbols]
    return sorted(usable, key=lambda u: (count_operations(u), sp.default_sort_key(u)))[:12]


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
    """Terms c ∂f/∂X are replaced by d(c f)/dv; the rest must be in the table."""
    traded = sp.S.Zero
    for _ in range(20):
        trade = next(_trades(e, v), None)
        if trade is None:
            break
        traded += trade
        e = multiplied_out(e - sp.diff(trade, v))
        if count_operations(e) > LARGEST_INTEGRAND:
            return None
    rest = _by_terms(e, v, depth)
    return None if rest is None else traded + rest


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
    return sp.expand(e) if _terms(e) <= MOST_EXPANDED_TERMS else e


def _is_small(e: sp.Expr) -> bool:
    return bool(count_operations(e) <= LARGEST_INTEGRAND // 4) and _terms(e) <= MOST_EXPANDED_TERMS


def _terms(e: sp.Expr) -> int:
    """How many terms an expression has, at most, when it is multiplied out."""
    if e.is_Add:
        return sum(_terms(a) for a in e.args)
    if e.is_Mul:
        return prod(_terms(a) for a in e.args)
    if e.is_Pow and e.exp.is_Integer:
        n, k = _terms(e.base), abs(int(e.exp))
        return comb(n + k - 1, k) if k < LARGEST_INTEGRAND else n
    return max((_terms(a) for a in e.args if isinstance(a, sp.Expr)), default=1)


_RATIOS = (sp.tan, sp.cot, sp.sec, sp.csc, sp.tanh)
_HYPERBOLIC = (sp.sinh, sp.cosh)


def _repeated(e: sp.Expr, kinds: tuple[type[sp.Function], ...]) -> int:
    """How many functions of some kinds there are when each has its argument twice: 2^n − 1 of n within one another."""
    inner = sum(_repeated(a, kinds) for a in e.args)
    return 2 * inner + 1 if isinstance(e, kinds) else inner


def in_sine_and_cosine(e: sp.Expr) -> sp.Expr:
    """tan, cot, sec, csc or tanh of an argument as a quotient."""
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
