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


def agreed(surface: Surface, evaluate: Callable[[Point], T], expressions: Iterable[sp.Expr]) -> T | None:
    """What `evaluate` returns at random points of a surface, if all agree; None where they do not: undecided.

    `expressions` are those that it evaluates. Where they have branches (roots, absolute values) a prime field picks
    them at random, so that more points are taken, and points with real values must agree with them. Where those in
    the field differ among themselves, the real ones decide. Raises DivisionByZeroError.
    """
    try:
        marks = 0
        for e in expressions:
            marks |= surface.graph.marks[surface.graph.node(e)]
        found = surface.sampled(evaluate, BRANCHING_POINTS if marks else POINTS)
        if marks:
            found = surface.sampled(evaluate, REAL_POINTS, real=True)[: len(found)] + (
                found if _unanimous(found) else []
            )
        return found[0] if _unanimous(found) else None
    except (NoPointError, UnsupportedError):
        return None


def _unanimous(found: list[T]) -> bool:
    return all(f == found[0] for f in found)
