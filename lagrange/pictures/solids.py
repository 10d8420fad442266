"""The shapes of bodies, and circles, from the viewpoint of the picture.

A circle with radius R about the axis a is R (u cos s + v sin s) with u, v perpendicular to a: on the page an ellipse. A
sphere is a circle with its equator, of which the half that is hidden is dashed. A cone is the convex hull of its tip
and its rim. Insides are filled lightly, so that they hide what is behind them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from lagrange.core.records import record
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.pictures.floats import FloatVector, inner, outer, plus, unit
from lagrange.pictures.sketch import BAR, Sketch, apart, beyond
from lagrange.pictures.systems import SystemPicture
from lagrange.problem.keys import Outline
from lagrange.problem.model import BodyShape

LIGHT, MEDIUM = 2, 3
"""Shades of insides."""
TURN = [2 * math.pi * k / 48 for k in range(49)]


@record
class Solids:
    """Draws solid things into a sketch."""

    system: SystemPicture
    sketch: Sketch

    def depth(self, place: FloatVector) -> float:
        """How near a place is to the reader."""
        return 0.0 if self.system.view.planar else inner(place, self.system.view.toward_reader)

    def ring(self, centre: FloatVector, axis: FloatVector, radius: float) -> list[FloatVector]:
        """The points of a circle."""
        u, v = across(axis)
        return [plus(plus(centre, u, radius * math.cos(s)), v, radius * math.sin(s)) for s in TURN[:-1]]

    def disc(
        self,
        centre: FloatVector,
        axis: FloatVector | None,
        radius: float,
        shade: int,
        kind: StrokeKind = StrokeKind.BODY,
    ) -> None:
        """A disc; in the plane of the page where it has no axis."""
        page = self.system.page
        if axis is None or self.system.view.planar:
            self.sketch.circle(page(centre), radius * page.scale, shade, kind)
            return
        self.sketch.face([page(p) for p in self.ring(centre, axis, radius)], shade, self.depth(centre), kind)

    def sphere(self, centre: FloatVector, radius: float) -> None:
        """A sphere with its equator."""
        page = self.system.page
        size = radius * page.scale
        self.sketch.face(
            [beyond(page(centre), (math.cos(s), math.sin(s)), size) for s in TURN], LIGHT, self.depth(centre)
        )
        if self.system.view.planar:
            return
        view = self.system.view.toward_reader
        front: list[PagePoint] = []
        back: list[PagePoint] = []
        upright = (0.0, 0.0, 1.0) if abs(self.system.view.units[2][1]) > 0.5 else (0.0, 1.0, 0.0)
        circle = self.ring(centre, upright, radius)
        start = min(range(len(circle)), key=lambda n: _depth(circle[n], circle[n - 1], centre, view))
        for p in (*circle[start:], *circle[: start + 1]):
            way = plus(p, centre, -1.0)
            (front if inner(way, view) >= 0 else back).append(page(p))
        for points, kind in ((front, StrokeKind.GRID), (back, StrokeKind.REFERENCE)):
            for run in _runs(points, size):
                self.sketch.line(run, kind)

    def box(self, corners: Sequence[FloatVector], shade: int = LIGHT) -> None:
        """A flat outline."""
        middle = tuple(sum(c[n] for c in corners) / len(corners) for n in range(3))
        self.sketch.face([self.system.page(c) for c in corners], shade, self.depth(middle))  # type: ignore[arg-type]

    def cone(self, tip: FloatVector, axis: FloatVector, radius: float, height: float) -> None:
        """A cone standing on its tip, with its rim."""
        page = self.system.page
        base = plus(tip, unit(axis), height)
        if self.system.view.planar:
            side = outer((0.0, 0.0, 1.0), unit(axis))
            self.box([tip, plus(base, side, radius), plus(base, side, -radius)])
            return
        rim = [page(p) for p in self.ring(base, axis, radius)]
        self.sketch.face(hull([page(tip), *rim]), LIGHT, self.depth(tip))
        self.sketch.face(rim, MEDIUM, self.depth(base) + 1e-3)

    def shape(self, shape: BodyShape, centre: FloatVector, axes: Sequence[FloatVector], symmetric: int = 2) -> None:
        """A body with its mass centre and its three axes, of which one may be an axis of symmetry."""
        e1, e2, e3 = axes
        round_ = axes[symmetric] if shape.axis is None else unit(self.system.at(shape.axis))
        if shape.axis is not None:
            e3 = unit(self.system.at(shape.axis))
            e1, e2 = across(e3)
            if shape.kind is Outline.BOX and self.system.view.planar:
                e1, e2 = e3, outer((0.0, 0.0, 1.0), e3)
        lengths = [abs(self.system.number(x)) for x in shape.lengths]
        page = self.system.page
        match shape.kind:
            case Outline.DISC:
                self.disc(centre, round_, lengths[0], LIGHT)
            case Outline.RING:
                self.disc(centre, round_, lengths[0], 1)
                self.disc(centre, round_, lengths[0] * 0.93, 1)
            case Outline.ROD:
                a, b = (self.system.at(end) for end in shape.ends)
                if self.system.view.planar:
                    self.sketch.capsule(page(a), page(b), BAR)
                else:
                    self.sketch.line([page(a), page(b)], StrokeKind.ROD)
            case Outline.BOX:
                half = [x / 2 for x in lengths]
                signs = ((1, 1), (-1, 1), (-1, -1), (1, -1))
                self.box([plus(plus(centre, e1, s * half[0]), e2, r * half[1]) for s, r in signs])
            case Outline.SPHERE:
                self.sphere(centre, lengths[0])
            case Outline.CONE:
                upward = e2 if self.system.view.planar and shape.axis is None else round_
                self.cone(plus(centre, unit(upward), -0.75 * lengths[1]), upward, *lengths)


def across(axis: FloatVector) -> tuple[FloatVector, FloatVector]:
    """Two unit vectors perpendicular to an axis and to each other."""
    a = unit(axis)
    least = min(range(3), key=lambda n: abs(a[n]))
    helper = tuple(1.0 if n == least else 0.0 for n in range(3))
    u = unit(outer(helper, a))  # type: ignore[arg-type]
    return u, outer(a, u)


def hull(points: Sequence[PagePoint]) -> list[PagePoint]:
    """The convex hull, counterclockwise (Andrew 1979)."""
    ordered = sorted(set(points))

    def chain(some: Sequence[PagePoint]) -> list[PagePoint]:
        kept: list[PagePoint] = []
        for p in some:
            while len(kept) > 1 and _turn(kept[-2], kept[-1], p) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return [*chain(ordered), *chain(ordered[::-1])]


def _turn(a: PagePoint, b: PagePoint, c: PagePoint) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _depth(p: FloatVector, before: FloatVector, centre: FloatVector, view: FloatVector) -> float:
    """Least where a circle comes to the front: hidden before, visible now."""
    now, then = inner(plus(p, centre, -1.0), view), inner(plus(before, centre, -1.0), view)
    return 0.0 if then < 0 <= now else 1.0


def _runs(points: Sequence[PagePoint], size: float) -> list[list[PagePoint]]:
    """The points in chains without gaps."""
    runs: list[list[PagePoint]] = []
    for p in points:
        if runs and apart(runs[-1][-1], p) < 0.5 * size:
            runs[-1].append(p)
        else:
            runs.append([p])
    return [r for r in runs if len(r) > 1]
