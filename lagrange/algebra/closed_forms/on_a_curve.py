"""The square of a length where a polynomial vanishes: by a multiple of the polynomial it may become shorter.

On the lemniscate f = (x² + y²)² − a² (x² − y²) = 0 the gradient has |∂f|² = 4 (x² + y²) A with

    A = a⁴ + 4 (x² + y²)² − 4a² (x² − y²) = a⁴ + 4f ,

so that |∂f| = 2a² √(x² + y²) there.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import permutations

import sympy as sp

from lagrange.algebra.closed_forms.limits import MOST_REDUCED_TERMS, MOST_REDUCED_VARIABLES


def where_zero(square: sp.Expr, relation: sp.Expr, variables: Collection[sp.Symbol]) -> sp.Expr:
    """The square, or the form that it has where the relation is zero, if fewer terms stay under its root.

    A form whose root would need the modulus of a coordinate is not taken: its sign would be that of the unit normal.
    """
    used = [v for v in variables if relation.has(v)]
    if not 1 <= len(used) <= MOST_REDUCED_VARIABLES or not square.has(*used):
        return square
    if not (relation.is_polynomial(*used) and square.is_polynomial(*used)):
        return square
    finite, whole = sp.Poly(relation, *used), sp.Poly(square, *used)
    if len(finite.terms()) > MOST_REDUCED_TERMS or len(whole.terms()) > MOST_REDUCED_TERMS:
        return square
    factored = sp.factor(square)
    pairs = [f.as_base_exp() for f in sp.Mul.make_args(factored)]
    by_factors = sp.Mul(*(_shortest(base, finite) ** n if base.has(*used) else base**n for base, n in pairs))
    forms = [e for e in (by_factors, _shortest(factored, finite)) if not _has_moduli(e, used)]
    best = min((factored, *forms), key=_under_the_root)
    return sp.factor(best) if _under_the_root(best) < _under_the_root(factored) else square


def _has_moduli(e: sp.Expr, variables: Collection[sp.Symbol]) -> bool:
    """Whether the root of e contains the modulus of something that may change its sign on the curve: |x| of x²."""
    pairs = (f.as_base_exp() for f in sp.Mul.make_args(sp.factor(e)))
    return any(n % 2 == 0 and base.has(*variables) for base, n in pairs)


def _shortest(e: sp.Expr, relation: sp.Poly) -> sp.Expr:
    """The shortest of e, of its remainders, and of these with the multiple of f that removes one of its terms."""
    forms = [sp.Poly(e, *relation.gens), *_remainders(e, relation)]
    forms += [p - relation * (p.coeff_monomial(m) / c) for p in forms for m, c in relation.terms()]
    return min((sp.factor(p.as_expr()) for p in dict.fromkeys(forms)), key=_under_the_root)


def _remainders(e: sp.Expr, relation: sp.Poly) -> Iterator[sp.Poly]:
    f = relation.as_expr()
    for order in ("lex", "grevlex"):
        for variables in permutations(relation.gens):
            yield sp.Poly(sp.reduced(sp.expand(e), [sp.expand(f)], *variables, order=order)[1], *relation.gens)


def _under_the_root(e: sp.Expr) -> int:
    """How many terms the sums have that stay under the root of e."""
    pairs = (f.as_base_exp() for f in sp.Mul.make_args(sp.factor(e)))
    return sum(len(base.args) for base, n in pairs if base.is_Add and n % 2 != 0)
