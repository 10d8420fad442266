"""Real points on both sides of where a sign changes.

|a| = a holds where a > 0, and random points may all lie there: |x − 1000| = 1000 − x for all small x. So before
something is called zero for all real values, the places where the signs in it change are looked for, by the secant
rule along random lines,

    s_{n+1} = s_n − a(s_n) (s_n − s_{n−1})/(a(s_n) − a(s_{n−1})),

and points close by on either side are tried too. The lines are q + s v, with one symbol moving or all of them. A
sign that changes only in a small region is met at an extremum of a: parabolas through three points lead there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.reals import RealPoint

_STEPS = 40
_FARTHEST = 10**7
_MOST_LINES = 3
_ROUNDS = 3


def points_beside_walls(start: RealPoint, wall: int, symbols: Sequence[sp.Symbol]) -> Iterator[Point]:
    """Points on either side of places where the node `wall` is zero, near lines through a point.

    symbols  what may be moved; only those of the node are
    """
    moving = [s for s in symbols if start.graph.symbols[wall] & start.graph.bit(s)]
    lines = [[s] for s in moving[:_MOST_LINES]]
    if len(moving) > 1:
        lines.append(moving)
    for line in lines:
        yield from _beside(start, wall, {s: start.random() for s in line})
    yield from _towards_extremum(start, wall, moving)


def _towards_extremum(start: RealPoint, wall: int, symbols: Sequence[sp.Symbol]) -> Iterator[Point]:
    """The point, moved to where parabolas have their vertices, one symbol after the other."""
    point: Point = start
    h = start.number(1, 100)
    for _ in range(_ROUNDS):
        for symbol in symbols:
            direction = {symbol: start.number(1)}
            try:
                below, here, above = (_moved(point, direction, s).at(wall) for s in (-h, start.number(0), h))
                curvature = below - 2 * here + above
                if curvature:
                    point = _moved(point, direction, h * (below - above) / (2 * curvature))
            except InadmissibleError:
                continue
        yield point


def _beside(start: RealPoint, wall: int, direction: dict[sp.Symbol, Any]) -> Iterator[Point]:
    try:
        place = _zero_along(start, wall, direction)
    except InadmissibleError:
        return
    if place is None:
        return
    step = (1 + abs(place)) / 1000
    for s in (place - step, place + step):
        try:
            yield _moved(start, direction, s)
        except InadmissibleError:
            continue


def _zero_along(start: RealPoint, wall: int, direction: dict[sp.Symbol, Any]) -> Any:
    """Where the node is zero along a line, or None."""
    s, last = start.number(0), start.number(1, 7)
    value, last_value = (_moved(start, direction, x).at(wall) for x in (s, last))
    for _ in range(_STEPS):
        if abs(value) < start.number(1, 10**12):
            return s
        if value == last_value:
            return None
        s, last = s - value * (s - last) / (value - last_value), s
        value, last_value = _moved(start, direction, s).at(wall), value
    return s if abs(value) < start.number(1, 10**6) else None


def _moved(start: Point, direction: dict[sp.Symbol, Any], s: Any) -> Point:
    """The point at parameter s of the line. Raises InadmissibleError far away, or for a wrong sign."""
    if abs(s) > _FARTHEST:
        raise InadmissibleError
    values = {symbol: start.input(symbol) + s * v for symbol, v in direction.items()}
    if any(symbol.is_positive and value <= 0 for symbol, value in values.items()):
        raise InadmissibleError
    return start.with_values(values)
