"""Virtual displacements that constraints on velocities leave, as they may be symmetries."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.fourier.common_factor import as_term
from lagrange.algebra.fourier.terms import Exponent
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration, is_pfaffian
from lagrange.mechanics.dynamics.verification import displacement_basis

MOST_COLUMNS = 6
LONGEST_COLUMN = 60
"""Operations of a virtual displacement that is still tried."""


def admitted_displacements(elimination: Elimination, configuration: Configuration) -> list[tuple[sp.Expr, ...]]:
    """The virtual displacements where velocities are constrained, with and without their denominators, (., n)."""
    rows = configuration.rows
    if all(r.finite is not None for r in rows) or not is_pfaffian(rows):
        return []
    found: dict[tuple[sp.Expr, ...], None] = {}
    for column in displacement_basis(elimination, len(configuration.slots.coordinates)):
        if sum(e.count_ops() for e in column) > LONGEST_COLUMN:
            continue
        below = sp.Mul(*_denominators(column))
        if below != 1:
            found[tuple(textbook_form(e * below) for e in column)] = None
        found[tuple(column)] = None
    return [c for c in found if sum(e != 0 for e in c) > 1][:MOST_COLUMNS]


def _denominators(column: Sequence[sp.Expr]) -> list[sp.Expr]:
    """What the entries of a column are divided by: sin θ in cos θ/sin θ."""
    found: dict[sp.Expr, Exponent] = {}
    for e in column:
        for term in sp.Add.make_args(e):
            for factor, exponent in as_term(term).factors.items():
                if exponent < 0:
                    found[factor] = max(found.get(factor, 0), -exponent)
    return [f**e for f, e in found.items()]
