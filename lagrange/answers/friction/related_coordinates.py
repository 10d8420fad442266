"""Coordinates in conditions of rest that constraints relate: the height and the distance of a particle on a wire.

Conditions that say the same in different coordinates, |x| ≤ 2 a μ and y ≤ a μ² with x² = 4 a y, agree only where the
constraints hold. So what is drawn at random is moved there, and for an exact comparison a coordinate that a constraint
gives in terms of the others is put in.
"""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.limits import CLEAR_SLACK, FIRST_REST_SAMPLES
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


def restates_constraints(e: sp.Expr, configuration: Configuration, values: Mapping[sp.Symbol, sp.Rational]) -> bool:
    """Whether an expression vanishes because of the constraints, at acute angles: θ_1 − θ_2 of two equal legs."""
    constraints = relations([e], configuration, values)
    rule = dependent(constraints)
    own = e.xreplace(rule)
    left = [f for c in constraints if (f := sp.expand(c.xreplace(rule))) != 0]
    if not constraints or len(left) > 1:
        return False
    if not left:
        return is_zero(own) is True
    draw, held, [f] = random.Random(4), 0, left
    for _ in range(FIRST_REST_SAMPLES):
        point = {s: draw.uniform(0.05, 1.5) for s in sorted(f.free_symbols | own.free_symbols, key=str)}
        q = _coordinates(f)[-1]
        root = root_near(lambda v, p=point, q=q: approximate(f, {**p, q: v}), point[q])  # type: ignore[misc]
        if root is None or not 0 < root < math.pi / 2:
            continue
        if abs(approximate(own, {**point, q: root})) > CLEAR_SLACK:
            return False
        held += 1
    return held > 1


def _coordinates(e: sp.Expr) -> list[sp.Symbol]:
    return sorted((s for s in e.free_symbols if s.is_positive is None), key=str)
