"""How far points held by rods of given lengths can be, and their angles: where equilibria of linkages are sought.

A constraint x₁² + y₁² = l₁² bounds x₁ and y₁, and (x₂ − x₁)² + (y₂ − y₁)² = l₂² then bounds x₂ and y₂. In general let
a constraint be a quadratic function whose squares are completed one after another,

    Σ_k d_k (u_k − s_k)² = c ,     d_k > 0 ,     s_k linear in the unknowns after u_k .

Then |u_1 − s_1| ≤ √(c/d_1), and u_1 is bounded where the unknowns in s_1 are. Where each constraint has two squares
with the same d, and s in unknowns of those before it, as in a chain of rods in a plane, u_1 − s_1 = ρ cos φ and
u_2 − s_2 = ρ sin φ: the constraints hold for any angles φ, and every position has one set of them.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.mechanics.equilibrium.limits import LONGEST_LINK


def reach_of_links(constraints: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The greatest size of each unknown that constraints, each zero, with numbers for the parameters, bound."""
    quadratic = [
        e
        for e in constraints
        if count_operations(e) <= LONGEST_LINK
        and e.is_polynomial(*unknowns)
        and sp.Poly(e, *unknowns).total_degree() == 2
    ]
    reach: dict[sp.Symbol, sp.Expr] = {}
    for _ in unknowns:
        for e in quadratic:
            for u in unknowns:
                if u not in reach and u in e.free_symbols and (size := _size(e, u, unknowns, reach)) is not None:
                    reach[u] = size
    return reach


def angles_of_links(constraints: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr] | None:
    """All unknowns as functions of one angle for each constraint; None where these are no chain of rods in a plane."""
    short = all(count_operations(e) <= LONGEST_LINK and e.is_polynomial(*unknowns) for e in constraints)
    if len(unknowns) != 2 * len(constraints) or not short:
        return None
    placed: dict[sp.Symbol, sp.Expr] = {}
    waiting = [*constraints]
    while waiting:
        for e in waiting:
            new = [u for u in unknowns if u in e.free_symbols and u not in placed]
            rod = _rod(sp.expand(e), new, unknowns) if len(new) == 2 else None
            if rod is None:
                continue
            length, middles = rod
            angle = sp.Dummy(f"phi_{len(placed) // 2}", real=True)
            waves = (sp.cos(angle), sp.sin(angle))
            placed |= {u: m.xreplace(placed) + length * w for u, m, w in zip(new, middles, waves, strict=True)}
            waiting.remove(e)
            break
        else:
            return None
    return placed


def _rod(
    e: sp.Expr, new: Sequence[sp.Symbol], unknowns: Sequence[sp.Symbol]
) -> tuple[sp.Expr, tuple[sp.Expr, ...]] | None:
    """ρ and s of (u_1 − s_1)² + (u_2 − s_2)² = ρ²; None where a constraint is not of this form."""
    square = e.coeff(new[0], 2)
    if sp.Poly(e, *unknowns).total_degree() != 2 or not square.is_number or square == 0:
        return None
    middles = tuple(sp.expand(-e.coeff(u, 1) / (2 * square)) for u in new)
    if any(not m.free_symbols.isdisjoint(new) for m in middles):
        return None
    rest = sp.expand(e / square - sp.Add(*((u - m) ** 2 for u, m in zip(new, middles, strict=True))))
    return (sp.sqrt(-rest), middles) if rest.is_number and rest.is_negative else None


def _size(e: sp.Expr, u: sp.Symbol, unknowns: Sequence[sp.Symbol], reach: dict[sp.Symbol, sp.Expr]) -> sp.Expr | None:
    """The greatest |u| where e = 0; None if the bounds of the other unknowns give none."""
    rest, first, shift = sp.expand(e), sp.S.Zero, sp.S.Zero
    if rest.coeff(u, 2).is_negative:  # l² = x² + y²
        rest = -rest
    for v in (u, *(w for w in unknowns if w != u)):
        square, linear = rest.coeff(v, 2), rest.coeff(v, 1)
        if not square.is_number or square.is_negative:
            return None
        if square == 0:
            if linear != 0:
                return None
            continue
        middle = sp.expand(-linear / (2 * square))
        if v == u:
            first, shift = square, middle
        rest = sp.expand(rest - square * (v - middle) ** 2)
    if first == 0 or not rest.is_number or not rest.is_nonpositive:
        return None
    size = sp.sqrt(-rest / first)
    for v in shift.free_symbols:
        if v not in reach:
            return None
        size += abs(shift.coeff(v, 1)) * reach[v]
    return size + abs(shift.xreplace(dict.fromkeys(shift.free_symbols, sp.S.Zero)))
