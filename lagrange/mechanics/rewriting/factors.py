"""Common factors in front of a sum: m l (l θ'' + g sin θ), H = J ω; constant ones are dropped in equations to zero."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Sign
from lagrange.core.vectors import Vector


def in_factors(e: sp.Expr) -> sp.Expr:
    """The shorter of the expression and its factors."""
    return min(e, sp.factor(e), key=lambda form: count_operations(form))


def with_common_factor(e: sp.Expr) -> sp.Expr:
    """The expression with what all its terms share in front."""
    return sp.factor_terms(e)


def with_factors_in_fraction(e: sp.Expr) -> sp.Expr:
    """A quotient of two sums with what the terms of each share in front, where that is shorter; no roots."""
    above, below = sp.fraction(e)
    if not above.is_Add or not below.is_Add or not e.is_rational_function():
        return e
    factored = sp.factor_terms(above) / sp.factor_terms(below)
    return factored if count_operations(factored) < count_operations(e) else e


def has_common_factor(e: sp.Expr) -> bool:
    """Whether all terms share a factor."""
    return bool(sp.factor_terms(e).is_Mul)


def with_factor(e: sp.Expr, factor: sp.Expr) -> sp.Expr:
    """The expression with this factor in front of the terms divided by it."""
    return factor * sp.expand(e / factor)


def vector_with_factor(v: Vector, factor: sp.Expr) -> sp.Expr:
    """The common factor of a vector, as of a sum of its components."""
    return factor * v.map(lambda c: sp.expand(c / factor)).as_sum()


def in_factors_where(e: sp.Expr, values: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    """The factors of an expression with these values substituted."""
    return sp.factor(e.xreplace(dict(values)))


def without_constant_factors(e: sp.Expr, moving: Collection[sp.Symbol]) -> sp.Expr:
    """The expression without the factors that are constants and differ from zero, multiplied out if there are any."""
    factors = sp.Mul.make_args(sp.factor_terms(e))
    kept = [f for f in factors if f.free_symbols & {*moving} or not f.is_nonzero]
    return sp.expand(sp.Mul(*kept)) if len(kept) < len(factors) else e


def without_shared_constant(coefficients: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """The coefficients of a form that vanishes, without positive constants that all share, the first one not negative.

    −l sin ψ dx − l² cos²ψ dψ = 0 says sin ψ dx + l cos²ψ dψ = 0.
    """
    powers = [_positive_powers(c) for c in coefficients if c != 0]
    if not powers:
        return tuple(coefficients)
    shared = sp.Mul(*(s ** min(p.get(s, 0) for p in powers) for s in powers[0] if all(p.get(s, 0) > 0 for p in powers)))
    first = next(c for c in coefficients if c != 0)
    sign = -1 if first.could_extract_minus_sign() else 1
    if shared == 1 and (sign == 1 or not all(c.could_extract_minus_sign() for c in coefficients if c != 0)):
        return tuple(coefficients)
    return tuple(sp.S.Zero if c == 0 else sp.factor_terms(c) / (sign * shared) for c in coefficients)


def _positive_powers(e: sp.Expr) -> dict[sp.Symbol, int]:
    """The exponents of the positive symbols among the factors."""
    pairs = (f.as_base_exp() for f in sp.Mul.make_args(sp.factor_terms(e)))
    return {b: int(n) for b, n in pairs if b.is_Symbol and b.is_positive and n.is_Integer}


def letter_for(value: sp.Expr, name: str) -> sp.Symbol:
    """A symbol that abbreviates a value, declared positive if the value is known to be."""
    return sp.Symbol(name, positive=True) if sp.expand(value).is_positive else sp.Symbol(name, real=True)


def has_one_sign(value: sp.Expr) -> bool:
    """Whether the value is positive wherever it is defined, or negative."""
    from lagrange.algebra.closed_forms.signs import sign_of

    return sign_of(value) in (1, -1)


SIGN_OF_ROOT = Sign("sigma_1")
"""That of a square root, ±1."""


def both_roots(roots: Sequence[sp.Expr]) -> sp.Expr | None:
    """Two conjugate roots (a − √b)/c and (a + √b)/c as (a + σ √b)/c; None if they are not such."""
    if len(roots) != 2:
        return None
    middle, half = sp.factor((roots[0] + roots[1]) / 2), sp.factor_terms((roots[1] - roots[0]) / 2)
    surds = [f for f in half.atoms(sp.Pow) if f.exp == sp.S.Half]
    if middle.has(*surds) or len(surds) != 1:
        return None
    return sp.factor_terms(sp.together(middle + SIGN_OF_ROOT * half))


def with_like_terms(e: sp.Expr, letters: Collection[sp.Expr]) -> sp.Expr:
    """Sums with (M + m) g for M g + m g: terms that differ in one of these letters only."""
    if e.is_Atom:
        return e
    inner = [with_like_terms(a, letters) if isinstance(a, sp.Expr) else a for a in e.args]
    if any(a is not b for a, b in zip(inner, e.args, strict=True)):
        e = e.func(*inner)
    if not e.is_Add:
        return e
    groups: dict[sp.Expr, list[sp.Expr]] = {}
    for term in e.args:
        own = [f for f in sp.Mul.make_args(term) if f in letters]
        for letter in own:
            groups.setdefault(term / letter, []).append(letter)
    rest, shared = next(((r, s) for r, s in groups.items() if len(s) > 1 and not r.is_number), (None, []))
    if rest is None:
        return e
    others = [a for a in e.args if a not in {rest * s for s in shared}]
    return with_like_terms(sp.Add(sp.Mul(rest, sp.Add(*shared)), *others), letters)


def with_terms_added(e: sp.Expr) -> sp.Expr:
    """A x + 2 A y for A (x + y) + A y: products of sums multiplied out where their terms are those of others."""
    parts = sp.Add.make_args(e)
    terms = [sp.Add.make_args(sp.expand_mul(p)) for p in parts]
    known = [{x.as_coeff_Mul()[1] for x in group} for group in terms]
    meeting = [any(m != n and keys & others for m, others in enumerate(known)) for n, keys in enumerate(known)]
    if not any(meeting):
        return e
    added = sp.Add(*(x for group, met in zip(terms, meeting, strict=True) if met for x in group))
    shown = sp.Add(added, *(p for p, met in zip(parts, meeting, strict=True) if not met))
    return shown if count_operations(shown) <= count_operations(e) else e


def in_cotangents(e: sp.Expr) -> sp.Expr:
    """The expression with cot θ for cos θ/sin θ, where no other power of either is in the product."""
    if not e.has(sp.cos) or not e.has(sp.sin):
        return e

    def product(p: sp.Expr) -> sp.Expr:
        factors = list(p.args)
        for f in p.args:
            if isinstance(f, sp.cos) and 1 / sp.sin(f.args[0]) in factors:
                factors = [g for g in factors if g not in (f, 1 / sp.sin(f.args[0]))] + [sp.cot(f.args[0])]
        return sp.Mul(*factors, evaluate=False) if len(factors) < len(p.args) else p

    return e.replace(lambda x: x.is_Mul and not isinstance(x, sp.MatrixExpr), product)


def with_signs(e: sp.Expr) -> tuple[sp.Expr, tuple[sp.Expr, ...]]:
    """sgn x for |x|/x, and the x: they must not vanish."""
    if not e.is_Mul or not e.has(sp.Abs):
        return e, ()
    factors, signs = list(e.args), list[sp.Expr]()
    for f in e.args:
        if isinstance(f, sp.Abs) and 1 / f.args[0] in factors:
            factors = [g for g in factors if g not in (f, 1 / f.args[0])]
            signs.append(f.args[0])
    return (sp.Mul(*factors, *map(sp.sign, signs), evaluate=False), tuple(signs)) if signs else (e, ())


def with_turned_sum(e: sp.Expr) -> sp.Expr:
    """Products without a minus sign in front where a sum or the angle of a sine takes it: W (R − h) for −W (h − R).

    The first sum with as many negative terms as others is turned; of several products only if all have the sign. A
    denominator with more negative terms gives up its sign: −1/(a + b − c) for 1/(c − a − b). Nothing is multiplied out.
    """
    if e.is_Add:
        if not all(a.as_coeff_Mul()[0].is_negative for a in e.args):
            return e
        terms = [with_turned_sum(a) for a in e.args]
        return sp.Add(*terms, evaluate=False) if any(a is not b for a, b in zip(terms, e.args, strict=True)) else e
    if not e.is_Mul or isinstance(e, sp.MatrixExpr):
        return e
    number, rest = e.as_coeff_Mul()
    factors = sp.Mul.make_args(rest)
    if not number.is_negative:
        for n, f in enumerate(factors):
            base, exponent = f.as_base_exp()
            if base.is_Add and exponent.is_negative and exponent.is_odd and 2 * _negative(base) > len(base.args):
                below = sp.Pow(sp.Add(*(-a for a in base.args)), exponent)
                return sp.Mul(-number, *factors[:n], below, *factors[n + 1 :], evaluate=False)
        return e
    for n, f in enumerate(factors):
        turned = _turned(f)
        if turned is not None:
            size = () if number == -1 else (-number,)
            return sp.Mul(*size, *factors[:n], turned, *factors[n + 1 :], evaluate=False)
    return e


def _turned(f: sp.Expr) -> sp.Expr | None:
    """−f as one factor, where that has no more minus signs than f."""
    base, exponent = f.as_base_exp()
    if not exponent.is_Integer or exponent % 2 == 0:
        return None
    if isinstance(base, sp.sin) and base.args[0].is_Add and 2 * _negative(base.args[0]) >= len(base.args[0].args):
        return sp.Pow(sp.sin(-base.args[0], evaluate=False), exponent)
    if base.is_Add and 2 * _negative(base) >= len(base.args):
        return sp.Pow(sp.Add(*(-a for a in base.args)), exponent)
    return None


def _negative(e: sp.Expr) -> int:
    """How many of the terms begin with a minus sign."""
    return sum(a.could_extract_minus_sign() for a in e.args)
