"""A picture being drawn: lines, dots and labels that are still to be placed; springs, arcs and arrows as lines."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import sympy as sp

from lagrange.document.math_writer import Notation
from lagrange.document.scene import Dot, Kind, Line, Point, Scene
from lagrange.pictures.labels import Wanted, placed

PARTICLE = 0.085
HINGE = 0.06


def toward(a: Point, b: Point) -> Point:
    """The unit vector from a to b; to the right where they are the same."""
    x, y = b[0] - a[0], b[1] - a[1]
    size = math.hypot(x, y)
    return (x / size, y / size) if size > 1e-9 else (1.0, 0.0)


def beyond(a: Point, direction: Point, by: float) -> Point:
    """a + by · direction."""
    return a[0] + by * direction[0], a[1] + by * direction[1]


def left_of(direction: Point) -> Point:
    """A direction turned by a right angle, counterclockwise."""
    return -direction[1], direction[0]


def along(a: Point, b: Point, part: float) -> Point:
    """A point between a and b."""
    return a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])


def apart(a: Point, b: Point) -> float:
    """Their distance."""
    return math.hypot(a[0] - b[0], a[1] - b[1])


def scaled(way: Point, by: float) -> Point:
    """A vector made longer."""
    return way[0] * by, way[1] * by


def same_ends(a: tuple[Point, ...], b: tuple[Point, ...]) -> bool:
    """Whether two pieces are the same."""
    straight = apart(a[0], b[0]) + apart(a[1], b[1])
    turned = apart(a[0], b[1]) + apart(a[1], b[0])
    return min(straight, turned) < 1e-3


def overlapping(a: tuple[Point, Point], b: tuple[Point, Point]) -> bool:
    """Whether one piece is on the line of the other, and they overlap."""
    way = toward(*a)
    side = left_of(way)

    def off(p: Point) -> float:
        return (p[0] - a[0][0]) * side[0] + (p[1] - a[0][1]) * side[1]

    def on(p: Point) -> float:
        return (p[0] - a[0][0]) * way[0] + (p[1] - a[0][1]) * way[1]

    if max(abs(off(p)) for p in b) > 1e-3:
        return False
    low, high = sorted(on(p) for p in b)
    return low < apart(*a) - 1e-3 and high > 1e-3


def touches(at: Point, a: Point, b: Point) -> bool:
    """Whether a point is an end of a piece."""
    return min(apart(at, a), apart(at, b)) < 0.02


def in_line(centre: Point, others: list[Point]) -> bool:
    """Whether points are on a line with the first."""
    far = max(others, key=lambda p: apart(centre, p))
    if apart(centre, far) < 1e-6:
        return False
    side = left_of(toward(centre, far))
    return all(abs((p[0] - centre[0]) * side[0] + (p[1] - centre[1]) * side[1]) < 0.06 for p in others)


def farthest(points: list[Point]) -> tuple[Point, Point]:
    """The two points that are farthest apart."""
    pairs = [(a, b) for a in points for b in points]
    return max(pairs, key=lambda p: apart(*p))


@dataclass
class Sketch:
    """What is drawn so far."""

    lines: list[Line] = field(default_factory=list)
    dots: list[Dot] = field(default_factory=list)
    wanted: list[Wanted] = field(default_factory=list)

    def line(self, points: Sequence[Point], kind: Kind, closed: bool = False) -> None:
        """A chain of straight pieces."""
        self.lines.append(Line(tuple(points), kind, closed))

    def arrow(self, start: Point, end: Point, kind: Kind, double: bool = False) -> None:
        """An arrow."""
        self.lines.append(Line((start, end), kind, tip=True, double=double))

    def arc(self, points: Sequence[Point], kind: Kind, tip: bool = True) -> None:
        """An arc through these points, with a tip."""
        self.lines.append(Line(tuple(points), kind, tip=tip))

    def dot(self, at: Point, radius: float = PARTICLE, open_: bool = False) -> None:
        """A particle."""
        self.dots.append(Dot(at, radius, open_))

    def label(
        self, content: sp.Expr | str, at: Point, prefer: Point, clear: float = 0.0, optional: bool = False
    ) -> None:
        """A label near a point."""
        self.wanted.append(Wanted(content, ((at, prefer),), clear, optional))

    def label_beside(
        self, content: sp.Expr | str, a: Point, b: Point, optional: bool = False, clear: float = 0.0
    ) -> None:
        """A label beside the line from a to b."""
        side = left_of(toward(a, b))
        other = (-side[0], -side[1])
        parts = (0.5, 0.4, 0.6, 0.3, 0.7)
        anchors = tuple((along(a, b, part), s) for part in parts for s in (side, other))
        self.wanted.append(Wanted(content, anchors, clear, optional))

    def scene(self, notation: Notation) -> Scene | None:
        """The picture; None where a label that is needed has no place."""
        labels = placed(self.wanted, self.lines, self.dots, notation)
        return None if labels is None else Scene(tuple(self.lines), tuple(self.dots), labels)

    # Things that are made of lines

    def spring(self, a: Point, b: Point) -> None:
        """A zigzag."""
        way, length = toward(a, b), apart(a, b)
        side = left_of(way)
        lead = min(0.25, length / 5)
        turns = max(4, min(12, round((length - 2 * lead) / 0.16)))
        step = (length - 2 * lead) / turns
        points = [a, beyond(a, way, lead)]
        for n in range(turns):
            middle = beyond(a, way, lead + (n + 0.5) * step)
            points.append(beyond(middle, side, 0.12 if n % 2 else -0.12))
        self.line([*points, beyond(a, way, length - lead), b], Kind.SPRING)

    def damper(self, a: Point, b: Point) -> None:
        """A piston in a cylinder."""
        way, length = toward(a, b), apart(a, b)
        side = left_of(way)
        cup, piston, end = (beyond(a, way, length * part) for part in (0.42, 0.52, 0.62))
        self.line([a, cup], Kind.DAMPER)
        self.line(
            [beyond(end, side, 0.14), beyond(cup, side, 0.14), beyond(cup, side, -0.14), beyond(end, side, -0.14)],
            Kind.DAMPER,
        )
        self.line([beyond(piston, side, 0.09), beyond(piston, side, -0.09)], Kind.DAMPER)
        self.line([piston, b], Kind.DAMPER)

    def wall(self, at: Point, inward: Point, half: float = 0.4) -> None:
        """A short wall through a point, hatched on its far side; `inward` points away from it."""
        side = left_of(inward)
        self.line([beyond(at, side, -half), beyond(at, side, half)], Kind.GROUND)
        count = max(2, round(half / 0.1))
        for n in range(count):
            start = beyond(at, side, -half + (n + 1) * 2 * half / count)
            self.line([start, beyond(beyond(start, inward, -0.13), side, -0.13)], Kind.GROUND)

    def capsule(self, a: Point, b: Point, half: float) -> None:
        """A bar with round ends from a to b."""
        way = toward(a, b)
        turn = math.atan2(way[1], way[0])
        ends = [(b, turn - math.pi / 2), (a, turn + math.pi / 2)]
        points = [
            (x + half * math.cos(start + k * math.pi / 8), y + half * math.sin(start + k * math.pi / 8))
            for (x, y), start in ends
            for k in range(9)
        ]
        self.line(points, Kind.BODY, closed=True)

    def ellipse(self, centre: Point, first: Point, second: Point, kind: Kind = Kind.BODY) -> None:
        """An ellipse with two conjugate half axes, given as vectors."""
        angles = [2 * math.pi * k / 48 for k in range(48)]
        points = [
            (
                centre[0] + math.cos(a) * first[0] + math.sin(a) * second[0],
                centre[1] + math.cos(a) * first[1] + math.sin(a) * second[1],
            )
            for a in angles
        ]
        self.line(points, kind, closed=True)

    def turning(self, centre: Point, radius: float, counterclockwise: bool, kind: Kind, start: float = -0.6) -> Point:
        """The curved arrow of a moment; returns its middle."""
        sign = 1 if counterclockwise else -1
        begin = start if counterclockwise else math.pi - start
        angles = [begin + sign * k * 1.5 * math.pi / 24 for k in range(25)]
        points = [beyond(centre, (math.cos(a), math.sin(a)), radius) for a in angles]
        self.arc(points, kind)
        return points[12]
