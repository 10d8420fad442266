"""The picture of a system in a general position: axes, rods, springs, bodies, curves, loads, coordinates, gravity.

Lines are drawn first and labels placed last, when everything they have to avoid is known. `busy` collects the straight
lines drawn so far, so that coordinates and links do not draw a second line on top of one.
"""

from __future__ import annotations

import math
import re
from collections.abc import Container, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import UnitVector, t
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import Notation
from lagrange.document.scene import PagePoint, Scene, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.dynamics.free_bodies import Rod
from lagrange.pictures.bearings import Supports, slots
from lagrange.pictures.blocks import FLOOR, WALL, Blocks, is_vehicle, mark_slopes
from lagrange.pictures.coordinate_drawings import CoordinateDrawings
from lagrange.pictures.declared import DeclaredParts
from lagrange.pictures.floats import FloatVector, NoValueError, inner, plus
from lagrange.pictures.implied.body_shapes import has_axle, is_bar, with_implied_shapes
from lagrange.pictures.implied.curves import ConstraintCurves
from lagrange.pictures.implied.directions import draw_directions
from lagrange.pictures.implied.guides import couplers, cylinders_touched, hoops, ropes_to_supports, struts
from lagrange.pictures.implied.halves import halves
from lagrange.pictures.implied.lengths import Lengths
from lagrange.pictures.implied.lettered import lettered, rods_between_letters
from lagrange.pictures.implied.rods_at_rest import around as around_rods
from lagrange.pictures.implied.rods_at_rest import draw_rods
from lagrange.pictures.implied.turning_guides import draw_guides, radius_of_disc, turning_guides
from lagrange.pictures.inferred import Inferred, fulcrum, rail
from lagrange.pictures.joints import holds
from lagrange.pictures.limits import LONGEST_ROD_LABEL, SAME_ON_PAGE
from lagrange.pictures.linkages import links
from lagrange.pictures.loads import ARROW, Arrows, as_words, force_label
from lagrange.pictures.shapes import in_space, plane_rotation
from lagrange.pictures.sketch import (
    BAR,
    HINGE,
    NEAR,
    PARTICLE,
    LabelRequest,
    Sketch,
    apart,
    beyond,
    farthest,
    in_line,
    left_of,
    lies_on,
    overlapping,
    same_ends,
    scaled,
    touches,
    toward,
)
from lagrange.pictures.solids import Solids
from lagrange.pictures.springs_dampers import SpringsDampers
from lagrange.pictures.surfaces import InSpace, constraints_in_space
from lagrange.pictures.systems import ROD, SystemPicture, is_string, rod_ends
from lagrange.problem.model import BodyShape, Drawn, Outline

_FIXED = tuple(Vector(tuple(sp.Integer(m == n) for m in range(3))) for n in range(3))
LETTER = re.compile(r"[A-Z]\d*|[a-z]")
"""The name of a point that is no word."""
ELLIPSOID = (0.75, 0.55, 0.4)
"""Semi-axes of a body of which nothing is known, in centimetres."""


def configuration_scene(system: SystemPicture, notation: Notation, with_loads: bool) -> Scene | None:
    """The picture, with applied forces if `with_loads`; None if it cannot be drawn sensibly."""
    for inferred in (True, False):  # what is inferred may leave no room for a label
        try:
            implied = with_implied_shapes(system)
            in_space = constraints_in_space(implied)
            compass = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
            circles = [*hoops(implied), *cylinders_touched(implied), *halves(implied)]
            circles += [((0.0, 0.0, 0.0), radius_of_disc(implied, [*turning_guides(implied)]))]
            ropes = [end for end, _ in ropes_to_supports(implied)]
            rods = around_rods(implied.problem, implied.pose, implied.rods_at_rest)
            around = (
                *in_space.places,
                *ropes,
                *rods,
                *(plus(c, (r * x, r * y, 0.0)) for c, r in circles for x, y in compass),
            )
            drawing = _Drawing(replace(implied, around=around) if inferred else implied, in_space)
            drawing.all(with_loads, inferred)
        except NoValueError:
            return None
        scene = drawing.sketch.scene(notation)
        if scene is not None:
            return scene
    return None


class _Drawing:
    """One picture."""

    def __init__(self, system: SystemPicture, in_space: InSpace) -> None:
        self.in_space = in_space
        self.system = system
        self.pose = system.pose
        self.page = system.page
        self.sketch = Sketch()
        self.places = {p.name: self.pose.at(p.position) for p in system.configuration.points}
        self.origin = self.page((0.0, 0.0, 0.0))
        self.mounts: list[PagePoint] = []
        self.busy: list[tuple[PagePoint, PagePoint]] = []
        self.links = links(system)
        self.boards: Mapping[str, PagePoint] = {}
        self.weighs = False
        self.supports = Supports(system, self.sketch, self.busy, (), self.downward)

    def all(self, with_loads: bool, with_inferred: bool) -> None:
        self.weighs = with_loads and "loads" not in self.hidden
        declared = DeclaredParts(self.system, self.sketch, self.busy)
        declared.all()
        self.rods()
        for ends in self.links.rods if "constraints" not in self.hidden else ():
            start, end = map(self.flat, ends)
            self.sketch.line([start, end], StrokeKind.ROD)
            self.busy.append((start, end))
            self.sketch.hinge(start)
        if with_inferred and "constraints" not in self.hidden:
            self.guides()
        inferred = Inferred(self.system, self.sketch, self.busy)
        if with_inferred:
            inferred.all()
        for pivot in inferred.pivots:
            self.sketch.hinge(pivot)
            self.mounts.append(pivot)
        blocks = Blocks(self.system, self.sketch, self.busy, self.downward, inferred.corners)
        if with_inferred:
            blocks.boxes()
            self.boards = blocks.boards
        pins = slots(self.system, self.sketch) if with_inferred and "constraints" not in self.hidden else ()
        self.supports = Supports(self.system, self.sketch, self.busy, pins, self.downward, boards=blocks.tops)
        self.bodies(drawn=blocks.half)
        if with_inferred and not with_loads and "loads" not in self.hidden:
            self.supports.threads()
        if with_inferred and "constraints" not in self.hidden:
            self.supports.under_several()
        if with_inferred:
            blocks.grounds()
        if with_inferred and WALL.search(self.system.text) and FLOOR.search(self.system.text):
            self.sketch.join_corner()
        springs = SpringsDampers(self.system, self.sketch, self.busy)
        springs.draw(blocks.half)
        self.mounts += list(dict.fromkeys(at for at, _ in springs.mounted))
        self.mounts += [at for at in self.supports.mounts if all(apart(at, m) > SAME_ON_PAGE for m in self.mounts)]
        self.supports_of_rods(springs.mounted)
        if "constraints" not in self.hidden:
            ConstraintCurves(self.system, self.sketch, self.busy, self.places).draw()
            if with_inferred:
                self.in_space.draw(self.system, self.sketch)
        self.sketch.cut_grounds([*self.supports.touched, *map(self.flat, self.places.values())])
        declared.points(self.called)
        self.particles()
        arrows = Arrows(self.system, self.sketch, self.places)
        if with_loads and "loads" not in self.hidden:
            arrows.loads()
        elif "loads" not in self.hidden:
            arrows.given()
        if "loads" not in self.hidden:
            arrows.moments()
        arrows.impulses()
        declared.marks()
        if with_inferred:
            mark_slopes(self.system, self.sketch, self.downward)
        coordinates = CoordinateDrawings(self.system, self.sketch, self.busy, self.places, self.links)
        coordinates.all()
        if "axes" not in self.hidden:
            self.axes(coordinates.feet)
        Lengths(self.system, self.sketch, self.busy).all()
        draw_directions(self.system, self.sketch, self.busy)
        self.masses()
        if "gravity" not in self.hidden:
            arrows.gravity()
        if "origin" not in self.hidden:
            self.name_origin()

    @property
    def hidden(self) -> frozenset[str]:
        """The names of everything that is not drawn."""
        return self.system.hidden

    def flat(self, place: FloatVector) -> PagePoint:
        return self.page(place)

    @property
    def in_line(self) -> bool:
        """Whether the whole system is on one line."""
        return len(self.system.view.shown) == 1

    # The parts of the system

    def axes(self, feet: Sequence[PagePoint]) -> None:
        """The unit vectors; an axis goes on, thinly, to the coordinates that begin on it."""
        units = self.system.view.units
        for n in self.system.view.shown:
            way = toward((0.0, 0.0), units[n])
            size = ARROW * (math.hypot(*units[n]) if not self.system.view.planar else 1.0)
            start = beyond(self.origin, left_of(way), 0.95) if self.in_line else self.origin
            end = beyond(start, way, size)
            self.sketch.arrow(start, end, StrokeKind.AXIS)
            self.sketch.label(UnitVector("ijk"[n]), end, way, optional=True)
            if not self.in_line:
                reached = [on for foot in feet if (on := _along_axis(foot, self.origin, way)) is not None]
                for far in (max(reached, default=0.0), min([0.0, *reached])):
                    if far > size or far < 0:
                        begin = end if far > 0 else start
                        self.sketch.line([begin, beyond(start, way, far)], StrokeKind.REFERENCE)

    def rods(self) -> None:
        for reaction, rod in self.system.rods:
            if {"constraints", reaction.name} & self.hidden:
                continue
            first, second = (self.flat(p) for p in rod_ends(rod, self.system.configuration, self.pose))
            self.sketch.line([second, first], StrokeKind.STRING if is_string(reaction) else StrokeKind.ROD)
            self.busy.append((second, first))
            if not rod.ends[1]:
                self.sketch.hinge(second)
                if self.stands(rod):
                    self.mounts.append(second)
            if count_operations(rod.length) <= LONGEST_ROD_LABEL:
                self.sketch.label_beside(rod.length, second, first, optional=True)

        for a, b, by_constraints in self.system.kept_distances:
            if by_constraints and not self.system.is_surface_between(a, b):
                start, end = self.flat(self.places[a]), self.flat(self.places[b])
                self.sketch.line([start, end], StrokeKind.ROD)
                self.busy.append((start, end))

    def guides(self) -> None:
        """Hoops, fixed cylinders, couplers, struts and rods at rest that the coordinates and the words show."""
        rods_at_rest, problem = self.system.rods_at_rest, self.system.problem
        self.mounts += draw_rods(problem, self.pose, rods_at_rest, self.page, self.sketch, self.busy)
        for centre, radius in cylinders_touched(self.system):
            self.sketch.circle(self.flat(centre), radius * self.page.scale, 2)
        for centre, radius in hoops(self.system):
            self.sketch.circle(self.flat(centre), radius * self.page.scale, 0)
        rods = [(*ends, False) for ends in couplers(self.system)]
        for first, second, string in (*rods, *struts(self.system)):
            ends = self.flat(first), self.flat(second)
            if not any(same_ends(ends, other) for other in self.busy):
                self.sketch.line([*ends], StrokeKind.STRING if string else StrokeKind.ROD)
                self.busy.append(ends)
        for first, _, _ in rods:
            self.sketch.hinge(self.flat(first))
        for support, ring in ropes_to_supports(self.system):
            ends = self.flat(support), self.flat(ring)
            self.sketch.line([*ends], StrokeKind.STRING)
            self.busy.append(ends)
            self.sketch.hinge(ends[0])
            self.mounts.append(ends[0])
        self.between_letters()
        self.mounts += draw_guides(self.system, self.sketch, self.busy)

    def between_letters(self) -> None:
        """Rods whose ends have letters in the text; a fixed end is held."""
        points = lettered(self.system.problem, self.system.configuration)
        turning = [p for p in self.system.configuration.points if plane_rotation(self.system.configuration, p.name)]
        for a, b, rope in rods_between_letters(self.system.problem, self.pose) if self.system.is_bare else ():
            ends = self.flat(self.pose.at(points[a])), self.flat(self.pose.at(points[b]))
            of_body = any(
                all(holds(self.pose, p, lambda x, v=points[n]: x.at(v)) for n in (a, b))  # type: ignore[misc]
                for p in turning
            )
            if of_body or any(overlapping(ends, other) for other in self.busy):
                continue
            self.sketch.line([*ends], StrokeKind.STRING if rope else StrokeKind.ROD)
            self.busy.append(ends)
            for name, end in zip((a, b), ends, strict=True):
                self.sketch.hinge(end)
                self.mounts += [end] if self.is_fixed(points[name]) else []

    def stands(self, rod: Rod) -> bool:
        """Whether the centre of a rod is fixed."""
        assert rod.centre is not None
        return self.is_fixed(rod.centre)

    def is_fixed(self, place: Vector) -> bool:
        """Whether a place is at rest in space."""
        moving = {*self.system.configuration.slots.coordinates, *self.system.configuration.slots.prescribed, t}
        return not any(c.free_symbols & moving for c in place.fixed().components)

    def supports_of_rods(self, springs: Sequence[tuple[PagePoint, PagePoint]]) -> None:
        """What holds the fixed ends: a piece of ground, on the other side than the lines that meet there."""
        for line in self.system.problem.figure.lines:
            if line.kind is Drawn.SUPPORTS:
                at = self.flat(self.system.at(line.places[0]))  # type: ignore[arg-type]
                self.sketch.hinge(at)
                self.mounts.append(at)
        field = self.system.problem.gravity
        down = (0.0, 0.0) if field is None else self.page.way(self.pose.at(field))
        for at in self.mounts:
            ways = [toward(at, b if apart(a, at) < apart(b, at) else a) for a, b in self.busy if touches(at, a, b)]
            x, y = sum(w[0] for w in ways), sum(w[1] for w in ways)
            pulled = [link for link in springs if apart(at, link[0]) < SAME_ON_PAGE]
            sideways = 0.3 if WALL.search(self.system.text) else 2.0
            if pulled and len(ways) == len(pulled) and abs(x) > sideways * abs(y):
                inward = (math.copysign(1.0, x), 0.0)
            elif math.hypot(*down) > 1e-6:
                along = toward((0.0, 0.0), down)
                inward = along if x * along[0] + y * along[1] >= -1e-6 else scaled(along, -1.0)
            elif math.hypot(x, y) < 1e-6:
                inward = (0.0, -1.0)  # an axle, seen along it
            elif abs(x) > abs(y):
                inward = (math.copysign(1.0, x), 0.0)
            else:
                inward = (0.0, math.copysign(1.0, y))
            self.sketch.wall(beyond(at, inward, -HINGE), inward, 0.36)

    @property
    def downward(self) -> PagePoint:
        """The direction of gravity on the page; to the bottom of the page where none is given."""
        field = self.system.down
        down = (0.0, -1.0) if field is None else self.page.way(self.pose.at(field))
        return toward((0.0, 0.0), down) if math.hypot(*down) > 1e-6 else (0.0, -1.0)

    def bodies(self, drawn: Container[str]) -> None:
        """The rigid bodies that are not drawn as blocks."""
        for p in self.system.configuration.points:
            if p.name in drawn:
                continue
            rotation = plane_rotation(self.system.configuration, p.name)
            shape = self.system.problem.figure.shapes.get(p.name)
            if shape is not None:
                self.declared_body(p, shape)
            elif p.name in self.hidden:
                continue
            elif rotation is not None and self.system.view.planar:
                self.plane_body(p, rotation)
            else:
                turning = [r for r in self.system.configuration.rotations if r.name == p.name]
                for r in turning:
                    if self.system.paths and self.system.is_hoop(p.name):
                        continue  # the circle of what is on it
                    if self.system.is_bare and not self.system.view.planar:
                        self.ellipsoid(p, r)
                    self.triad(p, r)

    def declared_body(self, p: MassPoint, shape: BodyShape) -> None:
        """A body whose shape the file gives."""
        turning = next((r for r in self.system.configuration.rotations if r.name == p.name), None)
        axes = _FIXED if turning is None else turning.axes
        centre = self.places[p.name]
        number = 2 if turning is None else turning.inertia.symmetry_axis
        if turning is not None and shape.kind is Outline.DISC and has_axle(self.system, p, turning):
            self.axle(p)
        Solids(self.system, self.sketch).shape(shape, centre, [self.pose.at(a) for a in axes], number)
        if shape.ends:
            first, second = (self.flat(self.system.at(end)) for end in shape.ends)
            self.busy.append((first, second))
        elif ROD.search(self.system.text) and self.system.is_bare:
            self.arms(p, abs(self.system.number(shape.lengths[0])))
        rotation = plane_rotation(self.system.configuration, p.name)
        round_ = shape.kind in (Outline.DISC, Outline.RING, Outline.SPHERE)
        if rotation is not None and self.system.view.planar and round_:
            radius = abs(self.system.number(shape.lengths[0])) * self.page.scale
            e1 = toward((0, 0), self.page.way(self.pose.at(rotation.axes[0])))
            self.sketch.line([self.flat(centre), beyond(self.flat(centre), e1, radius)], StrokeKind.REFERENCE)
        if rotation is not None and self.system.view.planar and "constraints" not in self.hidden:
            self.supports.draw(p, rotation)
        if rotation is not None and self.system.view.planar and self.system.is_bare:
            self.joints(p)
        if rotation is not None and self.system.view.planar and self.system.is_bare and self.is_fixed(p.position):
            self.pivot(self.flat(centre), round_)
        self.sketch.dot(self.flat(centre), 0.05)

        if rotation is None and shape.kind is Outline.BOX and self.system.is_bare:
            self.rail(p, self.system.number(shape.lengths[0]), self.system.number(shape.lengths[1]))

    def axle(self, p: MassPoint) -> None:
        """The axle of a disc that turns about O at its other end."""
        centre = self.flat(self.places[p.name])
        self.sketch.line([self.origin, centre], StrokeKind.ROD)
        self.busy.append((self.origin, centre))
        self.sketch.hinge(self.origin)
        if inner(toward(self.origin, centre), self.downward) < 0.5:  # it stands, and does not hang
            fulcrum(self.sketch, self.origin, self.downward)

    def arms(self, p: MassPoint, radius: float) -> None:
        """The rods from a disc or ball to the points outside it at which it is joined."""
        for joint in self.system.joints.get(p.name, ()):
            away = math.dist(joint, self.places[p.name])
            if away > radius + SAME_ON_PAGE:
                ends = self.flat(joint), self.flat(self.places[p.name])
                self.sketch.line([*ends], StrokeKind.ROD)
                self.busy.append(ends)

    def joints(self, p: MassPoint) -> None:
        """The hinges of a plane body; fixed ones are attached to the ground."""
        shape = self.system.problem.figure.shapes.get(p.name)
        ends = [self.system.at(end) for end in shape.ends] if shape is not None and shape.ends else []
        for joint in self.system.joints.get(p.name, ()):
            at = self.flat(joint)
            if len(ends) == 2 and not lies_on(at, *map(self.flat, ends)):
                self.bowl(joint, ends)
                continue
            if self.system.is_touched(p.name, joint):
                continue
            self.sketch.hinge(at)
            fixed = any(math.dist(joint, pivot) < SAME_ON_PAGE for pivot in self.system.pivots)
            if fixed and all(apart(at, m) > SAME_ON_PAGE for m in self.mounts):
                self.mounts.append(at)

    def bowl(self, centre: FloatVector, ends: Sequence[FloatVector]) -> None:
        """The inside of a bowl or hoop on which both ends of a rod slide."""
        first, second = (math.dist(centre, end) for end in ends)
        if abs(first - second) > SAME_ON_PAGE or not self.system.is_inside:
            return
        at, down = self.flat(centre), self.downward
        side, radius, half = left_of(down), first * self.page.scale, math.pi / 2 if self.system.is_bowl else math.pi
        ways = (half * n / 48 for n in range(-48, 49))
        arc = [beyond(beyond(at, down, radius * math.cos(a)), side, radius * math.sin(a)) for a in ways]
        self.sketch.line(arc, StrokeKind.CURVE)

    def rail(self, p: MassPoint, width: float, height: float) -> None:
        """The ground under a box whose coordinates leave it on one level."""
        field = self.system.problem.gravity
        if field is None or not self.system.view.planar or self.system.reactions_on(p.name):
            return
        down = toward((0.0, 0.0), self.page.way(self.pose.at(field)))
        levels = [inner(self.page(x.at(p.position)), down) for x in (self.pose, *self.pose.others)]
        if self.is_fixed(p.position) or max(levels) - min(levels) > 1e-6:
            return
        at = self.flat(self.places[p.name])
        scale = self.page.scale
        rail(self.sketch, beyond(at, down, abs(height) * scale / 2), down, abs(width) * scale / 2 + 0.9, self.busy)

    def pivot(self, at: PagePoint, is_wheel: bool) -> None:
        """What holds a body that turns about its fixed centre."""
        field = self.system.problem.gravity
        down = (0.0, -1.0) if field is None else self.page.way(self.pose.at(field))
        if any(apart(at, h) < 1e-3 for h in self.sketch.hinges) or math.hypot(*down) < 1e-6:
            return
        self.sketch.hinge(at)
        if is_wheel:
            self.mounts.append(at)
        elif field is not None or all(q.mass == 0 for q in self.system.configuration.points):  # not seen from above
            fulcrum(self.sketch, at, toward((0.0, 0.0), down))
        else:
            self.mounts.append(at)

    def plane_body(self, p: MassPoint, rotation: Rotation) -> None:
        centre = self.flat(self.places[p.name])
        known = self.system.shapes[p.name]
        held = [self.flat(plus(self.places[p.name], in_space(self.pose, rotation, h))) for h in known.held]
        self.joints(p)
        if self.supports.outline(p):
            self.sketch.dot(centre, 0.06)
            self.supports.draw(p, rotation)
            return
        more = (self.system.joints, self.system.carried, self.system.fastened, self.links.held)
        held += [self.flat(place) for places in more for place in places.get(p.name, ())]
        if known.radius:
            radius = known.radius * self.page.scale
            self.sketch.ellipse(centre, (radius, 0.0), (0.0, radius))
            e1 = self.page.way(self.pose.at(rotation.axes[0]))
            self.sketch.line([centre, beyond(centre, toward((0, 0), e1), radius)], StrokeKind.GUIDE)
        elif held and in_line(centre, held):
            a, b = farthest([centre, *held])
            self.sketch.capsule(a, b, BAR)
            self.busy.append((a, b))
        elif held and is_bar(self.system, p.name):  # bent
            for end in held:
                self.sketch.capsule(centre, end, BAR)
                self.busy.append((centre, end))
        elif len(held) == 2:
            self.on_two_feet(p.name, centre, held)
        elif held:
            way = toward(centre, held[0])
            reach = max(apart(centre, h) for h in held) + 0.18
            self.sketch.ellipse(centre, (way[0] * reach, way[1] * reach), scaled(left_of(way), 0.6 * reach))
        elif self.system.configuration.rows:
            self.triad(p, rotation)
        else:
            e1 = toward((0, 0), self.page.way(self.pose.at(rotation.axes[0])))
            self.sketch.ellipse(centre, scaled(e1, 0.62), scaled(left_of(e1), 0.36))
        self.sketch.dot(centre, 0.06)
        if (held or known.radius) and self.system.is_bare and self.is_fixed(p.position):
            self.pivot(centre, known.radius > 0)
        for link in self.links.held.get(p.name, ()):
            self.sketch.hinge(self.flat(link))
        self.supports.draw(p, rotation)

    def on_two_feet(self, name: str, centre: PagePoint, feet: Sequence[PagePoint]) -> None:
        """A body that is held at two points which are in no line with its mass centre: a box from there up."""
        along = toward(*feet)
        high = inner((centre[0] - feet[0][0], centre[1] - feet[0][1]), left_of(along))
        up, high = (left_of(along), high) if high > 0 else (scaled(left_of(along), -1.0), -high)
        low = min(0.35 * high, 0.22) if is_vehicle(name) else 0.0
        corners = [beyond(beyond(foot, along, out), up, y) for y, order in ((low, 1), (1.7 * high, -1))
                   for foot, out in list(zip(feet, (-0.3, 0.3), strict=True))[::order]]  # fmt: skip
        for foot in feet if low else ():
            self.sketch.circle(beyond(foot, up, low), low, 3)
        self.sketch.face(corners, 2)

    def ellipsoid(self, p: MassPoint, rotation: Rotation) -> None:
        """A body of which nothing more is known; its outline on the page is an ellipse with the matrix Σ a² u uᵀ."""
        c = self.flat(self.places[p.name])
        ways = [scaled(self.page.way(self.pose.at(a)), s) for a, s in zip(rotation.axes, ELLIPSOID, strict=True)]
        xx, xy, yy = (sum(w[i] * w[j] for w in ways) for i, j in ((0, 0), (0, 1), (1, 1)))
        first = (math.sqrt(xx), xy / math.sqrt(xx))
        turns = [(math.cos(s), math.sin(s)) for s in (2 * math.pi * k / 48 for k in range(48))]
        second = math.sqrt(max(yy - first[1] ** 2, 0.0))
        self.sketch.face([(c[0] + a * first[0], c[1] + a * first[1] + b * second) for a, b in turns], 2)

    def triad(self, p: MassPoint, rotation: Rotation) -> None:
        """The axes of a body with their names, except those that are i, j or k."""
        centre = self.flat(self.places[p.name])
        body = next(b for b in self.system.problem.bodies if b.name == p.name)
        for n, axis in enumerate(rotation.axes):
            if not axis.fixed().as_sum().free_symbols - set(axis.fixed().triad.units):
                continue
            x, y = self.page.way(self.pose.at(axis))
            if math.hypot(x, y) < 0.15 and self.system.view.planar:
                continue
            if math.hypot(x, y) < 0.15:
                raise NoValueError("an axis points at the reader")
            end = (centre[0] + x * 0.95, centre[1] + y * 0.95)
            self.sketch.arrow(centre, end, StrokeKind.BODY)
            name = body.axes_called[n] if body.axes_called else f"e_{n + 1}"
            self.sketch.label(UnitVector(name), end, toward(centre, end))
        self.sketch.dot(centre, PARTICLE)

    def particles(self) -> None:
        turning = {r.name for r in self.system.configuration.rotations}
        lines = [piece for line in self.sketch.lines for piece in line.pieces]
        for p in self.system.configuration.points:
            at = self.flat(self.places[p.name])
            if p.name in self.hidden:
                continue
            at = self.boards.get(p.name, at)
            if p.name not in turning and p.name not in self.system.problem.figure.shapes and p.name not in self.boards:
                self.sketch.dot(at)
            # The name goes opposite to the lines that meet at the particle.
            ways = [toward(at, b if apart(a, at) < apart(b, at) else a) for a, b in lines if touches(at, a, b)]
            x, y = -sum(w[0] for w in ways), -sum(w[1] for w in ways)
            prefer = toward((0, 0), (x, y)) if math.hypot(x, y) > 1e-3 else (0.7, 0.7)
            if not self.is_between_letters(p.name):
                self.sketch.label(self.called(p.name), at, prefer, clear=PARTICLE, optional=True)

    def called(self, name: str) -> sp.Expr | str:
        """The letter of a point; in the place of a word, the mass that nothing else has and no weight arrow shows."""
        masses = {p.name: self.mass(p) for p in self.system.configuration.points}
        mass = masses.get(name)
        if mass is None or LETTER.fullmatch(name) or [*masses.values()].count(mass) > 1:
            return as_words(name)
        return as_words(name) if self.weighs and self.is_weighed(name, mass) else mass

    def is_weighed(self, name: str, mass: sp.Expr) -> bool:
        """Whether the arrow of a force on a body shows its mass."""
        labels = (force_label(f, "") for f in self.system.configuration.loads if f.on == name)
        return any(isinstance(label, sp.Expr) and label.free_symbols & mass.free_symbols for label in labels)

    def mass(self, p: MassPoint) -> sp.Expr | None:
        """The mass of a particle or body, or the moment of inertia of one that only turns, if it is a letter."""
        turning = plane_rotation(self.system.configuration, p.name)
        size = p.mass if p.mass != 0 or turning is None else turning.inertia.moments[2]
        own = {s.symbol for s in self.system.problem.parameters}
        return size if size.free_symbols and size.free_symbols <= own and count_operations(size) <= 1 else None

    def masses(self) -> None:
        """The masses that no label has yet, at their particles and bodies."""
        written = {s for w in self.sketch.wanted if isinstance(w.content, sp.Expr) for s in w.content.free_symbols}
        for p in self.system.configuration.points:
            mass = self.mass(p)
            if mass is not None and p.name not in self.hidden and not mass.free_symbols & written:
                at = self.boards.get(p.name, self.flat(self.places[p.name]))
                self.sketch.wanted.append(LabelRequest(mass, ((at, (0.7, -0.7)),), PARTICLE, True, reaches=NEAR[:3]))

    def is_between_letters(self, name: str) -> bool:
        """Whether a particle is the centre of the rod BC between two points that have their letters."""
        return len(name) == 2 and {*name} <= {*self.system.figure_places, *self.places}

    def name_origin(self) -> None:
        units = [u for n, u in enumerate(self.system.view.units) if n in self.system.view.shown]
        away = (-sum(u[0] for u in units), -sum(u[1] for u in units))
        if not self.in_line and "axes" not in self.hidden:
            self.sketch.label("O", self.origin, toward((0, 0), away), clear=0.05, optional=True)


def _along_axis(foot: PagePoint, origin: PagePoint, way: PagePoint) -> float | None:
    """The distance of a point on an axis from the origin; None if it is not on it."""
    x, y = foot[0] - origin[0], foot[1] - origin[1]
    return x * way[0] + y * way[1] if abs(x * way[1] - y * way[0]) < 1e-3 else None
