"""A question answered at several random points, and the answer that they agree on."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

import sympy as sp

from lagrange.exact import NoPointError, Point, Surface, UnsupportedError

T = TypeVar("T")

POINTS = 3
BRANCHING_POINTS = 6
REAL_POINTS = 2
REAL_POINTS_WHERE_BRANCHES_DIFFER = 16


def agreed(
    surface: Surface,
    evaluate: Callable[[Point], T],
    expressions: Iterable[sp.Expr],
    settles: Callable[[T], bool] = lambda _: False,
) -> T | None:
    """What `evaluate` returns at random points of a surface, if all agree; None where they do not: undecided.

    expressions  those that it evaluates
    settles      whether one real point with this result is enough, as a counterexample is

    Where the expressions have branches (roots, absolute values) a prime field picks them at random, so that more points
    are taken, and points with real values must agree with them. Where those in the field differ among themselves, the
    real ones decide, as many as it takes to meet the branches. Raises DivisionByZeroError.
    """
    try:
        marks = 0
        for e in expressions:
            marks |= surface.graph.marks[surface.graph.node(e)]
        found = surface.sampled(evaluate, BRANCHING_POINTS if marks else POINTS)
        if marks:
            same = _unanimous(found)
            real = surface.sampled(evaluate, REAL_POINTS if same else REAL_POINTS_WHERE_BRANCHES_DIFFER, real=True)
            for result in real:
                if settles(result):
                    return result
            found = [*real, *(found if same else [])]
        return found[0] if _unanimous(found) else None
    except (NoPointError, UnsupportedError):
        return None


def _unanimous(found: list[T]) -> bool:
    return all(f == found[0] for f in found)
