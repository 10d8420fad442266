"""Unsolved equations of an answer about equilibria, on the surfaces that they define.

A product vanishes on several sheets, one for each factor, and a point sampled on one of them says nothing of the rest:

    (k (θ − θ_0) + W l cos θ) (θ − θ_0) = 0

holds at every equilibrium, and at θ = θ_0, which is none. So every choice of one factor from each equation is a surface
of its own. Where there is no balance on it, the answer is wrong if it has a real point; θ² + 1 = 0 has none.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product
from math import prod

import sympy as sp

from lagrange.algebra.closed_forms.existence import have_real_solution
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError, TrigLetters
from lagrange.algebra.exact.zero_test import Surface
from lagrange.answers.limits import MOST_SHEETS
from lagrange.core.records import all_hold

Factors = Callable[[sp.Expr], Sequence[sp.Expr]]
BalancedOn = Callable[[Surface], bool | None]


def are_balanced(
    equations: Sequence[sp.Expr],
    rows: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    factors_of: Factors,
    balanced_on: BalancedOn,
) -> bool | None:
    """Whether all solutions of the equations, on the constraints `rows`, are equilibria; None: undecided."""
    factors = [factors_of(e) or [e] for e in equations]
    if prod(map(len, factors)) > MOST_SHEETS:
        return None
    sheets = [*product(*factors)]
    if len(sheets) == 1:
        return balanced_on(Surface([*equations, *rows], unknowns))
    return all_hold(_on_sheet([*sheet, *rows], unknowns, balanced_on) for sheet in sheets)


def _on_sheet(equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol], balanced_on: BalancedOn) -> bool | None:
    letters = TrigLetters(equations, unknowns)
    try:
        exists = have_real_solution([letters.read(e) for e in equations], letters)
    except NotAlgebraicError:
        exists = None
    holds = True if exists is False else balanced_on(Surface(equations, unknowns))
    return None if holds is False and exists is None else holds
