"""Polynomials as short sums of products: (M + m₁)(m₂ + m₃) + 4m₂ m₃, not M m₂ + M m₃ + m₁ m₂ + m₁ m₃ + 4m₂ m₃.

Letters that occur in the first power only, and whose coefficients agree up to a product, have one bracket: the
coefficients of M and m₁ are both m₂ + m₃. What is left over is written in the same way.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.mechanics.limits import MOST_GROUPED_TERMS
from lagrange.mechanics.rewriting.factors import with_like_terms


def in_products(e: sp.Expr) -> sp.Expr:
    """The expression with its sums as sums of products, where that is shorter."""
    if e.is_Atom or not e.has(sp.Add):
        return e
    if e.is_Add:
        short = _grouped(sp.expand(e))
        return short if count_operations(short) < count_operations(e) else e
    inner = [in_products(a) if isinstance(a, sp.Expr) else a for a in e.args]
    changed = any(a is not b for a, b in zip(inner, e.args, strict=True))
    return e.func(*inner, evaluate=False) if changed and e.is_Mul else e.func(*inner) if changed else e


def _grouped(e: sp.Expr) -> sp.Expr:
    """A polynomial that is multiplied out: common factors, its largest bracket, then the rest."""
    shared = sp.factor_terms(e)
    if shared.is_Mul:
        return sp.Mul(*(_grouped(sp.expand(f)) if f.is_Add else f for f in shared.args), evaluate=False)
    terms = sp.Add.make_args(e)
    if len(terms) > MOST_GROUPED_TERMS or not e.is_polynomial(*e.free_symbols):
        return e
    found = max(_brackets(e), key=lambda b: len(sp.Add.make_args(b[0])) * len(b[1]), default=None)
    if found is None:
        return with_like_terms(e, e.free_symbols)
    bracket, shares = found
    first = sp.Add(*shares)
    rest = sp.expand(e - first * bracket)
    product = sp.Mul(_grouped(first), _grouped(bracket), evaluate=False)
    return product if rest == 0 else sp.Add(product, *sp.Add.make_args(_grouped(rest)), evaluate=False)


def _brackets(e: sp.Expr) -> Iterator[tuple[sp.Expr, list[sp.Expr]]]:
    """Each bracket that several letters share, with the products of each of them beside it."""
    shares: dict[sp.Expr, list[tuple[sp.Symbol, sp.Expr]]] = {}
    for letter in sorted(e.free_symbols, key=str):
        coefficient = e.coeff(letter, 1)
        if not coefficient.is_Add or (e - letter * coefficient).has(letter**2) or coefficient.has(letter):
            continue
        number, rest = sp.factor_terms(coefficient).as_coeff_Mul()
        sums = [f for f in sp.Mul.make_args(rest) if f.is_Add]
        if len(sums) != 1:
            continue
        [bracket] = sums
        beside = number * sp.Mul(*(f for f in sp.Mul.make_args(rest) if f is not bracket))
        if bracket.could_extract_minus_sign():
            bracket, beside = -bracket, -beside
        shares.setdefault(bracket, []).append((letter, beside))
    for bracket, pairs in shares.items():
        letters = {s for s, _ in pairs}
        if len(pairs) > 1 and not any(letters & (bracket * beside).free_symbols for _, beside in pairs):
            yield bracket, [s * beside for s, beside in pairs]
