"""The coordinates in a picture of a system, and the distances that the coordinates keep by themselves.

What a coordinate measures is recognised by what it moves (`poses`): an angle at a point is an arc from its reference
direction; a distance is a dashed line, or a dimension line next to a line that is drawn already; the angle of a plane
body is an arc at its mass centre. In space, an angle about an axis is drawn in the plane of the origin.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import combinations

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, plus
from lagrange.pictures.implied.rods_at_rest import RodAtRest
from lagrange.pictures.inferred import STRINGS
from lagrange.pictures.limits import SAME_ON_PAGE
from lagrange.pictures.linkages import Links
from lagrange.pictures.poses import (
    AngleMark,
    DistanceMark,
    Pose,
    angle_mark,
    crosswise,
    direction_mark,
    distance_marks,
    notable,
    relative_angle_mark,
)
from lagrange.pictures.shapes import in_space, plane_rotation
from lagrange.pictures.sketch import Sketch, apart, beyond, in_line, left_of, overlapping, same_ends, toward
from lagrange.pictures.systems import ROD, SystemPicture
from lagrange.pictures.views import PaperMap
from lagrange.problem.model import Drawn

_RODS = (Drawn.RODS, Drawn.STRINGS)
ARC = 0.62
"""Radius of the arc of an angle, in centimetres."""


@dataclass
class CoordinateDrawings:
    """The coordinates of one picture.

    busy            pieces along which a line is drawn already
    places          of the particles and mass centres
    guides          dashed lines of angles
    feet            ends of distances, which may be on an axis
    turning_points  the coordinate and the point that turns, with the centre of its circle
    """

    system: SystemPicture
    sketch: Sketch
    busy: list[tuple[PagePoint, PagePoint]]
    places: dict[str, FloatVector]
    links: Links
    guides: list[tuple[PagePoint, PagePoint]] = field(default_factory=list)
    turning_points: list[tuple[tuple[sp.Symbol, MassPoint], FloatVector]] = field(default_factory=list)
    feet: list[PagePoint] = field(default_factory=list)

    @property
    def pose(self) -> Pose:
        """The position that is drawn."""
        return self.system.pose

    @property
    def page(self) -> PaperMap:
        """From space to the page."""
        return self.system.page

    def flat(self, place: FloatVector) -> PagePoint:
        """The image of a point of space on the page."""
        return self.page(place)

    def all(self) -> None:
        """Mark the coordinates. Raises NoValueError if one that moves a particle cannot be marked."""
        figure = self.system.problem.figure
        rest = [q for q in self.pose.coordinates if not self.is_length(q) and q.name not in self.system.hidden]
        ends = (self.pose.at(v) for v in notable(self.system.configuration))
        known: list[FloatVector] = [
            (0.0, 0.0, 0.0),
            *self.places.values(),
            *ends,
            *self.system.figure_places.values(),
        ]
        for q in list(rest):
            if self.angle_of_link(q) or self.angle(q):
                rest.remove(q)
        for p in self.system.marked_points:
            marks = distance_marks(self.pose, rest, p.position, known)
            for m in marks:
                rest.remove(m.coordinate)
            if marks and not self.system.view.planar:
                marks = self.on_the_floor(marks)
            for m in crosswise(marks):
                if len(marks) > 1 and math.hypot(*marks[0].start) > 1e-9:
                    self.sketch.line([self.flat(marks[0].start), self.flat(m.start)], StrokeKind.REFERENCE)
                self.distance(m.coordinate, m.start, m.end, len(marks) == 1)
        left = [q for q in rest if not self.turn(q)]
        bodies = bool(self.system.configuration.rotations)
        declared = figure.lines or figure.points or figure.curves or figure.hidden or self.system.paths
        if self.system.view.planar and not bodies and not declared:
            left = [q for q in left if self.moves_something(q) and not self.from_where_it_begins(q)]
            if left:
                raise NoValueError("a coordinate that cannot be marked")
        if "links" not in self.system.hidden and not any(line.kind in _RODS for line in figure.lines):
            self.stiff()

    def moves_something(self, q: sp.Symbol) -> bool:
        """Whether a coordinate alone moves a particle, and no constraint keeps it at 0."""
        if abs(self.pose.values[q]) < 1e-3:
            return False
        moved = self.pose.moved(q, 0.3)
        return any(
            math.dist(moved.at(p.position), self.places[p.name]) > 1e-9 for p in self.system.configuration.points
        )

    def from_where_it_begins(self, q: sp.Symbol) -> bool:
        """Mark a distance from a place that has no name, such as the top of a slope; return whether it is one."""
        for p in self.system.marked_points:
            for m in distance_marks(self.pose, [q], p.position, None):
                self.distance(q, m.start, m.end, True)
                return True
        return False

    def on_the_floor(self, marks: list[DistanceMark]) -> list[DistanceMark]:
        """The same distances at height 0, with a plumb line to the point, which is at a fixed height."""
        start, end = marks[0].start, marks[-1].end
        if math.hypot(*start) < 1e-9:
            return marks
        self.sketch.line([self.flat(end), self.flat(minus(end, start))], StrokeKind.GUIDE)
        self.feet.append(self.flat(minus(end, start)))
        return [DistanceMark(m.coordinate, minus(m.start, start), minus(m.end, start)) for m in marks]

    def is_length(self, q: sp.Symbol) -> bool:
        """Whether a coordinate is the length of a rod, which is labelled with it."""
        return any(rod.length == q for _, rod in self.system.rods)

    def angle_of_link(self, q: sp.Symbol) -> bool:
        """Mark the angle of a link where it begins; return whether it is one."""
        for name, ends in self.links.held.items():
            rotation = plane_rotation(self.system.configuration, name)
            if rotation is None or len(ends) != 2:
                continue
            mark = angle_mark(self.pose, q, rotation.axes[0])
            centre, end = map(self.flat, ends)
            if mark is None or math.hypot(*mark.centre) > 1e-9:
                continue
            ways = [toward((0, 0), self.page.way(a)) for a in mark.arc]
            if inner(ways[-1], toward(centre, end)) > 1 - 1e-9:
                self.arc(q, centre, ways, ARC + 0.25 * self.arcs_at(centre))
                return True
        return False

    def angle(self, q: sp.Symbol) -> bool:
        """Mark a coordinate if it is an angle at a point; return whether it is one."""
        swinging = [j.mark for j in self.system.swinging_joints if j.coordinate == q]
        if swinging and any(
            same_ends((self.flat(swinging[0].centre), self.flat(swinging[0].point)), b) for b in self.busy
        ):
            self.angle_at(swinging[0])
            return True
        of_rods = [m for rod in self.system.rods_at_rest if (m := self.at_lower_end(q, rod)) is not None]
        if of_rods:
            self.angle_at(of_rods[0])
            return True
        angles = [(p, m) for p in self.system.marked_points if (m := angle_mark(self.pose, q, p.position)) is not None]
        if angles:  # of two points on opposite sides of a centre, the one that is counted from the axis itself
            p, mark = max(angles, key=lambda f: round(sum(f[1].reference) / math.hypot(*f[1].reference), 6))
            self.angle_at(mark)
            self.turning_points.append(((q, p), mark.centre))
            return True
        turning = {r.name for r in self.system.configuration.rotations}
        points = [p for p in self.system.marked_points if p.name not in turning]
        for a, b in combinations(points, 2) if self.system.view.planar else ():
            marks = [
                relative_angle_mark(self.pose, q, *pair)
                for pair in ((b.position, a.position), (a.position, b.position))
            ]
            candidates = [m for m in marks if m is not None]
            if candidates:
                self.angle_at(max(candidates, key=lambda m: sum(m.reference)))
                return True
        return self.angle_of_spring(q)

    def angle_of_spring(self, q: sp.Symbol) -> bool:
        """Mark the angle of a spring from a fixed place whose length changes with it; return whether it is one."""
        positions = {p.name: p.position for p in self.system.configuration.points}
        for link in self.system.links if self.system.view.planar else ():
            for start, end in (link.ends, link.ends[::-1]):
                if isinstance(start, Vector) and isinstance(end, str):
                    mark = direction_mark(self.pose, q, positions[end], start)
                    if mark is not None:
                        self.angle_at(mark)
                        return True
        return False

    def at_lower_end(self, q: sp.Symbol, rod: RodAtRest) -> AngleMark | None:
        """The angle of a rod at rest, at the lower of its ends."""
        low, high = sorted(rod.ends, key=lambda end: self.flat(self.pose.at(end))[1])
        return relative_angle_mark(self.pose, q, high, low)

    def angle_at(self, mark: AngleMark) -> None:
        """An angle, with the line to its point if none is drawn yet."""
        if not self.system.view.planar:
            self.angle_in_space(mark)
            return
        centre, end = self.flat(mark.centre), self.flat(mark.point)
        length = apart(centre, end)
        radius = min(ARC + 0.25 * self.arcs_at(centre), 0.8 * length)
        ways = [toward((0, 0), self.page.way(a)) for a in mark.arc]
        if not any(overlapping((centre, end), b) for b in self.busy):
            self.sketch.line([centre, end], StrokeKind.GUIDE)
            self.busy.append((centre, end))
            self.guides.append((centre, end))
        self.arc(mark.coordinate, centre, ways, radius)

    def arcs_at(self, centre: PagePoint) -> int:
        """The number of arcs around a point."""
        arcs = [line for line in self.sketch.lines if line.kind is StrokeKind.ANGLE]
        return sum(
            abs(apart(centre, a.points[0]) - apart(centre, a.points[-1])) < 1e-6 and apart(centre, a.points[0]) < 1.6
            for a in arcs
        )

    def arc(self, q: sp.Symbol, centre: PagePoint, ways: list[PagePoint], radius: float) -> None:
        """The arc of an angle, its reference line and its label."""
        reference = beyond(centre, ways[0], radius + 0.35)
        self.sketch.line([centre, reference], StrokeKind.REFERENCE)
        points = [beyond(centre, w, radius) for w in ways]
        self.sketch.arc(points, StrokeKind.ANGLE)
        self.sketch.label(q, points[10], ways[10])

    def angle_in_space(self, mark: AngleMark) -> None:
        """An angle about an axis, drawn in the plane of O, or of a lettered point on that axis."""
        axis = outer(mark.arc[0], mark.arc[7])
        size = math.hypot(*axis)
        upright = [n for n in range(3) if abs(abs(axis[n]) / size - 1) < 1e-6]
        centre, point = mark.centre, mark.point
        anchors = [(0.0, 0.0, 0.0), *self.system.figure_places.values()]
        level = next(
            (a for a in anchors if all(abs(centre[m] - a[m]) < 1e-9 for m in range(3) if m not in upright)), None
        )
        if upright and level is not None and math.dist(centre, level) > 1e-6:
            foot = plus(level, minus(point, centre))
            self.sketch.line([self.flat(point), self.flat(foot)], StrokeKind.GUIDE)
            centre, point = level, foot
        if not upright or level is None:
            self.hanger(centre, point)
        self.guide(self.flat(centre), self.flat(point))
        radius = math.hypot(*minus(point, centre))
        part = min(0.8, ARC * 1.1 / (radius * self.page.scale))
        arc = [self.flat(plus(centre, a, part)) for a in mark.arc]
        self.sketch.line([self.flat(centre), self.flat(plus(centre, mark.reference, part * 1.3))], StrokeKind.REFERENCE)
        self.sketch.arc(arc, StrokeKind.ANGLE)
        self.sketch.label(mark.coordinate, arc[10], toward(self.flat(centre), arc[10]))

    def hanger(self, centre: FloatVector, point: FloatVector) -> None:
        """The chain or string on which a particle swings from an arm that goes around k, and that arm."""
        text, away = self.system.text, math.hypot(centre[0], centre[1])
        swings = any(math.dist(point, place) < SAME_ON_PAGE for place in self.places.values())
        if not (swings and away > SAME_ON_PAGE and STRINGS.search(text) and self.system.is_bare):
            return
        lines = [(centre, point, StrokeKind.STRING)]
        if ROD.search(text):
            lines.append(((0.0, 0.0, centre[2]), centre, StrokeKind.ROD))
        for first, second, kind in lines:
            a, b = self.flat(first), self.flat(second)
            if not any(same_ends((a, b), other) for other in self.busy):
                self.sketch.line([a, b], kind)
                self.busy.append((a, b))

    def guide(self, a: PagePoint, b: PagePoint) -> None:
        """A dashed line if none is drawn between these points yet."""
        if not any(same_ends((a, b), other) for other in self.busy):
            self.sketch.line([a, b], StrokeKind.GUIDE)
            self.busy.append((a, b))

    def distance(self, q: sp.Symbol, start: FloatVector, end: FloatVector, alone: bool) -> None:
        """A distance as a dashed line, or next to the line that is drawn already."""
        a, b = self.flat(start), self.flat(end)
        if apart(a, b) < 0.25:
            return
        if alone and len(self.system.view.shown) != 1 and any(same_ends((a, b), other) for other in self.guides):
            self.sketch.label_beside(q, a, b)
            return
        if len(self.system.view.shown) == 1 or (alone and any(overlapping((a, b), other) for other in self.busy)):
            self.dimension(q, a, b)
            return
        self.guide(a, b)
        for c in map(self.flat, self.places.values()):  # it begins beside a particle from which it is measured
            beside = inner((c[0] - a[0], c[1] - a[1]), toward(a, b))
            if alone and abs(beside) < 1e-6 < apart(a, c) and self.system.view.planar:
                self.sketch.line([a, c], StrokeKind.REFERENCE)
        self.feet += [a, b]
        self.sketch.label_beside(q, a, b)

    def dimension(self, q: sp.Symbol, a: PagePoint, b: PagePoint) -> None:
        """A dimension line parallel to the line on which a distance is measured."""
        side = left_of(toward(a, b))
        side = side if side[1] < 0 or (side[1] == 0 and side[0] > 0) else (-side[0], -side[1])
        row = sum(line.kind is StrokeKind.ANGLE and len(line.points) == 2 for line in self.sketch.lines)
        off = 0.75 + 0.55 * row  # dimension lines are the arcs of two points: each further one is a row lower
        start, end = beyond(a, side, off), beyond(b, side, off)
        for point, moved in ((a, start), (b, end)):
            self.sketch.line([beyond(point, side, 0.45), beyond(moved, side, 0.1)], StrokeKind.REFERENCE)
        self.sketch.arc([start, end], StrokeKind.ANGLE)
        self.sketch.label_beside(q, start, end)

    def turn(self, q: sp.Symbol) -> bool:
        """Mark a coordinate if it is the angle of a plane body; return whether it is one."""
        if not self.system.view.planar:
            return False
        for p in self.system.configuration.points:
            rotation = plane_rotation(self.system.configuration, p.name)
            if rotation is None or p.name in self.system.hidden:
                continue
            mark = angle_mark(self.pose, q, rotation.axes[0])
            if mark is not None and math.hypot(*mark.centre) < 1e-9:
                centre = self.flat(self.places[p.name])
                known = self.system.shapes[p.name]
                shape = self.system.problem.figure.shapes.get(p.name)
                ways = self.along_rod(p.name, centre, [toward((0, 0), self.page.way(a)) for a in mark.arc])
                radius = min(ARC, 0.6 * known.radius * self.page.scale) if known.radius else ARC + 0.2
                if shape is not None and shape.lengths:
                    radius = min(ARC, 0.6 * abs(self.system.number(shape.lengths[0])) * self.page.scale)
                if not any(overlapping((centre, beyond(centre, ways[-1], 0.3)), b) for b in self.busy):
                    self.sketch.line([centre, beyond(centre, ways[-1], radius + 0.3)], StrokeKind.REFERENCE)
                self.arc(q, centre, ways, radius)
                return True
        return False

    def along_rod(self, name: str, centre: PagePoint, ways: list[PagePoint]) -> list[PagePoint]:
        """The same angle from where a rod lies when it is 0 to the rod, if its first axis is not along it."""
        groups = (self.system.joints, self.system.marked, self.system.fastened)
        held = [self.flat(place) for places in groups for place in places.get(name, ())]
        rotation, shape = plane_rotation(self.system.configuration, name), self.system.shapes[name]
        if rotation is not None and not shape.radius:
            held += [self.flat(plus(self.places[name], in_space(self.pose, rotation, h))) for h in shape.held]
        first, last = ways[0], ways[-1]
        if not held or not in_line(centre, held):
            return ways
        along = toward(centre, max(held, key=lambda at: apart(centre, at)))
        if abs(along[0] * last[1] - along[1] * last[0]) < 1e-6:
            return ways
        cosine, sine = inner(first, last), first[0] * last[1] - first[1] * last[0]
        start = (cosine * along[0] + sine * along[1], cosine * along[1] - sine * along[0])
        sense = 1.0 if start[1] < -1e-6 or (abs(start[1]) < 1e-6 and start[0] > 0) else -1.0
        turned = [(inner(first, w), first[0] * w[1] - first[1] * w[0]) for w in ways]
        return [(sense * (c * start[0] - s * start[1]), sense * (s * start[0] + c * start[1])) for c, s in turned]

    def stiff(self) -> None:
        """Thin lines between points whose distance is constant by the choice of coordinates."""
        pairs = [(self.places[a], self.places[b]) for a, b, bound in self.system.kept_distances if not bound]
        for q, centre in self.turning_points:
            for p in self.system.configuration.points:
                if plane_rotation(self.system.configuration, p.name) is None and self.keeps_distance(q, centre, p):
                    pairs.append((centre, self.places[p.name]))
        for a, b in pairs:
            start, end = self.flat(a), self.flat(b)
            if apart(start, end) > 0.1 and not any(overlapping((start, end), other) for other in self.busy):
                self.sketch.line([start, end], StrokeKind.ROD if ROD.search(self.system.text) else StrokeKind.LINK)
                self.busy.append((start, end))

    def keeps_distance(self, q: tuple[sp.Symbol, MassPoint], centre: FloatVector, p: MassPoint) -> bool:
        """Whether a point has a constant distance from the centre of the circle of another."""
        symbol, turning = q
        distances = [math.dist(centre, self.places[p.name])]
        for pose in self.pose.others:
            mark = angle_mark(pose, symbol, turning.position)
            if mark is not None:
                distances.append(math.dist(mark.centre, pose.at(p.position)))
        moves = math.hypot(*centre) > 1e-9
        return moves and len(distances) > 3 and max(distances) - min(distances) < 1e-7
