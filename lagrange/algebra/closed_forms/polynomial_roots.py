"""Polynomials in one letter: factors, and real roots in closed form with the conditions under which they are real.

Roots are found of polynomials of the first and second degree, of x^n = a, and of these in x^n. The coefficients are
polynomials in the parameters; a leading coefficient of unknown sign is assumed not to vanish, and that is a condition.

Polynomial equations that are linear in powers of the unknowns: a x² + b y² = c.

With the monomials as unknowns, such equations are linear. As many equations as monomials determine each of them:

    2 x² − 3 y² = 0 ,   3 x² − 2 y² = 0      x² = 0 ,  y² = 0 ,

and not a curve. Homogeneous equations in two unknowns, x = t y, have a common real zero beside the origin if and only
if the polynomials in t have one (Sturm); a form with one sign, 2 x² + 3 x y + 8 y², vanishes at the origin alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from math import gcd

import sympy as sp

from lagrange.algebra.closed_forms.limits import (
    HIGHEST_COUNTED_DEGREE,
    HIGHEST_DEGREE,
    LARGEST_FACTORED,
    LONGEST_SPHERE,
    MOST_FACTORED_SYMBOLS,
    SPHERES,
)
from lagrange.algebra.closed_forms.shortest_form import reading_length, shortest_form, without_leading_minus
from lagrange.algebra.closed_forms.signs import SignCondition, different_from_zero, not_negative, sign_of
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record


def irreducible_factors(e: sp.Expr) -> list[sp.Expr] | None:
    """The irreducible factors of a polynomial, each once; None if it is too large."""
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
    """Numerator and denominator of a rational expression in lowest terms; None if it is too large."""
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


def other_wave(value: sp.Expr) -> sp.Expr:
    """√(1 − s²) of a sine s, up to sign; √(d² − n²)/d where s = n/d with a root d, so that no root is of what is
    negative."""
    above, below = sp.fraction(sp.together(value))
    if any(f.is_Pow and f.exp == sp.S.Half and f.base.is_Add for f in sp.Mul.make_args(below)):
        return square_root(sp.expand(below**2 - above**2)) / below
    return square_root(1 - value**2)


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
    """The real roots of an irreducible polynomial; None if they are not found in closed form."""
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


def shortest_value(e: sp.Expr) -> sp.Expr:
    """A value as a book would print it: over one denominator, in factors, or term by term, whichever is shortest.

    B/2 + b W/l, and not (B l + 2 b W)/(2 l); 27 (R − a)/10, and not 27 R/10 − 27 a/10.
    """
    forms = dict.fromkeys((e, factored_quotient(e), *_term_by_term(e)))
    return min((without_leading_minus(shortest_form(f)) for f in forms), key=reading_length)


def _term_by_term(e: sp.Expr) -> tuple[sp.Expr, ...]:
    """(B l + 2 b W)/(2 l) as B/2 + b W/l, where only one term is left with a symbol below."""
    above, below = sp.fraction(e)
    if below == 1 or not all(f.is_number or f.as_base_exp()[0].is_Symbol for f in sp.Mul.make_args(below)):
        return ()
    terms = [term / below for term in sp.Add.make_args(sp.expand_mul(above))]
    quotients = sum(not sp.fraction(term)[1].is_number for term in terms)
    return (sp.Add(*terms),) if len(terms) > 1 and quotients == 1 else ()


def over_one_denominator_in_roots(e: sp.Expr) -> sp.Expr:
    """√(1 − v²/c²) as √(c² − v²)/c."""
    roots = [p for p in e.atoms(sp.Pow) if abs(p.exp) == sp.S.Half and p.base.is_Add]
    return e.xreplace({p: sp.together(p.base) ** p.exp for p in roots})


def without_squares(e: sp.Expr) -> sp.Expr:
    """√(x² + 2 x y + y²) as |x + y|."""
    roots = [p for p in e.atoms(sp.Pow) if p.exp in (sp.S.Half, -sp.S.Half) and p.base.is_Add]
    squares = {p: sp.factor(p.base) ** p.exp for p in roots}
    return e.xreplace({p: s for p, s in squares.items() if all(f.exp.is_Integer for f in s.atoms(sp.Pow))})


# Linear in powers


def without_common_squares(equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> tuple[sp.Expr, ...]:
    """Equations of the second degree with the same squares, as of three spheres, as one of them and linear ones."""
    forms = [_squares(e, unknowns) for e in equations]
    kept: list[sp.Expr] = []
    first: dict[sp.Expr, sp.Expr] = {}
    for e, (number, form) in zip(equations, forms, strict=True):
        alike = [f for _, f in forms if f == form]
        enough = min(SPHERES, max(2, len(form.free_symbols & {*unknowns})))  # two circles, three spheres
        if number == 0 or len(alike) < enough or form not in first:
            first |= {form: e / number} if number != 0 else {}
            kept.append(e)
        else:
            kept.append(sp.expand(e / number - first[form]))
    return tuple(kept)


def _squares(e: sp.Expr, unknowns: Sequence[sp.Symbol]) -> tuple[sp.Expr, sp.Expr]:
    """The part of the second degree of an equation of that degree, as a number and the rest; 0 where it is none."""
    none = (sp.S.Zero, sp.S.One)
    if count_operations(e) > LONGEST_SPHERE or not e.is_polynomial(*unknowns) or not e.free_symbols & {*unknowns}:
        return none
    poly = sp.Poly(e, *unknowns)
    if poly.total_degree() != 2:
        return none
    square = (c * sp.Mul(*(u**n for u, n in zip(unknowns, powers, strict=True)))
              for powers, c in poly.terms() if sum(powers) == 2)  # fmt: skip
    number, form = sp.Add(*square).as_coeff_Mul()
    return number, form


def solved_for_powers(equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> tuple[sp.Expr, ...] | None:
    """Equations in which each has one monomial, x² − c: as many as there are powers. None if they are so already."""
    if not len(equations) > 1 or any(
        count_operations(e) > LONGEST_SPHERE or not e.is_polynomial(*unknowns) for e in equations
    ):
        return None
    polynomials = [sp.Poly(e, *unknowns) for e in equations]
    monomials = sorted({m for p in polynomials for m in p.monoms() if any(m)}, reverse=True)
    if not 1 < len(monomials) <= len(equations) or any(sum(k > 0 for k in m) > 1 for m in monomials):
        return None
    rows = [[p.nth(*m) for m in monomials] + [p.nth(*[0] * len(unknowns))] for p in polynomials]
    for column in range(len(monomials)):
        able = [n for n in range(column, len(rows)) if rows[n][column] != 0]
        if not able:
            return None
        able.sort(key=lambda n: (sign_of(rows[n][column]) is None, count_operations(rows[n][column])))
        rows[column], rows[able[0]] = rows[able[0]], rows[column]
        pivot = rows[column][column]
        for n in range(len(rows)):
            if n != column and rows[n][column] != 0:
                factor = rows[n][column]
                rows[n] = [sp.cancel(a - factor * b / pivot) for a, b in zip(rows[n], rows[column], strict=True)]
    solved = []
    for n, row in enumerate(rows):
        monomial = sp.Mul(*(u**k for u, k in zip(unknowns, monomials[n], strict=True))) if n < len(monomials) else 0
        above, _ = sp.fraction(sp.together((row[n] if n < len(monomials) else 0) * monomial + row[-1]))
        solved += [sp.expand(above).primitive()[1]] if above != 0 else []
    mixed = any(sum(map(any, p.monoms())) > 1 for p in polynomials)
    return tuple(solved) if mixed else None


def zeros_of_even_sum(e: sp.Expr, unknowns: Sequence[sp.Symbol]) -> tuple[sp.Symbol, ...]:
    """The unknowns that all vanish where a sum of even powers with coefficients of one sign does: 2x² + y² = 0.

    None of them where it is no such sum, or one of them has no power of its own.
    """
    if len(unknowns) < 2 or not e.is_polynomial(*unknowns):
        return ()
    terms = sp.Poly(e, *unknowns).terms()
    signs = {sign_of(c) for _, c in terms}
    if signs not in ({1}, {-1}) or any(n % 2 for powers, _ in terms for n in powers):
        return ()
    alone = [[n > 0 for n in powers] for powers, _ in terms]
    return tuple(unknowns) if all([k == j for k in range(len(unknowns))] in alone for j in range(len(unknowns))) else ()


def vanish_at_origin_alone(forms: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> bool:
    """Whether homogeneous polynomials in two unknowns, rational up to a factor, have no other common zero."""
    if len(unknowns) != 2 or not forms or not all(e.is_polynomial(*unknowns) for e in forms):
        return False
    common = sp.Poly(0, unknowns[0], domain="QQ")
    for e in forms:
        poly = sp.Poly(e, *unknowns)
        if not poly.is_homogeneous or poly.total_degree() > HIGHEST_COUNTED_DEGREE:
            return False
        leading = poly.coeffs()[0]
        ratios = [sp.cancel(c / leading) for c in poly.coeffs()]
        if sign_of(leading) in (0, None) or not all(r.is_Rational for r in ratios):
            return False
        at_one = sp.Add(*(r * unknowns[0] ** n for (n, _), r in zip(poly.monoms(), ratios, strict=True)))
        # x^n alone vanishes at x = 0, which is the line t = 0; y^n alone at t = ∞, where the degree in x is lower.
        common = common.gcd(sp.Poly(at_one, unknowns[0], domain="QQ"))
    at_infinity = all(sp.Poly(e, *unknowns).degree(unknowns[0]) < sp.Poly(e, *unknowns).total_degree() for e in forms)
    return not at_infinity and common.count_roots() == 0
