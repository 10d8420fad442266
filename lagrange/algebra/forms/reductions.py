"""How a constraint is reduced (`nonlinear_constraints`): the steps, each an equivalence, and the alternatives."""

from __future__ import annotations

from enum import StrEnum

import sympy as sp

from lagrange.core.records import record


class Why(StrEnum):
    """Why a function vanishes if and only if others do."""

    POWER = "power"  # u^n = 0: u = 0
    FACTOR = "factor"  # a u = 0 with a ≠ 0: u = 0
    QUOTIENT = "quotient"  # u/v = 0: u = 0, with v ≠ 0
    FUNCTION = "function"  # |u| = 0, sinh u = 0: u = 0
    INVERSE = "inverse"  # exp u = w: u = log w
    DIRECTION = "direction"  # atan2(u, v) = w: u cos w − v sin w = 0
    SQUARED = "squared"  # √u = w: u = w²
    SQUARES = "squares"  # u² + v² = 0: u = 0 and v = 0
    FACTORED = "factored"  # u² − 2 u v + v² = 0: (u − v)² = 0
    EXPANDED = "expanded"  # multiplied out, it is linear
    SPLIT = "split"  # u v = 0: u = 0 or v = 0


SideCondition = tuple[sp.Expr, str]
"""An assumption of a step: (e, "≠") for e ≠ 0, (e, "≥") for e ≥ 0."""


@record
class Reduction:
    """`function` vanishes if and only if all `forms` do; where it splits, if one does, and the first is followed.

    excluded  functions of q and t whose zeros satisfy it as well; they are assumed not to vanish
    """

    function: sp.Expr
    why: Why
    forms: tuple[sp.Expr, ...]
    conditions: tuple[SideCondition, ...] = ()
    excluded: tuple[sp.Expr, ...] = ()


@record
class Alternative:
    """Functions of q, q', t that all vanish, and the steps that lead to them."""

    forms: tuple[sp.Expr, ...]
    steps: tuple[Reduction, ...] = ()


@record
class Alternatives:
    """All alternatives of a constraint; none if it cannot be satisfied. `endless`: the first of infinitely many."""

    members: tuple[Alternative, ...]
    endless: bool = False
