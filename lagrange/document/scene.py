"""A picture as data, in page coordinates: centimetres to the right and up.

Three shapes suffice: lines (curves are chains of short straight pieces), dots and labels. The kind of a line says
what it represents, and each renderer draws a kind in its own way. A label is mathematics or a word, placed by its
centre; its size is an estimate, too large rather than too small.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from enum import StrEnum
from itertools import pairwise

import sympy as sp

from lagrange.core.records import record

PagePoint = tuple[float, float]
"""x to the right and y up, in centimetres."""

MARGIN = 0.12
"""White space around a picture, so that the edge does not cut a line in two along its length."""


class StrokeKind(StrEnum):
    """The meaning of a line in a picture."""

    ROD = "rod"  # a distance that is kept
    STRING = "string"
    LINK = "link"  # a distance that the coordinates keep by themselves
    BODY = "body"  # the outline of a rigid body
    FACE = "face"  # a piece of a surface, without an outline
    GRID = "grid"  # a line on a surface
    CURVE = "curve"  # a curve on which a particle is kept
    SPRING = "spring"
    DAMPER = "damper"
    GROUND = "ground"  # what does not move
    HATCH = "hatch"  # the strokes behind it
    GUIDE = "guide"  # a coordinate, dashed
    REFERENCE = "reference"  # the direction from which an angle is counted, dashed
    DIMENSION = "dimension"  # a length
    ANGLE = "angle"  # the arc of an angle
    AXIS = "axis"  # a unit vector
    FORCE = "force"  # an applied force or moment
    REACTION = "reaction"  # that of a constraint


FAINT = frozenset({StrokeKind.FACE, StrokeKind.GRID})
"""What a label may be written on."""


@record
class Box:
    """A rectangle: left, bottom, right, top."""

    left: float
    bottom: float
    right: float
    top: float

    @classmethod
    def around(cls, points: Iterable[PagePoint]) -> Box:
        """The smallest box around one or more points."""
        xs, ys = zip(*points, strict=True)
        return cls(min(xs), min(ys), max(xs), max(ys))

    @property
    def width(self) -> float:
        """From left to right."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From bottom to top."""
        return self.top - self.bottom

    @property
    def corners(self) -> tuple[PagePoint, PagePoint]:
        """Lower left and upper right."""
        return (self.left, self.bottom), (self.right, self.top)

    def grown(self, by: float) -> Box:
        """The box with a margin."""
        return Box(self.left - by, self.bottom - by, self.right + by, self.top + by)

    def overlaps(self, other: Box) -> bool:
        """Whether the two boxes have an area in common."""
        beside = self.right <= other.left or other.right <= self.left
        return not (beside or self.top <= other.bottom or other.top <= self.bottom)

    def is_crossed(self, a: PagePoint, b: PagePoint) -> bool:
        """Whether the straight line from a to b has a point in the box (Liang and Barsky 1984)."""
        first, last = 0.0, 1.0
        sides = ((self.left, self.right), (self.bottom, self.top))
        for start, end, (low, high) in zip(a, b, sides, strict=True):
            way = end - start
            if way == 0:
                if not low <= start <= high:
                    return False
                continue
            enters, leaves = sorted(((low - start) / way, (high - start) / way))
            first, last = max(first, enters), min(last, leaves)
        return first <= last


@record
class Polyline:
    """A chain of straight pieces.

    closed  whether it ends where it begins
    tip     whether it ends in the tip of an arrow
    double  whether that is the double tip of a moment
    shade   of its inside: 0 not filled, 1 the paper, then darker up to 4
    """

    points: tuple[PagePoint, ...]
    kind: StrokeKind
    closed: bool = False
    tip: bool = False
    double: bool = False
    shade: int = 0

    @property
    def pieces(self) -> list[tuple[PagePoint, PagePoint]]:
        """The straight pieces."""
        around = (*self.points, self.points[0]) if self.closed else self.points
        return list(pairwise(around))


@record
class Dot:
    """A particle, or a hinge where it is open."""

    at: PagePoint
    radius: float
    open: bool = False


@record
class Label:
    """Mathematics or a word with its middle at a place."""

    content: sp.Expr | str
    at: PagePoint
    width: float
    height: float

    @property
    def box(self) -> Box:
        """The area that it covers."""
        x, y = self.at
        return Box(x - self.width / 2, y - self.height / 2, x + self.width / 2, y + self.height / 2)


@record
class Scene:
    """A picture."""

    lines: tuple[Polyline, ...]
    dots: tuple[Dot, ...]
    labels: tuple[Label, ...]

    @property
    def box(self) -> Box:
        """The area of the whole picture, with a margin."""
        corners = [p for line in self.lines for p in line.points]
        for d in self.dots:
            (x, y), r = d.at, d.radius
            corners += [(x - r, y - r), (x + r, y + r)]
        for label in self.labels:
            corners += label.box.corners
        return Box.around(corners).grown(MARGIN)

    def moved(self, by: PagePoint) -> Scene:
        """The scene translated by a vector."""

        def shifted(p: PagePoint) -> PagePoint:
            return p[0] + by[0], p[1] + by[1]

        return Scene(
            tuple(replace(line, points=tuple(map(shifted, line.points))) for line in self.lines),
            tuple(replace(d, at=shifted(d.at)) for d in self.dots),
            tuple(replace(label, at=shifted(label.at)) for label in self.labels),
        )


def side_by_side(scenes: Iterable[Scene], width: float, gap: float = 0.8) -> Scene:
    """Scenes in centred rows, none wider than `width`."""
    rows: list[list[Scene]] = []
    used = 0.0
    for scene in scenes:
        wide = scene.box.width
        if rows and used + gap + wide <= width:
            rows[-1].append(scene)
            used += gap + wide
        else:
            rows.append([scene])
            used = wide
    placed: list[Scene] = []
    top = 0.0
    for row in rows:
        x = -(sum(s.box.width for s in row) + gap * (len(row) - 1)) / 2
        lowest = min(s.box.bottom for s in row)
        highest = max(s.box.top for s in row)
        for s in row:
            placed.append(s.moved((x - s.box.left, top - highest)))
            x += s.box.width + gap
        top -= highest - lowest + gap / 2
    return Scene(
        tuple(line for s in placed for line in s.lines),
        tuple(d for s in placed for d in s.dots),
        tuple(label for s in placed for label in s.labels),
    )
