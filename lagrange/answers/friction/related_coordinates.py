"""Coordinates in conditions of rest that constraints relate: the height and the distance of a particle on a wire.

Conditions that say the same in different coordinates, |x| ≤ 2 a μ and y ≤ a μ² with x² = 4 a y, agree only where the
constraints hold. So what is drawn at random is moved there, and for an exact comparison a coordinate that a constraint
gives in terms of the others is put in.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.answers.results.at_random import approximate, root_near
from lagrange.mechanics.constraints.kinematics import Configuration

Point = dict[sp.Symbol, float]


def relations(
    expressions: Sequence[sp.Expr], configuration: Configuration, values: Mapping[sp.Symbol, sp.Rational]
) -> list[sp.Expr]:
    """The constraints among the coordinates of expressions, each zero, if there are at least two coordinates."""
    used = {s for e in expressions for s in e.free_symbols} & {*configuration.slots.coordinates}
    if len(used) < 2:
        return []
    return [f.xreplace(dict(values)) for f in configuration.finite_constraints if f.free_symbols & used]


def dependent(constraints: Sequence[sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """The symbols without a known sign, coordinates, that constraints give in terms of others: y = x²/(4a)."""
    rule: dict[sp.Symbol, sp.Expr] = {}
    for f in constraints:
        own = f.xreplace(rule)
        for s in _coordinates(own):
            rate = own.diff(s)
            if rate != 0 and not _coordinates(rate):
                value = {s: sp.expand(s - own / rate)}
                rule = {q: e.xreplace(value) for q, e in rule.items()} | value
                break
    return rule


def on_relations(point: Point, constraints: Sequence[sp.Expr]) -> Point | None:
    """The point with as many of its coordinates moved as there are constraints; None if that finds no position."""
    rule = dependent(constraints)
    if len(rule) == len(constraints):
        return {**point, **{q: approximate(e, point) for q, e in rule.items()}}
    if len(constraints) > 1:
        return None
    [f] = constraints
    q = _coordinates(f)[-1]
    root = root_near(lambda v: approximate(f, {**point, q: v}), point[q])
    return None if root is None else {**point, q: root}


def _coordinates(e: sp.Expr) -> list[sp.Symbol]:
    return sorted((s for s in e.free_symbols if s.is_positive is None), key=str)
