"""What holds a point of a plane body: pins and rollers under beams, walls that clamp beams, slots of yokes."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field

from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, plus, solved, unit
from lagrange.pictures.implied.halves import HALF, half_disc, level_of
from lagrange.pictures.inferred import BEARING, fulcrum, roller
from lagrange.pictures.limits import SAME_ON_PAGE, SAME_SHAPE
from lagrange.pictures.loads import force_label
from lagrange.pictures.poses import Pose
from lagrange.pictures.shapes import (
    Shape,
    common_point,
    force_and_moment,
    has_one_direction,
    in_space,
    line_of_action,
    plane_rotation,
    push_sense,
    reaction_point,
    turns,
)
from lagrange.pictures.sketch import Sketch, apart, beyond, left_of, lies_on, scaled, toward
from lagrange.pictures.solids import MEDIUM
from lagrange.pictures.systems import BEAM, ROPE, SystemPicture, is_string, with_other_values
from lagrange.problem.keys import Outline
from lagrange.problem.model import Friction

ON_FLOOR = re.compile(r"\b(floor|ground|table|ice|road)\b", re.IGNORECASE)
ROUND = (Outline.DISC, Outline.RING, Outline.SPHERE)
_SLOT = 0.11
"""Half the width of a slot, in centimetres: a pin fits in."""
_CORNERS = ((1, 1), (-1, 1), (-1, -1), (1, -1))


def bearing(
    system: SystemPicture, sketch: Sketch, p: MassPoint, reaction: Reaction, at: PagePoint, down: PagePoint
) -> None:
    """What holds a point that cannot move: of a beam a wall where it cannot turn, a pin where two reactions act, a
    roller where one does; of anything else a hinge.
    """
    here = system.shapes[p.name].together_with(reaction.name)
    if not BEAM.search(system.text):
        sketch.hinge(at)
        return
    if len(here) > 1 and _is_clamped(system, p):
        along = _along_beam(system, p, at)
        if here[0] == reaction.name and along is not None:
            sketch.wall(at, along, 0.55)
        return
    if len(here) > 1 and here[0] == reaction.name:
        fulcrum(sketch, at, down, BEARING)
    elif len(here) == 1:
        force, _ = force_and_moment(system.pose, reaction, p.name)
        way = toward((0, 0), system.page.way(force))
        tilt = inner(way, down)
        roller(sketch, at, scaled(way, math.copysign(1.0, tilt)) if abs(tilt) > SAME_ON_PAGE else way)
    sketch.hinge(at)


def _is_clamped(system: SystemPicture, p: MassPoint) -> bool:
    """Whether a moment alone keeps a body from turning."""
    for reaction in system.reactions_on(p.name):
        try:
            force, moment = force_and_moment(system.pose, reaction, p.name)
        except NoValueError:
            continue
        if math.hypot(*force) < SAME_ON_PAGE < math.hypot(*moment):
            return True
    return False


def _along_beam(system: SystemPicture, p: MassPoint, at: PagePoint) -> PagePoint | None:
    """The direction from a place to the farther end of a rod."""
    shape = system.problem.figure.shapes.get(p.name)
    ends = [system.page(system.at(end)) for end in shape.ends] if shape is not None else []
    far = max(ends, key=lambda end: apart(end, at), default=at)
    return toward(at, far) if apart(at, far) > SAME_ON_PAGE else None


def slots(system: SystemPicture, sketch: Sketch) -> tuple[str, ...]:
    """Draw the slots of particles in which pins of bodies slide, as of a yoke; return the constraints that they are."""
    found = []
    for reaction in system.newton.reactions if system.view.planar and system.is_bare else ():
        particles = [p for p in system.configuration.points if p.name in (reaction.directions or ())]
        bodies = [*reaction.moments]
        particles = [p for p in particles if p.name not in bodies]
        if len(particles) != 1 or len(bodies) != 1 or reaction.row.finite is None:
            continue
        with suppress(NoValueError):
            if _slot(system, sketch, particles[0], bodies[0], reaction):
                found.append(reaction.name)
    return tuple(found)


def _slot(system: SystemPicture, sketch: Sketch, p: MassPoint, body: str, reaction: Reaction) -> bool:
    """The slot of one particle, across the force on it, where this acts on one point of the body: whether it does.

    The force on the body is the opposite one, also where its mass centre cannot move and only the moment is seen.
    """
    rotation, force, moment = (
        plane_rotation(system.configuration, body),
        reaction.per_unit(p.name),
        reaction.moment_per_unit(body),
    )
    if rotation is None or force is None or moment is None:
        return False
    lines, ways = [], []
    for pose in (system.pose, *system.pose.others):
        ways.append(pose.at(force))
        line = line_of_action(minus((0.0, 0.0, 0.0), ways[-1]), pose.at(moment))
        axes = [pose.at(a) for a in rotation.axes[:2]]
        if line is None:
            return False
        (dx, dy), (px, py) = ([inner(v, a) for a in axes] for v in (line.direction, line.nearest))
        lines.append(((dx, dy), (px, py)))
    point = common_point(lines) if len(lines) > 2 and turns(lines) else None
    if point is None or any(math.hypot(*outer(ways[0], w)) > SAME_ON_PAGE for w in ways):
        return False
    centre = next(q for q in system.configuration.points if q.name == body)
    pin = system.page(plus(system.pose.at(centre.position), in_space(system.pose, rotation, point)))
    held = system.page(system.pose.at(p.position))
    across = toward((0, 0), system.page.way(ways[0]))
    along = left_of(across)
    reach = inner((pin[0] - held[0], pin[1] - held[1]), along)
    if apart(beyond(held, along, reach), pin) > SAME_ON_PAGE or abs(reach) < SAME_ON_PAGE:
        return False  # it pushes a face elsewhere
    half = abs(reach) + 3 * _SLOT
    corners = [beyond(beyond(held, along, a * half), across, b * _SLOT) for a, b in _CORNERS]
    sketch.line(corners, StrokeKind.BODY, closed=True)
    sketch.hinge(pin)
    return True


@dataclass
class Supports:
    """The ground, rollers, hinges, strings and tracks on which the reactions on plane bodies act.

    busy   pieces along which a line is drawn
    slots  constraints that are drawn as slots
    down   the direction of gravity on the page
    touched  the places at which bodies touch ground
    mounts   hinges that something has to hold
    boards   the upper sides of boards, on which a body needs no ground
    """

    system: SystemPicture
    sketch: Sketch
    busy: list[tuple[PagePoint, PagePoint]]
    slots: tuple[str, ...]
    down: PagePoint
    touched: list[PagePoint] = field(default_factory=list)
    mounts: list[PagePoint] = field(default_factory=list)
    boards: Sequence[tuple[PagePoint, PagePoint]] = ()

    @property
    def pose(self) -> Pose:
        """The position that is drawn."""
        return self.system.pose

    def draw(self, p: MassPoint, rotation: Rotation) -> None:
        """The lines on which a body slides or rolls: perpendicular to a reaction whose direction is constant."""
        known = self.system.shapes[p.name]
        for reaction in self.system.reactions_on(p.name):
            if reaction.name in self.slots or len({*reaction.acts_on}) > 1:
                continue  # between two bodies there is no ground
            rolls = known.radius and reaction.name not in known.at
            if not rolls and self.round_contact(p, rotation, reaction):
                continue
            point = reaction_point(self.pose, rotation, reaction, known)
            if self.is_friction(reaction, known):
                continue
            held = reaction.name in known.at and self.stays(p, rotation, known.at[reaction.name])
            held = held and (reaction.constraint.side is None or bool(BEAM.search(self.system.text)))
            if point is None or (math.hypot(*point) < 1e-6 and not held):
                continue
            if not has_one_direction(self.pose, reaction, p.name):
                self.track(p, rotation, reaction)
                continue
            at = self.system.page(plus(self.pose.at(p.position), point))
            if held:
                bearing(self.system, self.sketch, p, reaction, at, self.down)
                pinned = len(known.together_with(reaction.name)) > 1
                new = all(apart(at, other) > SAME_ON_PAGE for other in self.mounts)
                if pinned and new and not BEAM.search(self.system.text):
                    self.mounts.append(at)
                continue
            force, _ = force_and_moment(self.pose, reaction, p.name)
            way = toward((0, 0), self.system.page.way(force))
            if is_string(reaction) and rolls:
                self.unwinding(p, at, way if inner(way, self.down) < 0 else scaled(way, -1.0))
                continue
            way = way if rolls else left_of(way)
            half = 1.1 + (known.radius * self.system.page.scale if rolls else 0.0)
            declared = self.system.problem.figure.shapes.get(p.name)
            if declared is not None and declared.kind is Outline.BOX:  # from its corner to beyond its other end
                x, y = self.system.page(self.pose.at(p.position))
                half += 2 * abs(inner((x - at[0], y - at[1]), way))
            ends = [beyond(at, way, -half), beyond(at, way, half)]
            push = toward(at, self.system.page(self.pose.at(p.position)))
            if left_of(way)[0] * push[0] + left_of(way)[1] * push[1] < 0:
                ends.reverse()
            self.touched.append(at)
            if not any(lies_on(at, *top) for top in self.boards):
                self.sketch.ground(ends)

    def is_friction(self, reaction: Reaction, known: Shape) -> bool:
        """Whether a reaction keeps a point from sliding that another, one-sided one keeps on the ground."""
        here = known.at.get(reaction.name)
        if here is None or reaction.constraint.side is not None:
            return False
        one_sided = {r.name for r in self.system.newton.reactions if r.constraint.side is not None}
        return any(math.dist(here, at) < SAME_ON_PAGE for name, at in known.at.items() if name in one_sided)

    def under_several(self) -> None:
        """The ground under several bodies that one constraint keeps on it: at their lowest ends along the force."""
        if not (self.system.view.planar and self.system.is_bare):
            return
        for reaction in self.system.newton.reactions:
            if reaction.constraint.side is None:
                continue
            with suppress(NoValueError):
                names, way = self._carried_by(reaction)
                up = toward((0.0, 0.0), self.system.page.way(unit(way)))
                up = scaled(up, reaction.constraint.side if reaction.directions is None else push_sense(reaction))
                if len(names) > 1 and inner(up, self.down) < -0.99:
                    self._under(names, up)
        upright = self.system.problem.gravity is not None or {"up", "down"} & {*self.system.problem.axes.values()}
        struck = self.system.problem.impact is not None and upright
        named = [p.name for p in self.system.configuration.points if p.name in self.system.problem.figure.shapes]
        drawn = any(line.kind is StrokeKind.GROUND for line in self.sketch.lines)
        if struck and named and not drawn and ON_FLOOR.search(self.system.text):
            self._under(named, scaled(self.down, -1.0))

    def _carried_by(self, reaction: Reaction) -> tuple[list[str], FloatVector]:
        """The bodies on which a reaction acts together, and its resultant or the way of its one coordinate."""
        shapes = self.system.problem.figure.shapes
        if reaction.directions is not None:
            names = [name for name in reaction.acts_on if name in shapes]
            forces = [self.pose.at(reaction.per_unit(name) or Vector.zero()) for name in names]
        else:
            coordinates = self.pose.coordinates
            bound = [q for q, a in zip(coordinates, reaction.row.coefficients, strict=False) if a != 0]
            points = [p for p in self.system.configuration.points if p.name in shapes] if len(bound) == 1 else []
            names = [p.name for p in points]
            forces = [self.pose.at(p.position.fixed().partial(bound[0])) for p in points]
        return names, (sum(f[0] for f in forces), sum(f[1] for f in forces), sum(f[2] for f in forces))

    def _under(self, names: Sequence[str], up: PagePoint) -> None:
        """A piece of ground under the lowest ends and corners of bodies."""
        ends = [self.system.page(place) for name in names for place in self._corners(name)]
        if not ends:
            return
        low, side = min(inner(end, up) for end in ends), left_of(up)
        feet = [end for end in ends if inner(end, up) < low + 1e-3]
        places = [inner(end, side) for end in feet]
        foot = beyond(scaled(up, low), side, (min(places) + max(places)) / 2)
        self.sketch.wall(foot, up, (max(places) - min(places)) / 2 + 0.9)
        self.touched += feet

    def _corners(self, name: str) -> list[FloatVector]:
        """The ends of a rod, the corners of a box, the lowest point of what is round."""
        shape = self.system.problem.figure.shapes[name]
        rotation = plane_rotation(self.system.configuration, name)
        at = next(self.pose.at(p.position) for p in self.system.configuration.points if p.name == name)
        lengths = [abs(self.system.number(x)) for x in shape.lengths]
        if shape.ends:
            return [self.system.at(end) for end in shape.ends]
        if shape.kind is Outline.BOX and rotation is not None:
            half = [x / 2 for x in lengths]
            return [plus(at, in_space(self.pose, rotation, (a * half[0], b * half[1]))) for a, b in _CORNERS]
        if shape.kind in ROUND:
            x, y = (u[0] * self.down[0] + u[1] * self.down[1] for u in self.system.view.units[:2])
            return [plus(at, (x, y, 0.0), lengths[0])]
        return []

    def round_contact(self, p: MassPoint, rotation: Rotation, reaction: Reaction) -> bool:
        """Draw what a round part of a body touches, where its force passes through the centre; whether it does.

        A line where the force has one direction, the edge of a kerb where one point is touched, or a part of a circle.
        """
        centre = self.system.shapes[p.name].at.get(reaction.name)
        if reaction.constraint.kinematic or [*reaction.acts_on] != [p.name] or centre is None:
            return False
        poses = (self.pose, *self.pose.others)
        try:
            centres = [plus(x.at(p.position), in_space(x, rotation, centre)) for x in poses]
            radius = self._radius(p, reaction, centres[0], centre)
            ways = [unit(force_and_moment(x, reaction, p.name)[0]) for x in poses]
        except NoValueError:
            return False
        if radius is None or len(poses) < 3:
            return False
        if (push_sense(reaction) or self._upward(ways[0])) < 0:
            ways = [minus((0.0, 0.0, 0.0), w) for w in ways]
        contacts = [plus(c, w, -radius) for c, w in zip(centres, ways, strict=True)]
        page, size = self.system.page, radius * self.system.page.scale
        at, up = page(contacts[0]), toward((0.0, 0.0), page.way(ways[0]))
        self.touched.append(at)
        if all(math.dist(contacts[0], c) < SAME_SHAPE for c in contacts) and self._is_edge(p, reaction, contacts[0]):
            self.kerb(p, at, page(centres[0]), size)
        elif all(math.dist(ways[0], w) < SAME_SHAPE for w in ways):
            if not any(lies_on(at, *top) for top in self.boards):
                self.sketch.wall(at, up, 0.9 + size)
        else:
            return self._arc_around(contacts, page(centres[0]))
        return True

    def _is_edge(self, p: MassPoint, reaction: Reaction, edge: FloatVector) -> bool:
        """Whether the force comes from one point: off the constraints it turns about that, as from no plane."""
        with suppress(NoValueError):
            moved = [self.pose.moved(q, by) for q in self.pose.coordinates for by in (0.2, -0.15)]
            for x in (x for x in moved if math.dist(x.at(p.position), self.pose.at(p.position)) > SAME_SHAPE):
                way, force = minus(x.at(p.position), edge), force_and_moment(x, reaction, p.name)[0]
                if math.hypot(*outer(way, force)) > SAME_SHAPE * math.hypot(*way) * math.hypot(*force):
                    return False
            return True
        return False

    def round_parts(self, p: MassPoint) -> list[tuple[FloatVector, float]]:
        """The centres and radii of round parts of a body with its mass centre elsewhere, as friction on them tells."""
        known = self.system.shapes[p.name].at
        found: list[tuple[FloatVector, float]] = []
        for reaction in self.system.reactions_on(p.name):
            centre = known.get(reaction.name)
            rotation = plane_rotation(self.system.configuration, p.name)
            if centre is None or rotation is None or math.hypot(*centre) < SAME_ON_PAGE:
                continue
            at = plus(self.pose.at(p.position), in_space(self.pose, rotation, centre))
            with suppress(NoValueError):
                radius = self._radius(p, reaction, at, centre)
                if radius is not None and all(math.dist(at, other) > SAME_ON_PAGE for other, _ in found):
                    found.append((at, radius))
        return found

    def outline(self, p: MassPoint) -> bool:
        """Draw a body that rests on a round part: a half disc around its mass centre, or a disc; whether it is one."""
        parts = self.round_parts(p)
        half = None if parts else half_disc(self.system, p)
        if half is not None:
            centres, length = half
            parts = [(centres[0], length)]
            level = level_of(centres)
            if level is not None:
                along = toward((0.0, 0.0), self.system.page.way(level))
                up = left_of(along) if inner(left_of(along), self.down) <= 0 else scaled(left_of(along), -1.0)
                size = length * self.system.page.scale
                foot = beyond(self.system.page(centres[0]), up, -size)
                self.sketch.wall(foot, up, size + 0.9)
                self.touched.append(foot)
        for at, radius in parts:
            centre, size = self.system.page(at), radius * self.system.page.scale
            if HALF.search(self.system.text):
                way = toward(centre, self.system.page(self.pose.at(p.position)))
                turn = math.atan2(way[1], way[0])
                angles = [turn + math.pi * (n / 36 - 0.5) for n in range(37)]
                self.sketch.face([beyond(centre, (math.cos(a), math.sin(a)), size) for a in angles], 2)
            else:
                self.sketch.circle(centre, size, 2)
        return bool(parts)

    def _upward(self, way: FloatVector) -> float:
        x, y = self.system.page.way(way)
        return -inner((x, y), self.down) or x or y

    def _radius(self, p: MassPoint, reaction: Reaction, at: FloatVector, centre: tuple[float, float]) -> float | None:
        """The radius of a round part: from its centre to the point where there is friction, or that of a round body."""
        rubbed = [f.at for f in self.system.problem.forces if isinstance(f, Friction) and f.at is not None
                  and f.on == p.name and reaction.name in f.constraints]  # fmt: skip
        if rubbed:
            away = minus(self.system.at(rubbed[0]), at)
            force, _ = force_and_moment(self.pose, reaction, p.name)
            straight = math.hypot(*outer(away, force)) < SAME_ON_PAGE
            return math.hypot(*away) if straight and math.hypot(*away) > SAME_ON_PAGE else None
        shape = self.system.problem.figure.shapes.get(p.name)
        if shape is None or shape.kind not in ROUND or math.hypot(*centre) > SAME_ON_PAGE:
            return None
        return abs(self.system.number(shape.lengths[0]))

    def kerb(self, p: MassPoint, edge: PagePoint, centre: PagePoint, radius: float) -> None:
        """A step whose edge a wheel touches, up from the ground on which it is too; else an edge that it rolls off."""
        out = toward((0.0, 0.0), (inner((edge[0] - centre[0], edge[1] - centre[1]), left_of(self.down)), 0.0))[0]
        side = scaled(left_of(self.down), out)
        high = radius - inner((edge[0] - centre[0], edge[1] - centre[1]), self.down)
        grounded = sum(r.constraint.side is not None for r in self.system.reactions_on(p.name)) > 1
        foot, far = beyond(edge, self.down, high), beyond(edge, side, 1.6)
        if not grounded:
            step = [beyond(edge, self.down, 1.2), edge, far]
            self.sketch.ground(step if out > 0 else step[::-1])
            return
        step = [foot, edge, far]
        self.sketch.ground(step if out > 0 else step[::-1])

    def threads(self) -> None:
        """Threads by whose name a force is called, from where each pulls; the hub of a spool from which one comes."""
        for load in self.system.configuration.loads if self.system.view.planar and self.system.is_bare else ():
            p = next((p for p in self.system.configuration.points if p.name == load.on), None)
            if p is None or not ROPE.search(load.name.replace("_", " ")) or "back" in load.name:
                continue
            with suppress(NoValueError):
                pose = with_other_values(self.pose, [*load.vector.fixed().components, *load.point.fixed().components])
                centre, at = self.pose.at(p.position), pose.at(load.point)
                way = toward((0.0, 0.0), self.system.page.way(pose.at(load.vector)))
                start = self.system.page(at)
                shape = self.system.problem.figure.shapes.get(p.name)
                rim = abs(self.system.number(shape.lengths[0])) if shape is not None and shape.kind in ROUND else 0.0
                if rim == 0 and p.name in self.system.shapes:
                    rim = self.system.shapes[p.name].radius
                hub = math.dist(centre, at)
                if SAME_ON_PAGE < hub < 0.98 * rim:
                    self.sketch.circle(self.system.page(centre), hub * self.system.page.scale, MEDIUM)
                end = beyond(start, way, 1.2 + (rim - hub) * self.system.page.scale if rim else 1.5)
                self.sketch.line([start, end], StrokeKind.STRING)
                self.sketch.arrow(beyond(end, way, -0.01), beyond(end, way, 0.5), StrokeKind.FORCE)
                self.sketch.label(force_label(load, ""), beyond(end, way, 0.5), way, optional=True)
                self.busy.append((start, end))

    def unwinding(self, p: MassPoint, at: PagePoint, way: PagePoint) -> None:
        """The string that leaves a wheel, up to the level where it is fastened, beyond the rim of a spool."""
        origin = self.system.page((0.0, 0.0, 0.0))
        reach = max(1.6, inner((origin[0] - at[0], origin[1] - at[1]), way))
        shape = self.system.problem.figure.shapes.get(p.name)
        if shape is not None and shape.kind is Outline.DISC:
            centre = self.system.page(self.pose.at(p.position))
            rim = abs(self.system.number(shape.lengths[0])) * self.system.page.scale
            reach = max(reach, rim + 0.9)
            if apart(centre, at) < 0.95 * rim:
                self.sketch.circle(centre, apart(centre, at), MEDIUM)
        end = beyond(at, way, reach)
        self.sketch.line([at, end], StrokeKind.STRING)
        self.busy.append((at, end))
        self.sketch.wall(end, scaled(way, -1.0), 0.45)

    def stays(self, p: MassPoint, rotation: Rotation, point: tuple[float, float]) -> bool:
        """Whether a point of a body is fixed in space."""
        poses = (self.pose, *self.pose.others)
        places = [plus(x.at(p.position), in_space(x, rotation, point)) for x in poses]
        return all(math.dist(places[0], q) < 1e-7 for q in places)

    def track(self, p: MassPoint, rotation: Rotation, reaction: Reaction) -> None:
        """The part of the circle on which a wheel rolls that is near it."""
        known = self.system.shapes[p.name]
        if not known.radius or reaction.name in known.at:
            return
        touched = []
        for pose in (self.pose, *self.pose.others):
            point = reaction_point(pose, rotation, reaction, known)
            if point is None:
                return
            touched.append(plus(pose.at(p.position), point))
        if len(touched) > 3 and all(math.dist(touched[0], place) < SAME_SHAPE for place in touched):
            centre = self.system.page(self.pose.at(p.position))
            self.kerb(p, self.system.page(touched[0]), centre, known.radius * self.system.page.scale)
            return
        self._arc_around(touched, self.system.page(self.pose.at(p.position)))

    def _arc_around(self, touched: Sequence[FloatVector], body: PagePoint) -> bool:
        """The part of a fixed circle near a body that touches it, from the places touched in several positions."""
        centre = circle_through([place[:2] for place in touched])
        if centre is None:
            return False
        at, (x, y) = self.system.page((*centre, 0.0)), self.system.page(touched[0])
        turn, radius = math.atan2(y - at[1], x - at[0]), math.hypot(x - at[0], y - at[1])
        angles = [turn + (k - 16) * 0.06 for k in range(33)]
        points = [beyond(at, (math.cos(a), math.sin(a)), radius) for a in angles]
        self.sketch.ground(points[::-1] if apart(at, body) > radius else points)
        self.touched.append((x, y))
        return True


def circle_through(places: Sequence[tuple[float, float]]) -> tuple[float, float] | None:
    """The centre of the circle on which all places are; None if there is none, or fewer than four tell it."""
    if len(places) < 4:
        return None
    (a, b), *others = places
    rows = [(2 * (x - a), 2 * (y - b)) for x, y in others]
    sums = [x * x + y * y - a * a - b * b for x, y in others]
    pairs = [(m, n) for m in range(len(rows)) for n in range(m)]
    m, n = max(pairs, key=lambda mn: abs(rows[mn[0]][0] * rows[mn[1]][1] - rows[mn[0]][1] * rows[mn[1]][0]))
    try:
        u, v = solved([rows[m], rows[n]], [sums[m], sums[n]])
    except NoValueError:
        return None
    sizes = [math.dist((u, v), place) for place in places]
    return (u, v) if max(sizes) - min(sizes) < SAME_SHAPE else None
