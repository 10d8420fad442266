"""Newton's law along the unit vectors that a file names, where its components are shorter there.

Of a block on the face of a wedge, with s down the face and n normal to it, the component along n has the normal force
alone, m (X'' sin α + w'') = N − m g cos α, and that along s none of it. Components along i and j have both.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.newton import FreeBody, LawComponent
from lagrange.mechanics.limits import LONGEST_IN_DIRECTIONS
from lagrange.mechanics.rewriting.factors import with_common_factor
from lagrange.mechanics.rewriting.named_directions import Directions


def in_named_components(body: FreeBody, units: Directions) -> FreeBody:
    """The body with the components of Newton's law along two named vectors of their plane, if they are shorter."""
    laws = body.components
    if len(laws) != 2 or sum(map(_length, laws)) > LONGEST_IN_DIRECTIONS:
        return body
    best = min(_forms(laws, units), key=lambda form: sum(map(_length, form)), default=laws)
    return replace(body, components=best) if sum(map(_length, best)) < sum(map(_length, laws)) else body


def _forms(laws: tuple[LawComponent, ...], units: Directions) -> Iterator[tuple[LawComponent, ...]]:
    """The components along each pair of perpendicular named vectors in the plane of the two that there are."""
    axes = [c.along.fixed() for c in laws]
    if is_zero(axes[0].dot(axes[1])) is not True:
        return
    for pair in combinations(units.values(), 2):
        shares = [[e.fixed().dot(axis) for axis in axes] for e in pair]
        spans = all(is_zero(sp.Add(*(x**2 for x in share)) - 1) is True for share in shares)
        if spans and is_zero(pair[0].dot(pair[1])) is True:
            yield tuple(_along(e, share, laws) for e, share in zip(pair, shares, strict=True))


def _along(e: Vector, shares: list[sp.Expr], laws: tuple[LawComponent, ...]) -> LawComponent:
    """Σ (e·a) times the component along a; along −e where every term of the inertia would have a minus."""

    def projected(*parts: sp.Expr) -> sp.Expr:
        return textbook_form(sp.Add(*(share * part for share, part in zip(shares, parts, strict=True))))

    inertia = projected(*(c.inertia for c in laws))
    if all(a.could_extract_minus_sign() for a in sp.Add.make_args(sp.expand(inertia))) and inertia != 0:
        return _along(e * sp.S.NegativeOne, [-share for share in shares], laws)
    applied, reaction = projected(*(c.applied for c in laws)), projected(*(c.reaction for c in laws))
    return LawComponent(e, with_common_factor(inertia), applied, reaction)


def _length(law: LawComponent) -> int:
    return count_operations(law.inertia) + count_operations(law.right)
