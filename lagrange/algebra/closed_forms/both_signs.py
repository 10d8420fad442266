"""Whether an expression takes both signs: decided at points, in a fraction of the time that its factors would take.

Two points with values of different signs show that an expression has no sign of its own. Values of one sign show
nothing: the factors must decide.
"""

from __future__ import annotations

from functools import lru_cache
from random import Random

import sympy as sp

from lagrange.algebra.closed_forms.limits import SHORTEST_TRIED, TRIED_POINTS
from lagrange.algebra.exact.expression_graph import DivisionByZeroError, Graph, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.real_points import RealPoint, Reals
from lagrange.core.operations import count_operations


@lru_cache(maxsize=1000)
def takes_both_signs(expression: sp.Expr, positive: tuple[sp.Expr, ...] = (), shortest: int = SHORTEST_TRIED) -> bool:
    """Whether an expression is seen to take both signs at points where each of `positive` is positive.

    shortest  the operations from which on points are tried: the factors of a shorter one are sooner at hand
    """
    if count_operations(expression) < shortest:
        return False
    graph, reals, seen = Graph(), Reals(Random(1)), set()
    for number in range(TRIED_POINTS):
        point = RealPoint(graph, reals, signs=number)
        try:
            if any(point.is_zero(p) or point.value(p) < 0 for p in positive):
                continue
            if not point.is_zero(expression):
                seen.add(bool(point.value(expression) > 0))
        except (InadmissibleError, DivisionByZeroError):
            continue
        except UnsupportedError:
            return False
        if len(seen) == 2:
            return True
    return False
