"""Solutions that are seen at once, of equations that are not solved: every unknown 0, or π where it is an angle.

c (2a − b) = l P sin a,  c (b − a) = l P sin b      a = b = 0
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.closed_form import Values
from lagrange.algebra.closed_forms.unit_circle import Letters

MOST_SEEN = 4
"""Unknowns whose values 0 and π are tried."""


def seen_at_once(equations: Sequence[sp.Expr], letters: Letters) -> Iterator[Values]:
    """The values of unknowns, and of their letters, with which all equations (in letters) vanish."""
    found = frozenset[sp.Symbol]().union(*map(letters.unknowns_in, equations))
    unknowns = [u for u in letters.unknowns if u in found]
    if len(unknowns) > MOST_SEEN:
        return
    for place in product(*((sp.S.Zero, sp.pi) if u in letters.angles else (sp.S.Zero,) for u in unknowns)):
        values: dict[sp.Symbol, sp.Expr] = {}
        for u, value in zip(unknowns, place, strict=True):
            values[u] = value
            if u in letters.angles:
                angle = letters.angles[u]
                measure = angle.measure.xreplace({u: value})
                values |= {angle.cosine: sp.cos(measure), angle.sine: sp.sin(measure)}
        if all(sp.expand(e.xreplace(values)) == 0 for e in equations):
            yield values
