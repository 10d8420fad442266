"""Polynomials in one letter: factors, and real roots in closed form with the conditions under which they are real.

Roots are found of polynomials of the first and second degree, of x^n = a, and of these in x^n. The coefficients are
polynomials in the parameters; a leading coefficient of unknown sign is assumed not to vanish, and that is a condition.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import gcd

import sympy as sp

from lagrange.algebra.closed_forms.limits import HIGHEST_DEGREE, LARGEST_FACTORED, MOST_FACTORED_SYMBOLS
from lagrange.algebra.closed_forms.signs import SignCondition, different_from_zero, not_negative, sign_of
from lagrange.core.operations import count_operations
from lagrange.core.records import record


def irreducible_factors(e: sp.Expr) -> list[sp.Expr] | None:
    """The irreducible factors of a polynomial, each once; None where it is too large."""
    if not can_be_factored(e):
        return None
    return [*_factors(e)]


@lru_cache(maxsize=256)  # each case of an equation, and each answer to it, tries the same polynomials
def _factors(e: sp.Expr) -> tuple[sp.Expr, ...]:
    try:
        _, powers = sp.factor_list(e)
    except (sp.PolynomialError, NotImplementedError):
        return (e,)
    return tuple(f for f, _ in powers)


def can_be_factored(e: sp.Expr) -> bool:
    """Whether a polynomial is small enough to be factored."""
    return bool(count_operations(e) <= LARGEST_FACTORED and len(e.free_symbols) <= MOST_FACTORED_SYMBOLS)


def numerator(e: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """Numerator and denominator of a rational expression in lowest terms; None where it is too large."""
    if count_operations(e) > 4 * LARGEST_FACTORED or len(e.free_symbols) > 2 * MOST_FACTORED_SYMBOLS:
        return None
    try:
        above, below = sp.fraction(sp.cancel(sp.together(e)))
    except (sp.PolynomialError, NotImplementedError):
        above, below = sp.fraction(sp.together(e))
    return sp.expand(above), below


def square_root(e: sp.Expr) -> sp.Expr:
    """√e with squares taken out of the root, up to sign; real where e is positive, as √(−1/(b − c)) = 1/√(c − b) is."""
    above, below = sp.fraction(sp.factor(e) if count_operations(e) <= LARGEST_FACTORED else e)
    outside, inside = _square_part(above)
    outside_below, inside_below = _square_part(below)
    if -1 in (sign_of(inside), sign_of(inside_below)):
        inside, inside_below = sp.expand(-inside), sp.expand(-inside_below)
    return outside / outside_below * sp.sqrt(inside) / sp.sqrt(inside_below)


def _square_part(product: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """A, B with product = A² B."""
    outside, inside = [], []
    for factor in sp.Mul.make_args(product):
        base, exponent = factor.as_base_exp()
        half = sp.floor(exponent / 2) if exponent.is_Rational else sp.S.Zero
        outside.append(base**half)
        inside.append(base ** (exponent - 2 * half) if exponent.is_Rational else factor)
    return sp.Mul(*outside), sp.expand(sp.Mul(*inside))


@record
class Value:
    """A root x of a polynomial, stated as x^power = `stated`, or as x = `value` where that is None."""

    value: sp.Expr
    conditions: tuple[SignCondition, ...] = ()
    power: int = 1
    stated: sp.Expr | None = None


def polynomial_roots(f: sp.Expr, x: sp.Symbol) -> list[Value] | None:
    """The real roots of an irreducible polynomial; None where they are not found in closed form."""
    try:
        poly = sp.Poly(f, x)
    except sp.PolynomialError:
        return None
    degrees = [n for (n,), _ in poly.terms()]
    if not degrees or max(degrees) == 0 or max(degrees) > HIGHEST_DEGREE:
        return None
    step = gcd(*degrees)
    coefficient = {n // step: c for (n,), c in poly.terms()}
    roots = _low_degree(coefficient, max(degrees) // step)
    if roots is not None and step > 1:
        roots = [r for v in roots for r in _powers(v, int(step))]
    return None if roots is None or any(r.value.has(sp.I) for r in roots) else roots


def _low_degree(c: dict[int, sp.Expr], degree: int) -> list[Value] | None:
    zero = sp.S.Zero
    if degree == 1:
        return [Value(factored_quotient(-c.get(0, zero) / c[1]), different_from_zero(c[1]))]
    if degree != 2:
        return None
    a, b, d = c[2], c.get(1, zero), c.get(0, zero)
    discriminant = sp.factor(b**2 - 4 * a * d)
    conditions = not_negative(discriminant)
    if conditions is None:
        return []
    if sp.factor(b / (2 * a)).could_extract_minus_sign() == a.could_extract_minus_sign():
        a, b, d = -a, -b, -d
    root = square_root(discriminant)
    nonzero = different_from_zero(a)
    return [Value(factored_quotient((-b + sign * root) / (2 * a)), (*conditions, *nonzero)) for sign in (1, -1)]


def _powers(v: Value, n: int) -> Iterator[Value]:
    """x^n = v."""
    if n % 2:
        sign = sign_of(v.value)
        if v.value == 0:
            yield v
        elif sign is None:
            yield Value(sp.sign(v.value) * sp.Abs(v.value) ** sp.Rational(1, n), v.conditions, n, v.value)
        else:
            yield Value(sign * (sign * v.value) ** sp.Rational(1, n), v.conditions, n, v.value)
        return
    conditions = not_negative(v.value)
    if conditions is None:
        return
    root = square_root(v.value)
    if n > 2:
        root = root ** sp.Rational(2, n)
    for sign in (1, -1):
        yield Value(sign * root, (*v.conditions, *conditions))


@lru_cache(maxsize=256)
def factored_quotient(e: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms and factors, if it is short."""
    if count_operations(e) > LARGEST_FACTORED:
        return e
    return (
        sp.factor(e) if not any(p.exp.is_Rational and not p.exp.is_Integer for p in e.atoms(sp.Pow)) else _with_roots(e)
    )


def _with_roots(e: sp.Expr) -> sp.Expr:
    """(A + √D)/B: the parts over one denominator, without the common factor of A and B."""
    together = sp.together(e)
    above, below = sp.fraction(together)
    common = sp.gcd_terms(above)
    return sp.factor_terms(common / below)


def over_one_denominator_in_roots(e: sp.Expr) -> sp.Expr:
    """√(1 − v²/c²) as √(c² − v²)/c."""
    roots = [p for p in e.atoms(sp.Pow) if abs(p.exp) == sp.S.Half and p.base.is_Add]
    return e.xreplace({p: sp.together(p.base) ** p.exp for p in roots})


def without_squares(e: sp.Expr) -> sp.Expr:
    """√(x² + 2 x y + y²) as |x + y|."""
    roots = [p for p in e.atoms(sp.Pow) if p.exp in (sp.S.Half, -sp.S.Half) and p.base.is_Add]
    squares = {p: sp.factor(p.base) ** p.exp for p in roots}
    return e.xreplace({p: s for p, s in squares.items() if all(f.exp.is_Integer for f in s.atoms(sp.Pow))})
