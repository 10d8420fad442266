"""What coordinates are in a picture: angles and distances, recognised by what they do.

Where one coordinate is changed and the others are not, a point moves on a circle, by as much as the coordinate changes,
or on a straight line, as far as it changes:

    r(q + δ) = c + A cos δ + B sin δ ,  |A| = |B|, A·B = 0 :  an angle at c, from where q = 0
    r(q + δ) = r(q) + δ e ,  |e| = 1 :                         a distance along e, from where q = 0

What is neither is not marked.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.pictures.floats import NoValueError, Space, inner, minus, plus
from lagrange.pictures.poses import Pose

_SAME = 1e-7
_STEPS = (0.7, -1.1, 2.3)


@record
class AngleMark:
    """An angle at `centre` from the direction `reference` (where q = 0) to the point.

    arc  directions between, from the reference to the point
    """

    coordinate: sp.Symbol
    centre: Space
    point: Space
    arc: tuple[Space, ...]

    @property
    def reference(self) -> Space:
        """The direction from which it is counted."""
        return self.arc[0]


@record
class DistanceMark:
    """A distance from `start` to `end`."""

    coordinate: sp.Symbol
    start: Space
    end: Space


def angle_mark(pose: Pose, coordinate: sp.Symbol, position: Vector) -> AngleMark | None:
    """The angle that a coordinate is for a point; None where it is none. Raises NoValueError."""
    here, there = pose.at(position), pose.moved(coordinate, math.pi).at(position)
    centre = plus(here, minus(there, here), 0.5)
    a = minus(here, centre)
    b = minus(pose.moved(coordinate, math.pi / 2).at(position), centre)
    if math.hypot(*a) < 1e-3 or abs(inner(a, a) - inner(b, b)) > _SAME or abs(inner(a, b)) > _SAME:
        return None

    def expected(step: float) -> Space:
        return plus(plus(centre, a, math.cos(step)), b, math.sin(step))

    for step in _STEPS:
        if math.hypot(*minus(pose.moved(coordinate, step).at(position), expected(step))) > _SAME:
            return None
    q = pose.values[coordinate]
    if not 0.05 < abs(q) < math.pi:
        return None
    arc = tuple(minus(expected(-q + q * k / 20), centre) for k in range(21))
    return AngleMark(coordinate, centre, here, arc)


def relative_angle_mark(pose: Pose, coordinate: sp.Symbol, position: Vector, origin: Vector) -> AngleMark | None:
    """The same for the line from one moving point to another. Raises NoValueError."""
    mark = angle_mark(pose, coordinate, position.fixed() - origin.fixed())
    if mark is None or math.hypot(*mark.centre) > _SAME:
        return None
    here = pose.at(origin)
    return AngleMark(coordinate, here, plus(here, mark.point), mark.arc)


def is_distance(pose: Pose, coordinate: sp.Symbol, position: Vector) -> bool:
    """Whether a point moves on a straight line, as far as a coordinate changes. Raises NoValueError."""
    here = pose.at(position)
    way = minus(pose.moved(coordinate, 1.0).at(position), here)
    if abs(math.hypot(*way) - 1) > _SAME:
        return False
    steps = (minus(pose.moved(coordinate, s).at(position), plus(here, way, s)) for s in _STEPS)
    return all(math.hypot(*s) < _SAME for s in steps)


def crosswise(marks: Sequence[DistanceMark]) -> list[DistanceMark]:
    """The first two steps of a way, each drawn from where it meets the other's axis: so those of two points differ."""
    if len(marks) < 2:
        return list(marks)
    first, second, *others = marks
    way = minus(second.end, second.start)
    moved = DistanceMark(first.coordinate, plus(first.start, way), plus(first.end, way))
    return [moved, second, *others]


def distance_marks(
    pose: Pose, coordinates: Sequence[sp.Symbol], position: Vector, known: Iterable[Space]
) -> list[DistanceMark]:
    """The way to a point in steps, one for each of its distances; none where it does not begin at a known place."""
    distances = []
    for q in coordinates:
        try:
            if is_distance(pose, q, position) and abs(pose.values[q]) > 1e-3:
                distances.append(q)
        except NoValueError:
            continue
    if not distances:
        return []
    start = pose.with_zero(distances).at(position)
    on_axis = sum(abs(c) > _SAME for c in start) <= 1
    if not on_axis and all(math.hypot(*minus(start, k)) > 1e-6 for k in known):
        return []
    found = []
    for n, q in enumerate(distances):
        end = pose.with_zero(distances[n + 1 :]).at(position)
        found.append(DistanceMark(q, start, end))
        start = end
    return found
