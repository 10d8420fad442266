"""A question answered at several random points, and the answer that they agree on."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import TypeVar

import sympy as sp

from lagrange.exact import NoPointError, Point, Surface, UnsupportedError

T = TypeVar("T")

POINTS = 3
BRANCHING_POINTS = 6
CHANCES = 24
"""Points for a sign that each takes at random: half of them miss what is so on one side only. Twice as many for two
signs, four times for more."""
REAL_POINTS = 2


def agreed(
    surface: Surface,
    evaluate: Callable[[Point], T],
    expressions: Sequence[sp.Expr],
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
        branching = surface.graph.marked(surface.graph.node(e) for e in expressions)
        number = _points_on_branches(surface, expressions) if branching else POINTS
        first, same = _first_of_all(surface.results(evaluate), number)
        if not branching:
            return first if same else None
        real = surface.sampled(evaluate, REAL_POINTS if same else max(number, CHANCES), real=True)
        for result in real:
            if settles(result):
                return result
        found, same = _first_of_all(iter([*real, *([first] if same else [])]), len(real) + 1)
        return found if same else None
    except (NoPointError, UnsupportedError):
        return None


def _points_on_branches(surface: Surface, expressions: Sequence[sp.Expr]) -> int:
    """As many points as it takes to meet the branches."""
    if not surface.exact:
        return CHANCES
    signs = surface.random_signs(expressions)
    return CHANCES << min(signs - 1, 2) if signs else BRANCHING_POINTS


def _first_of_all(results: Iterator[T], number: int) -> tuple[T, bool]:
    """The first result, and whether the first so many are the same: none are looked at after one that differs."""
    first = next(results)
    return first, all(r == first for r in islice(results, number - 1))
