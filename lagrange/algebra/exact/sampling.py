"""A question answered at several random points, and the answer that they agree on."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import islice
from typing import TypeVar

import sympy as sp

from lagrange.algebra.exact.branches import Branches
from lagrange.algebra.exact.exact import NoPointError, Point, Surface, UnsupportedError

T = TypeVar("T")

POINTS = 3
BRANCHING_POINTS = 6
MOST_BRANCHING_POINTS = 80
FEW_SIGNS = 3
POINTS_OF_MANY_SIGNS = 20
REAL_POINTS = 2
REAL_POINTS_WHERE_BRANCHES_DIFFER = 48
"""What is wrong where two signs are negative is so at a quarter of all points."""


def agreed(
    surface: Surface,
    evaluate: Callable[[Point], T],
    expressions: Iterable[sp.Expr],
    settles: Callable[[T], bool] = lambda _: False,
    there: Callable[[Point], Point] = lambda point: point,
) -> T | None:
    """What `evaluate` returns at random points of a surface, if all agree; None where they do not: undecided.

    expressions  those that it evaluates
    settles      whether one real point with this result is enough, as a counterexample is
    there        what is made of a point before it is evaluated: a state of motion

    Where the expressions have branches (roots, absolute values) a prime field picks them at random, so that points are
    taken until all signs have been met, and points with real values must agree with them. Where those in the field
    differ among themselves, the real ones decide, as many as it takes to meet the branches. Raises DivisionByZeroError.
    """
    try:
        nodes = [surface.graph.node(e) for e in expressions]
        if not any(surface.graph.marks[n] for n in nodes):
            return _common(surface.sampled(lambda p: evaluate(there(p)), POINTS))
        found = _on_branches(surface, evaluate, nodes, there)
        same = _unanimous(found)
        number = REAL_POINTS if same else REAL_POINTS_WHERE_BRANCHES_DIFFER
        real = []
        for result in islice(surface.results(lambda p: evaluate(there(p)), real=True), number):
            if settles(result):
                return result
            real.append(result)
        return _common([*real, *(found if same else [])])
    except (NoPointError, UnsupportedError):
        return None


def _on_branches(
    surface: Surface, evaluate: Callable[[Point], T], nodes: list[int], there: Callable[[Point], Point]
) -> list[T]:
    """What is found at points that meet all signs, or until two of them differ.

    Of many signs each is met both ways, but not each with every other one: a term of a sum depends on its own.
    """
    if not surface.exact:
        return surface.sampled(lambda p: evaluate(there(p)), REAL_POINTS_WHERE_BRANCHES_DIFFER)
    before: list[T] = []

    def go_on(result: T) -> bool:
        before.append(result)
        return _unanimous(before)

    found, _ = surface.on_all_branches(nodes, evaluate, go_on, there, _are_enough)
    if _unanimous(found) and len(found) < BRANCHING_POINTS:
        found += surface.sampled(lambda p: evaluate(there(p)), BRANCHING_POINTS - len(found))
    return found


def _are_enough(branches: Branches) -> bool:
    if branches.signs <= FEW_SIGNS:
        return branches.met >= MOST_BRANCHING_POINTS
    return branches.met >= POINTS_OF_MANY_SIGNS or (branches.met >= BRANCHING_POINTS and branches.each_met)


def _common(found: list[T]) -> T | None:
    return found[0] if _unanimous(found) else None


def _unanimous(found: list[T]) -> bool:
    return all(f == found[0] for f in found)
