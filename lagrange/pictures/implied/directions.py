"""The unit vectors that a file names, at the points from which they lead on: e_r where a position is r e_r.

One that is i, j or k all the time, or that the file draws, is not drawn again; nor is one for which there is no room.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from lagrange.core.symbols import UnitVector
from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, Polyline, StrokeKind
from lagrange.pictures.floats import FloatVector, NoValueError, minus, outer
from lagrange.pictures.limits import SAME_PLACE
from lagrange.pictures.sketch import NEAR, LabelRequest, Sketch, beyond, overlapping, toward
from lagrange.pictures.systems import SystemPicture

LENGTH = 0.85
"""Of an arrow, in centimetres."""
_FORESHORTENED = 0.35
"""The least length of the image of a unit vector that can be drawn."""


def draw_directions(system: SystemPicture, sketch: Sketch, busy: Sequence[tuple[PagePoint, PagePoint]]) -> None:
    """An arrow for each unit vector of the file."""
    drawn = {str(m.label) for m in system.marks}
    places = {p.name: system.pose.at(p.position) for p in system.configuration.points if p.name not in system.hidden}
    for name, vector in system.problem.abbreviations.items():
        if not isinstance(vector, Vector) or name in drawn or not _is_turning_unit(system, vector):
            continue
        way = system.at(vector)
        requests = [*_requests(system, sketch, busy, name, way, [*places.values()])]
        if requests:
            first, *instead = requests
            sketch.wanted.append(replace(first, instead=tuple(instead)))


def _is_turning_unit(system: SystemPicture, vector: Vector) -> bool:
    """Whether a vector has the length 1 in every position, and not always the same direction."""
    with suppress(NoValueError):
        ways = [replace(system, pose=x).at(vector) for x in (system.pose, *system.pose.others)]
        turns = any(math.dist(ways[0], w) > SAME_PLACE for w in ways)
        return turns and all(abs(math.hypot(*w) - 1) < SAME_PLACE for w in ways)
    return False


def _requests(
    system: SystemPicture,
    sketch: Sketch,
    busy: Sequence[tuple[PagePoint, PagePoint]],
    name: str,
    way: FloatVector,
    places: Sequence[FloatVector],
) -> Iterator[LabelRequest]:
    """The arrow at each point, first where the point is in its direction from another one."""
    x, y = system.page.way(way)
    size = LENGTH * (1.0 if system.view.planar else math.hypot(x, y))
    if math.hypot(x, y) < _FORESHORTENED:
        return
    along = toward((0.0, 0.0), (x, y))
    every = [(0.0, 0.0, 0.0), *places]
    leads_on = [any(math.hypot(*outer(way, minus(p, o))) < SAME_PLACE < math.dist(p, o) for o in every) for p in every]
    for _, place in sorted(zip((not on for on in leads_on), every, strict=True), key=lambda pair: pair[0]):
        start = system.page(place)
        end = beyond(start, along, size)
        arrow = Polyline((start, end), StrokeKind.AXIS, tip=True)
        lines = [*busy, *(piece for line in sketch.lines if len(line.points) == 2 for piece in line.pieces)]
        if place == (0.0, 0.0, 0.0) or any(overlapping((start, end), other) for other in lines):
            continue
        yield LabelRequest(UnitVector(name), ((end, along),), optional=True, lines=(arrow,), reaches=NEAR)
