"""One force that the balance leaves open: its bounds, and where any value within them exists.

Each bound is an inequality a s + c ≥ 0 in the open force s; those with a, c ≥ 0 hold for every s ≥ 0 and are left out.
For a ladder between rough ground and a rough wall, with the force N of the wall open,

    (1 − μ cot θ) N ≤ ½ μ W ,     (ν + cot θ) N ≥ ½ W ,

and there is such an N if and only if (1 − μ ν) tan θ ≤ 2μ: in every position where μ ν ≥ 1.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import without_leading_minus
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition, SolvedFor, not_negative
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Inequality, Signs
from lagrange.mechanics.equilibrium.limits import MOST_BOUNDS


def bounds_of(
    inequalities: Sequence[Inequality], open_: Sequence[sp.Symbol], signs: Signs
) -> tuple[RestCondition, ...]:
    """The bounds that do not hold for every s ≥ 0; none if they are many, or s ≥ 0 is not among them."""
    if not any(i.constant == 0 and signs.of(i.coefficients[0]) == 1 for i in inequalities):
        return ()
    [force] = open_
    found = []
    for i in inequalities:
        rate, constant = i.coefficients[0], i.constant
        if signs.of(rate) in (0, 1) and signs.of(constant) in (0, 1):
            continue
        if signs.of(constant) == -1 or (signs.of(constant) is None and signs.of(rate) == 1):
            found.append(RestCondition(-constant, sp.expand(rate) * force, "≤"))
        else:
            found.append(RestCondition(sp.expand(-rate) * force, constant, "≤"))
    distinct = tuple(dict.fromkeys(found))
    return distinct if len(distinct) <= MOST_BOUNDS else ()


def always(
    cases: Sequence[Sequence[RestCondition]], angles: Collection[sp.Symbol], signs: Signs
) -> RestCondition | None:
    """1 ≤ μ ν for (1 − μ ν) tan θ ≤ 2μ: where the only condition holds for every angle."""
    if len(cases) != 1 or len(cases[0]) != 1:
        return None
    [condition] = cases[0]
    moving = {s for f in condition.left.atoms(sp.sin, sp.cos, sp.tan) for s in f.free_symbols if s in angles}
    if condition.relation != "≤" or signs.of(condition.right) != 1:
        return None
    factors = sp.Mul.make_args(sp.factor(condition.left))
    open_ = [f for f in factors if signs.of(f) is None]
    if len(open_) != 1 or not moving or moving & open_[0].free_symbols:
        return None
    others = sp.Mul(*(f for f in factors if f is not open_[0]))
    found = not_negative(without_leading_minus(-open_[0] * signs.of(others)), SolvedFor(), signs)
    return found[0] if len(found) == 1 else None
