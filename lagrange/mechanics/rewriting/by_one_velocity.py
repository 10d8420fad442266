"""Velocities after an impact as multiples of one velocity, where they are long by themselves.

After an impact that leaves one degree of freedom all velocities are multiples of one: x' = (R − h) θ' of a disc that
turns about an edge.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.operations import count_operations
from lagrange.mechanics.limits import LONGEST_RATIO, SHORTEST_BY_VELOCITY

Values = Mapping[sp.Symbol, sp.Expr]


def by_one_velocity(velocities: Values) -> dict[sp.Symbol, sp.Expr]:
    """The velocities, first the one by which others are written: the shortest that differs from zero."""
    moving = [v for v, value in velocities.items() if value != 0]
    if len(moving) < 2 or max(count_operations(velocities[v]) for v in moving) < SHORTEST_BY_VELOCITY:
        return {**velocities}
    first = min(moving, key=lambda v: count_operations(velocities[v]))
    shorter = dict(_multiples(first, velocities[first], velocities))
    return {**velocities} if shorter == {**velocities} else {first: velocities[first]} | shorter


def _multiples(velocity: sp.Symbol, known: sp.Expr, values: Values) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    for name, value in values.items():
        if (
            name == velocity
            or count_operations(value) < SHORTEST_BY_VELOCITY
            or count_operations(value) > LONGEST_RATIO
        ):
            yield name, value
            continue
        ratio = sp.factor(sp.cancel(value / known))
        multiple = ratio * velocity
        exact = is_zero(ratio * known - value) is True
        yield name, multiple if exact and 3 * count_operations(multiple) <= 2 * count_operations(value) else value
