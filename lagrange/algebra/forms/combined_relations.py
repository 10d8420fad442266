"""Relations f = const and g = const in which a coordinate occurs linearly, added so that it drops out.

With constant slopes a = ∂f/∂q and b = ∂g/∂q the combination b f − a g is constant too, and free of q. It is worth a
line where it has fewer coordinates than either: of the wheels and the gear of the south-pointing chariot,
R φ₁ − R φ₂ + 2b ψ = const and 2b θ − R (φ₁ − φ₂) = const, it leaves θ + ψ = const, the direction of the arm.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.forms.limits import LONGEST_COMBINED_RELATION
from lagrange.algebra.fourier.vector_cleanup import ordered_differences
from lagrange.core.operations import count_operations
from lagrange.core.records import record


@record
class CombinedRelation:
    """function = const, from the relations at two places of a list."""

    function: sp.Expr
    places: tuple[int, int]


def combined_relations(functions: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> tuple[CombinedRelation, ...]:
    """The combinations of two functions that have fewer coordinates than either of them, the shortest first."""
    relations = sorted(_combinations(functions, coordinates), key=lambda c: len(c.function.free_symbols))
    return tuple({c.function: c for c in reversed(relations)}.values())[::-1]


def _combinations(functions: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> Iterator[CombinedRelation]:
    moving = {*coordinates}
    for (m, f), (n, g) in combinations(enumerate(functions), 2):
        if max(count_operations(f), count_operations(g)) > LONGEST_COMBINED_RELATION:
            continue
        fewest = min(len(f.free_symbols & moving), len(g.free_symbols & moving))
        for q in sorted(f.free_symbols & g.free_symbols & moving, key=str):
            a, b = sp.diff(f, q), sp.diff(g, q)
            if (a.free_symbols | b.free_symbols) & moving:
                continue
            rest = sp.expand(sp.cancel(b / a) * f - g)
            if 0 < len(rest.free_symbols & moving) < fewest:
                function = sp.Mul(*_without_constants(rest, moving))
                function = -function if function.could_extract_minus_sign() else function
                yield CombinedRelation(_collected(function, coordinates), (m, n))


def _collected(e: sp.Expr, coordinates: Sequence[sp.Symbol]) -> sp.Expr:
    """2y − R φ + r φ as 2y − (R − r) φ, where all coordinates occur linearly with constant slopes."""
    used = [q for q in coordinates if e.has(q)]
    slopes = [sp.factor(e.diff(q)) for q in used]
    if any(s.free_symbols & {*coordinates} for s in slopes):
        return e
    rest = e.xreplace(dict.fromkeys(used, sp.S.Zero))
    return sp.Add(rest, *(ordered_differences(s * q) for s, q in zip(slopes, used, strict=True)))


def _without_constants(e: sp.Expr, moving: set[sp.Symbol]) -> list[sp.Expr]:
    """The factors of an expression with coordinates in them."""
    return [f for f in sp.Mul.make_args(sp.factor(e)) if f.free_symbols & moving]
