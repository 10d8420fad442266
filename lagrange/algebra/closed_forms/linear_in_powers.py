"""Polynomial equations that are linear in powers of the unknowns: a x² + b y² = c.

With the monomials as unknowns, such equations are linear. As many equations as monomials determine each of them:

    2 x² − 3 y² = 0 ,   3 x² − 2 y² = 0      x² = 0 ,  y² = 0 ,

and not a curve. Homogeneous equations in two unknowns, x = t y, have a common real zero beside the origin if and only
if the polynomials in t have one (Sturm); a form with one sign, 2 x² + 3 x y + 8 y², vanishes at the origin alone.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.closed_forms.limits import HIGHEST_COUNTED_DEGREE, LONGEST_SPHERE, SPHERES
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.operations import count_operations


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
    """Equations in which each has one monomial, x² − c: as many as there are powers. None where they are so already."""
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
