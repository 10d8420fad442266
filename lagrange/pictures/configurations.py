"""Draws a system in a general position."""

from __future__ import annotations

import math
from itertools import combinations

import sympy as sp

from lagrange.kinematics import MassPoint
from lagrange.newton import Reaction
from lagrange.notation import UnitVector
from lagrange.pictures.curves import constraint_curve
from lagrange.pictures.floats import NoValueError, Space, minus, outer
from lagrange.pictures.loads import Acting, given_loads
from lagrange.pictures.marks import AngleMark, DistanceMark, angle_mark, crosswise, distance_marks, relative_angle_mark
from lagrange.pictures.shapes import force_and_moment, has_one_direction, in_space, is_planar, reaction_point
from lagrange.pictures.sketch import HINGE, PARTICLE, Sketch, along, apart, beyond, left_of, toward
from lagrange.pictures.systems import System, ends_of, rod_ends
from lagrange.render.mathematics import Notation
from lagrange.rigid_bodies import Rotation
from lagrange.scene import Box, Kind, Line, Point, Scene

ARROW = 1.15
ARC = 0.62
LONGEST_LABEL = 12
"""Operations of the length of a rod that is written beside it."""


def configuration_scene(system: System, notation: Notation, with_loads: bool) -> Scene | None:
    """The picture; None where it cannot be drawn sensibly. `with_loads`: whether applied forces are drawn too."""
    try:
        drawing = _Drawing(system)
        drawing.all(with_loads)
    except NoValueError:
        return None
    return drawing.sketch.scene(notation)


class _Drawing:
    """One picture."""

    def __init__(self, system: System) -> None:
        self.system = system
        self.pose = system.pose
        self.page = system.page
        self.sketch = Sketch()
        self.places = {p.name: self.pose.at(p.position) for p in system.configuration.points}
        self.origin = self.page((0.0, 0.0, 0.0))
        self.turning_points: list[tuple[tuple[sp.Symbol, MassPoint], Space]] = []
        self.hinges: list[Point] = []
        self.busy: list[tuple[Point, Point]] = []

    def all(self, with_loads: bool) -> None:
        self.axes()
        self.rods()
        self.links()
        self.bodies()
        self.particles()
        self.curves()
        if with_loads:
            self.loads()
        self.coordinates()
        self.gravity()
        self.name_origin()

    def flat(self, place: Space) -> Point:
        return self.page(place)

    @property
    def in_line(self) -> bool:
        """Whether everything is on one line."""
        return len(self.system.view.shown) == 1

    # What there is

    def axes(self) -> None:
        units = self.system.view.units
        for n in self.system.view.shown:
            way = toward((0.0, 0.0), units[n])
            size = ARROW * (math.hypot(*units[n]) if not self.system.view.planar else 1.0)
            start = beyond(self.origin, left_of(way), 0.95) if self.in_line else self.origin
            end = beyond(start, way, size)
            self.sketch.arrow(start, end, Kind.AXIS)
            self.sketch.label(UnitVector("ijk"[n]), end, way)

    def rods(self) -> None:
        for _, rod in self.system.rods:
            first, second = (self.flat(p) for p in rod_ends(rod, self.system.configuration, self.pose))
            self.sketch.line([second, first], Kind.ROD)
            self.busy.append((second, first))
            if not rod.ends[1]:
                self.hinge(second)
            if sp.count_ops(rod.length) <= LONGEST_LABEL:
                self.sketch.label_beside(rod.length, second, first, optional=True)

        for a, b, by_constraints in self.system.kept_distances:
            if by_constraints:
                start, end = self.flat(self.places[a]), self.flat(self.places[b])
                self.sketch.line([start, end], Kind.ROD)
                self.busy.append((start, end))

    def stiff(self) -> None:
        """Thin lines between points that keep their distance by the choice of coordinates."""
        pairs = [(self.places[a], self.places[b]) for a, b, bound in self.system.kept_distances if not bound]
        for q, centre in self.turning_points:
            for p in self.system.configuration.points:
                if is_planar(self.system.configuration, p.name) is None and self.keeps_distance(q, centre, p):
                    pairs.append((centre, self.places[p.name]))
        for a, b in pairs:
            start, end = self.flat(a), self.flat(b)
            if apart(start, end) > 0.1 and not any(_collinear((start, end), other) for other in self.busy):
                self.sketch.line([start, end], Kind.LINK)
                self.busy.append((start, end))

    def keeps_distance(self, q: tuple[sp.Symbol, MassPoint], centre: Space, p: MassPoint) -> bool:
        """Whether a point keeps its distance from the centre of the circle of another."""
        symbol, turning = q
        distances = [math.dist(centre, self.places[p.name])]
        for pose in self.pose.others:
            mark = angle_mark(pose, symbol, turning.position)
            if mark is not None:
                distances.append(math.dist(mark.centre, pose.at(p.position)))
        moves = math.hypot(*centre) > 1e-9
        return moves and len(distances) > 3 and max(distances) - min(distances) < 1e-7

    def hinge(self, at: Point) -> None:
        if all(apart(at, h) > 1e-3 for h in self.hinges):
            self.hinges.append(at)
            self.sketch.dot(at, HINGE, open_=True)

    def links(self) -> None:
        configuration = self.system.configuration
        drawn: list[tuple[Point, Point]] = []
        links = [*((s, s.stiffness) for s in configuration.springs), *((d, d.coefficient) for d in configuration.dampers)]
        for link, constant in links:
            a, b = (self.flat(p) for p in ends_of(link, configuration, self.pose))
            beside = sum(_same_ends((a, b), other) for other in drawn)
            shared = sum(_same_ends((a, b), tuple(self.flat(p) for p in ends_of(x, configuration, self.pose)))
                         for x, _ in links) > 1
            drawn.append((a, b))
            self.busy.append((a, b))
            side = left_of(toward(a, b))
            shift = (0.24 if beside == 0 else -0.24 * beside) if shared else 0.0
            start, end = beyond(a, side, shift), beyond(b, side, shift)
            if apart(start, end) < 0.5:
                raise NoValueError("too short for a spring")
            if shift:
                way = toward(a, b)
                inner_start, inner_end = beyond(start, way, 0.16), beyond(end, way, -0.16)
                for foot, corner in ((a, inner_start), (b, inner_end)):
                    post = beyond(foot, way, 0.16 if foot == a else -0.16)
                    self.sketch.line([foot, post, corner], Kind.SPRING)
                start, end = inner_start, inner_end
            (self.sketch.spring if link in configuration.springs else self.sketch.damper)(start, end)
            self.sketch.label_beside(constant, start, end, optional=True, clear=0.1)
            for named, at, other in zip(link.ends, (a, b), (b, a), strict=True):
                if not isinstance(named, str) and all(apart(at, h) > 1e-3 for h in self.hinges):
                    if self.in_line:
                        self.hinges.append(at)
                        self.sketch.wall(at, toward(at, other))
                    else:
                        self.hinge(at)

    def bodies(self) -> None:
        for p in self.system.configuration.points:
            rotation = is_planar(self.system.configuration, p.name)
            if rotation is not None and self.system.view.planar:
                self.plane_body(p, rotation)
            else:
                turning = [r for r in self.system.configuration.rotations if r.name == p.name]
                for r in turning:
                    self.triad(p, r)

    def plane_body(self, p: MassPoint, rotation: Rotation) -> None:
        centre = self.flat(self.places[p.name])
        known = self.system.shapes[p.name]
        held = [self.flat(_sum(self.places[p.name], in_space(self.pose, rotation, h))) for h in known.held]
        joints = [self.flat(j) for j in self.system.joints.get(p.name, ())]
        held += joints
        for j in joints:
            self.hinge(j)
        if known.radius:
            radius = known.radius * self.page.scale
            self.sketch.ellipse(centre, (radius, 0.0), (0.0, radius))
            e1 = self.page.way(self.pose.at(rotation.axes[0]))
            self.sketch.line([centre, beyond(centre, toward((0, 0), e1), radius)], Kind.GUIDE)
        elif held and _in_line(centre, held):
            a, b = _ends([centre, *held])
            self.sketch.capsule(a, b, 0.12)
            self.busy.append((a, b))
        elif held:
            way = toward(centre, held[0])
            reach = max(apart(centre, h) for h in held) + 0.18
            self.sketch.ellipse(centre, (way[0] * reach, way[1] * reach), _scaled(left_of(way), 0.6 * reach))
        elif self.system.configuration.rows:
            self.triad(p, rotation)
        else:
            e1 = toward((0, 0), self.page.way(self.pose.at(rotation.axes[0])))
            self.sketch.ellipse(centre, _scaled(e1, 0.62), _scaled(left_of(e1), 0.36))
        self.sketch.dot(centre, 0.06)
        self.supports(p, rotation)

    def supports(self, p: MassPoint, rotation: Rotation) -> None:
        """The lines on which a body slides or rolls: across a reaction that always has the same direction."""
        known = self.system.shapes[p.name]
        for reaction in self.system.reactions_on(p.name):
            rolls = known.radius and reaction.name not in known.at
            point = reaction_point(self.pose, rotation, reaction, known)
            if point is None or math.hypot(*point) < 1e-6:
                continue
            if not has_one_direction(self.pose, reaction, p.name):
                self.track(p, rotation, reaction)
                continue
            at = self.flat(_sum(self.places[p.name], point))
            force, _ = force_and_moment(self.pose, reaction, p.name)
            way = toward((0, 0), self.page.way(force))
            way = way if rolls else left_of(way)
            half = 1.1 + (known.radius * self.page.scale if rolls else 0.0)
            self.sketch.line([beyond(at, way, -half), beyond(at, way, half)], Kind.CURVE)

    def track(self, p: MassPoint, rotation: Rotation, reaction: Reaction) -> None:
        """The part near a wheel of the circle on which it rolls."""
        known = self.system.shapes[p.name]
        if not known.radius or reaction.name in known.at:
            return
        touched = []
        for pose in (self.pose, *self.pose.others):
            point = reaction_point(pose, rotation, reaction, known)
            touched.append(None if point is None else _sum(pose.at(p.position), point))
        for q in self.pose.coordinates:
            mark = angle_mark(self.pose, q, p.position)
            if mark is None or any(x is None for x in touched) or len(touched) < 3:
                continue
            distances = [math.dist(mark.centre, x) for x in touched if x is not None]
            if max(distances) - min(distances) < 1e-7 and touched[0] is not None:
                centre, (x, y) = self.flat(mark.centre), self.flat(touched[0])
                turn = math.atan2(y - centre[1], x - centre[0])
                radius = distances[0] * self.page.scale
                angles = [turn + (k - 16) * 0.06 for k in range(33)]
                self.sketch.line([beyond(centre, (math.cos(a), math.sin(a)), radius) for a in angles], Kind.CURVE)
                return

    def triad(self, p: MassPoint, rotation: Rotation) -> None:
        centre = self.flat(self.places[p.name])
        for n, axis in enumerate(rotation.axes):
            x, y = self.page.way(self.pose.at(axis))
            if math.hypot(x, y) < 0.15 and self.system.view.planar:
                continue
            if math.hypot(x, y) < 0.15:
                raise NoValueError("an axis points at the reader")
            end = (centre[0] + x * 0.95, centre[1] + y * 0.95)
            self.sketch.arrow(centre, end, Kind.BODY)
            self.sketch.label(UnitVector(f"e_{n + 1}"), end, toward(centre, end))
        self.sketch.dot(centre, PARTICLE)

    def particles(self) -> None:
        turning = {r.name for r in self.system.configuration.rotations}
        lines = [piece for line in self.sketch.lines for piece in line.pieces]
        for p in self.system.configuration.points:
            at = self.flat(self.places[p.name])
            if p.name not in turning:
                self.sketch.dot(at)
            ways = [toward(at, b if apart(a, at) < apart(b, at) else a) for a, b in lines if _touches(at, a, b)]
            x, y = -sum(w[0] for w in ways), -sum(w[1] for w in ways)
            prefer = toward((0, 0), (x, y)) if math.hypot(x, y) > 1e-3 else (0.7, 0.7)
            self.sketch.label(_name(p.name), at, prefer, clear=PARTICLE)

    def curves(self) -> None:
        if not self.system.view.planar:
            return
        points = [self.origin, *(self.flat(p) for p in self.places.values())]
        for reaction in self.system.newton.reactions:
            if reaction.rod is not None or reaction.directions is None or len(reaction.directions) != 1:
                continue
            [name] = reaction.directions
            p = next(x for x in self.system.configuration.points if x.name == name)
            row = next((r for r in self.system.configuration.rows if r.name == reaction.name), None)
            if row is None or name in {r.name for r in self.system.configuration.rotations}:
                continue
            frame = Box.around(points).grown(1.0)
            found = constraint_curve(self.pose, row, p.position, self.page, frame)
            if found is not None:
                self.sketch.line(found[0], Kind.CURVE, closed=found[1])
                if _in_line(found[0][0], found[0][1:]):
                    self.busy.append((found[0][0], found[0][-1]))

    def loads(self) -> None:
        for name in self.places:
            for acting in given_loads(self.system, name):
                self.load(acting)

    def load(self, acting: Acting) -> None:
        if acting.is_moment:
            return
        start = self.flat(_sum(self.places[acting.on], acting.offset))
        way = toward((0.0, 0.0), self.page.way(acting.vector))
        end = beyond(start, way, ARROW)
        self.sketch.arrow(start, end, Kind.FORCE)
        self.sketch.label(acting.label, end, way)

    # What is measured

    def coordinates(self) -> None:
        rest = [q for q in self.pose.coordinates if not self.is_length(q)]
        known: list[Space] = [(0.0, 0.0, 0.0), *self.places.values()]
        for q in list(rest):
            if self.angle(q):
                rest.remove(q)
        for p in self.system.configuration.points:
            marks = distance_marks(self.pose, rest, p.position, known)
            for m in marks:
                rest.remove(m.coordinate)
            if marks and not self.system.view.planar:
                marks = self.on_the_floor(marks)
            for m in crosswise(marks):
                self.distance(m.coordinate, m.start, m.end, len(marks) == 1)
        left = [q for q in rest if not self.turn(q)]
        bodies = bool(self.system.configuration.rotations)
        if self.system.view.planar and not bodies and any(self.moves_something(q) for q in left):
            raise NoValueError("a coordinate that is seen nowhere")
        self.stiff()

    def moves_something(self, q: sp.Symbol) -> bool:
        """Whether a coordinate moves a particle, by itself."""
        moved = self.pose.moved(q, 0.3)
        return any(math.dist(moved.at(p.position), self.places[p.name]) > 1e-9 for p in self.system.configuration.points)

    def on_the_floor(self, marks: list[DistanceMark]) -> list[DistanceMark]:
        """The way to a point at a fixed height is drawn at the height 0, with a plumb line."""
        start, end = marks[0].start, marks[-1].end
        if math.hypot(*start) < 1e-9:
            return marks
        self.sketch.line([self.flat(end), self.flat(minus(end, start))], Kind.GUIDE)
        return [DistanceMark(m.coordinate, minus(m.start, start), minus(m.end, start)) for m in marks]

    def is_length(self, q: sp.Symbol) -> bool:
        """Whether a coordinate is written at a rod as its length."""
        return any(rod.length == q for _, rod in self.system.rods)

    def angle(self, q: sp.Symbol) -> bool:
        for p in self.system.configuration.points:
            mark = angle_mark(self.pose, q, p.position)
            if mark is not None:
                self.angle_at(mark)
                self.turning_points.append(((q, p), mark.centre))
                return True
        turning = {r.name for r in self.system.configuration.rotations}
        points = [p for p in self.system.configuration.points if p.name not in turning]
        for a, b in combinations(points, 2) if self.system.view.planar else ():
            mark = relative_angle_mark(self.pose, q, b.position, a.position)
            if mark is not None:
                self.angle_at(mark)
                return True
        return False

    def angle_at(self, mark: AngleMark) -> None:
        if not self.system.view.planar:
            self.angle_in_space(mark)
            return
        centre, end = self.flat(mark.centre), self.flat(mark.point)
        length = apart(centre, end)
        radius = min(ARC + 0.25 * self.arcs_at(centre), 0.8 * length)
        ways = [toward((0, 0), self.page.way(a)) for a in mark.arc]
        if not any(_collinear((centre, end), b) for b in self.busy):
            self.sketch.line([centre, end], Kind.GUIDE)
            self.busy.append((centre, end))
        self.arc(mark.coordinate, centre, ways, radius)

    def arcs_at(self, centre: Point) -> int:
        """How many arcs there are around a point."""
        arcs = [line for line in self.sketch.lines if line.kind is Kind.ANGLE]
        return sum(abs(apart(centre, a.points[0]) - apart(centre, a.points[-1])) < 1e-6 and apart(centre, a.points[0]) < 1.6
                   for a in arcs)

    def arc(self, q: sp.Symbol, centre: Point, ways: list[Point], radius: float) -> None:
        reference = beyond(centre, ways[0], radius + 0.35)
        self.sketch.line([centre, reference], Kind.GUIDE)
        points = [beyond(centre, w, radius) for w in ways]
        self.sketch.arc(points, Kind.ANGLE)
        self.sketch.label(q, points[10], ways[10])

    def angle_in_space(self, mark: AngleMark) -> None:
        """An angle about an axis is drawn in the plane through the origin, below or above the circle of the point."""
        axis = outer(mark.arc[0], mark.arc[7])
        size = math.hypot(*axis)
        upright = [n for n in range(3) if abs(abs(axis[n]) / size - 1) < 1e-6]
        centre, point = mark.centre, mark.point
        if upright and math.hypot(*centre) > 1e-6 and all(abs(centre[m]) < 1e-9 for m in range(3) if m not in upright):
            foot = minus(point, centre)
            self.sketch.line([self.flat(point), self.flat(foot)], Kind.GUIDE)
            centre, point = (0.0, 0.0, 0.0), foot
        self.guide(self.flat(centre), self.flat(point))
        radius = math.hypot(*minus(point, centre))
        part = min(0.8, ARC * 1.1 / (radius * self.page.scale))
        arc = [self.flat(_sum(centre, a, part)) for a in mark.arc]
        self.sketch.line([self.flat(centre), self.flat(_sum(centre, mark.reference, part * 1.3))], Kind.GUIDE)
        self.sketch.arc(arc, Kind.ANGLE)
        self.sketch.label(mark.coordinate, arc[10], toward(self.flat(centre), arc[10]))

    def guide(self, a: Point, b: Point) -> None:
        if not any(_same_ends((a, b), other) for other in self.busy):
            self.sketch.line([a, b], Kind.GUIDE)
            self.busy.append((a, b))

    def distance(self, q: sp.Symbol, start: Space, end: Space, alone: bool) -> None:
        a, b = self.flat(start), self.flat(end)
        if apart(a, b) < 0.25:
            return
        taken = self.in_line or (alone and any(_collinear((a, b), other) for other in self.busy))
        if taken:
            self.dimension(q, a, b)
            return
        self.guide(a, b)
        self.sketch.label_beside(q, a, b)

    def dimension(self, q: sp.Symbol, a: Point, b: Point) -> None:
        """A distance beside the line on which it is."""
        side = left_of(toward(a, b))
        side = side if side[1] < 0 or (side[1] == 0 and side[0] > 0) else (-side[0], -side[1])
        row = sum(line.kind is Kind.ANGLE and len(line.points) == 2 for line in self.sketch.lines)
        off = 0.75 + 0.55 * row
        start, end = beyond(a, side, off), beyond(b, side, off)
        for point, moved in ((a, start), (b, end)):
            self.sketch.line([beyond(point, side, 0.45), beyond(moved, side, 0.1)], Kind.GUIDE)
        self.sketch.arc([start, end], Kind.ANGLE)
        self.sketch.label_beside(q, start, end)

    def turn(self, q: sp.Symbol) -> bool:
        """The angle of a plane body, at its mass centre."""
        if not self.system.view.planar:
            return False
        for p in self.system.configuration.points:
            rotation = is_planar(self.system.configuration, p.name)
            if rotation is None:
                continue
            mark = angle_mark(self.pose, q, rotation.axes[0])
            if mark is not None and math.hypot(*mark.centre) < 1e-9:
                centre = self.flat(self.places[p.name])
                known = self.system.shapes[p.name]
                ways = [toward((0, 0), self.page.way(a)) for a in mark.arc]
                radius = min(ARC, 0.6 * known.radius * self.page.scale) if known.radius else ARC + 0.2
                self.sketch.line([centre, beyond(centre, ways[-1], radius + 0.3)], Kind.GUIDE)
                self.arc(q, centre, ways, radius)
                return True
        return False

    def gravity(self) -> None:
        field = self.system.problem.gravity
        if field is None or field.is_zero:
            return
        size = sp.sqrt(sp.Add(*(c**2 for c in field.fixed().components)))
        way = self.page.way(self.pose.at(field))
        symbols = field.fixed().as_sum().free_symbols & {s for s in self.pose.values}
        if math.hypot(*way) < 1e-9:
            return
        name = size if size.is_Symbol else sp.Symbol("g", positive=True) if sp.Symbol("g", positive=True) in symbols else None
        if name is None:
            return
        way = toward((0, 0), way)
        corners = [p for line in self.sketch.lines for p in line.points] + [d.at for d in self.sketch.dots]
        box = Box.around(corners)
        x = box.right + 0.75
        start = (x, (box.top + box.bottom) / 2 - way[1] * 0.45)
        end = beyond(start, way, 0.9)
        self.sketch.arrow(start, end, Kind.AXIS)
        self.sketch.label_beside(name, start, end)

    def name_origin(self) -> None:
        units = [u for n, u in enumerate(self.system.view.units) if n in self.system.view.shown]
        away = (-sum(u[0] for u in units), -sum(u[1] for u in units))
        if not self.in_line:
            self.sketch.label("O", self.origin, toward((0, 0), away), clear=0.05, optional=True)


def _name(name: str) -> str:
    return name.replace("_", " ").replace(".", " ")


def _sum(a: Space, b: Space, times: float = 1.0) -> Space:
    return a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]


def _scaled(way: Point, by: float) -> Point:
    return way[0] * by, way[1] * by


def _same_ends(a: tuple[Point, ...], b: tuple[Point, ...]) -> bool:
    straight = apart(a[0], b[0]) + apart(a[1], b[1])
    turned = apart(a[0], b[1]) + apart(a[1], b[0])
    return min(straight, turned) < 1e-3


def _collinear(a: tuple[Point, Point], b: tuple[Point, Point]) -> bool:
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


def _touches(at: Point, a: Point, b: Point) -> bool:
    return min(apart(at, a), apart(at, b)) < 0.02


def _in_line(centre: Point, others: list[Point]) -> bool:
    far = max(others, key=lambda p: apart(centre, p))
    if apart(centre, far) < 1e-6:
        return False
    side = left_of(toward(centre, far))
    return all(abs((p[0] - centre[0]) * side[0] + (p[1] - centre[1]) * side[1]) < 0.06 for p in others)


def _ends(points: list[Point]) -> tuple[Point, Point]:
    pairs = [(a, b) for a in points for b in points]
    return max(pairs, key=lambda p: apart(*p))


__all__ = ["Line", "along", "configuration_scene"]
