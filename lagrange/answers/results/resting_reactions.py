"""Wrong reactions of a system at rest, stated as functions of the position: which letter is wrong, which term missing.

R(q) is compared with the right reaction at the position of equilibrium, where the two differ by R_0 − R(q_0). A letter
p with the opposite sign makes the difference R(q; −p) − R(q; p), and a forgotten term p q/l makes itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.static_reactions import ReactionsAtRest


def of_one_letter(
    value: sp.Expr,
    off: sp.Expr,
    letters: Sequence[sp.Expr],
    at_rest: ReactionsAtRest,
    coordinates: Sequence[sp.Symbol],
) -> str:
    """Which letter has a wrong sign in a stated value, or which term is missing, in a sentence; empty if not found.

    off  by how much it is too small at the equilibrium
    """
    if value.free_symbols.isdisjoint(coordinates):
        return ""
    for said, more in _changes(value, letters, coordinates):
        [difference] = next(iter(at_rest.points.values_at([more])))
        if is_zero(difference - off) is True:
            return said
    return ""


def _changes(
    value: sp.Expr, letters: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]
) -> Iterator[tuple[str, sp.Expr]]:
    used = [p for p in letters if p in value.free_symbols]
    for p in used:
        yield f"this is the reaction for {p} with the opposite sign", value.xreplace({p: -p}) - value
    for p, q in product((p for p in letters if p.is_Symbol and p not in used), coordinates):
        yield f"the term {p}*{q} is missing", p * q
        for below in used:
            yield f"the term {p}*{q}/{below} is missing", p * q / below
