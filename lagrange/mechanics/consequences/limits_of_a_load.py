"""Which limit of rest a growing load reaches first: whether a crate that is pushed slides or tips.

Rest needs P ≤ B with friction, |F| ≤ μ N, and P ≤ C where a contact must press. As P grows, slip comes first where
B < C. With B = μ k that is μ < C/k, a condition on the coefficient of friction alone.
"""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.records import record
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition
from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
from lagrange.mechanics.equilibrium.loads import load_parameters


@record
class FirstLimit:
    """As `load` grows, slip comes first if coefficient < critical; otherwise `force` of `constraint` vanishes first."""

    load: sp.Symbol
    coefficient: sp.Symbol
    critical: sp.Expr
    force: sp.Symbol
    constraint: str


def first_limit(rest: AtRest) -> FirstLimit | None:
    """Which of two upper bounds of a load, one of them with the only coefficient of friction, is reached first."""
    coefficients = {c.coefficient for c in rest.contacts}
    if len(rest.cases) != 1 or len(rest.cases[0]) != 2 or len(coefficients) != 1:
        return None
    [coefficient] = coefficients
    slips = [c for c in rest.cases[0] if coefficient in (c.left - c.right).free_symbols]
    others = [c for c in rest.cases[0] if c not in slips]
    if not coefficient.is_Symbol or len(slips) != 1 or len(others) != 1:
        return None
    for load in sorted(load_parameters(rest.configuration), key=str):
        most, other = (_upper_bound(c, load) for c in (slips[0], others[0]))
        if most is None or other is None:
            continue
        per_coefficient = sp.cancel(most / coefficient)
        critical = sp.cancel(other / per_coefficient)
        if sign_of(per_coefficient) != 1 or sign_of(critical) != 1 or coefficient in critical.free_symbols:
            continue
        for c in rest.contacts:
            force = c.reaction.force
            value = rest.forces.get(force)
            if value is not None and sp.cancel(value.xreplace({load: other})) == 0:
                return FirstLimit(load, coefficient, shortest_form(critical), force, c.reaction.name)
    return None


def for_one_load(conditions: tuple[RestCondition, ...], loads: tuple[sp.Symbol, ...]) -> tuple[RestCondition, ...]:
    """The conditions with one load on the left, if one of them has it there: P ≤ μ W beside P ≤ b W/h, not μ ≥ P/W."""
    for load in loads:
        if not any(c.left == load for c in conditions):
            continue
        bounds = [_upper_bound(c, load) for c in conditions]
        if None not in bounds:
            return tuple(RestCondition(load, shortest_form(b)) for b in bounds if b is not None)
    return conditions


def _upper_bound(c: RestCondition, load: sp.Symbol) -> sp.Expr | None:
    """B where the condition says load ≤ B."""
    numerator, denominator = sp.fraction(sp.together(c.right - c.left))
    slack = sp.expand(numerator)
    slope = slack.coeff(load, 1)
    if c.relation != "≤" or slack.diff(load) != slope or slope == 0 or load in denominator.free_symbols:
        return None
    if sign_of(slope) != -1 or sign_of(denominator) != 1:
        return None
    return sp.cancel(-(slack - slope * load) / slope)
