"""The curves on which constraints keep particles and the ends of rods in a plane: wires, ground, ropes and rods.

What can only push is ground on the side on which the particle cannot be; a disc or box touches it with its outline, and
not with its centre.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial

from lagrange.document.scene import Box, PagePoint, StrokeKind
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.pictures.bearings import circle_through
from lagrange.pictures.floats import FloatVector, NoValueError, inner
from lagrange.pictures.limits import CURVE_STEP
from lagrange.pictures.loads import constraint_curve
from lagrange.pictures.poses import Pose
from lagrange.pictures.shapes import push_sense
from lagrange.pictures.sketch import Sketch, apart, beyond, in_line, left_of, same_ends, scaled, toward
from lagrange.pictures.systems import ROD, SystemPicture, is_string
from lagrange.pictures.views import PaperMap
from lagrange.problem.model import Keeper, Outline


@dataclass
class ConstraintCurves:
    """Draws the curves of one picture.

    busy    pieces along which a line is drawn
    places  of the particles and mass centres
    """

    system: SystemPicture
    sketch: Sketch
    busy: list[tuple[PagePoint, PagePoint]]
    places: dict[str, FloatVector]

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

    def draw(self) -> None:
        """Draw them, with ground on the side on which nothing can be."""
        if not self.system.view.planar:
            return
        points = [self.flat((0.0, 0.0, 0.0)), *(self.flat(p) for p in self.places.values())]
        for reaction in self.system.newton.reactions:
            if reaction.name in self.system.hidden:
                continue
            if self.system.is_rod(reaction) or reaction.directions is None or len(reaction.directions) != 1:
                continue
            [name] = reaction.directions
            p = next(x for x in self.system.configuration.points if x.name == name)
            row = next((r for r in self.system.configuration.rows if r.name == reaction.name), None)
            frame = Box.around(points).grown(1.5)
            if row is not None and name in {r.name for r in self.system.configuration.rotations}:
                self.under_end(p, reaction, row, frame)
            if row is None or name in {r.name for r in self.system.configuration.rotations}:
                continue
            curve = constraint_curve(self.pose, row, p.position, self.page, frame)
            if curve is not None:
                points_on_curve, closed = curve
                if not closed and in_line(points_on_curve[0], points_on_curve[1:]):
                    points_on_curve = [points_on_curve[0], points_on_curve[-1]]
                if self.tied(reaction, points_on_curve, self.flat(self.places[name])) or is_string(reaction):
                    continue  # a string is no wire along the curve on which it keeps something
                side = self.forbidden_side(reaction, row, points_on_curve)
                if side:
                    ring = [*points_on_curve, points_on_curve[0]] if closed else points_on_curve
                    ring = [*self.under(name, ring, side)]
                    self.sketch.ground(ring if side > 0 else ring[::-1])
                else:
                    self.sketch.line(points_on_curve, StrokeKind.CURVE, closed=closed)
                if in_line(points_on_curve[0], points_on_curve[1:]):
                    self.busy.append((points_on_curve[0], points_on_curve[-1]))

    def under_end(self, p: MassPoint, reaction: Reaction, row: Row, frame: Box) -> None:
        """The curve on which the end of a rod slides, or the rope that holds it.

        It is found where the rod is moved without turning, and believed if it is the same at another angle.
        """
        shape = self.system.problem.figure.shapes.get(p.name)
        own = {q for q in self.pose.coordinates if not p.position.fixed().partial(q).is_zero}
        if shape is None or not self.system.is_bare:
            return
        for end in shape.ends:
            with suppress(NoValueError):
                turning = [q for q in self.pose.coordinates if not end.fixed().partial(q).is_zero and q not in own]
                if len(turning) != 1 or row.finite is None:
                    continue
                ends = [self.flat(self.system.at(e)) for e in shape.ends]
                frame = Box.around([*ends, (frame.left, frame.bottom), (frame.right, frame.top)])
                curve = constraint_curve(self.pose, row, end, self.page, frame, but=turning)
                if curve is None or len(curve[0]) < 9 or in_line(curve[0][0], curve[0][1:]):
                    continue
                others = [constraint_curve(x, row, end, self.page, frame, but=turning) for x in self.pose.others]
                same = len(others) > 2 and all(c is not None and _lies_on(c[0], curve[0]) for c in others)
                if same and not self.tied(reaction, curve[0], self.flat(self.system.at(end))):
                    self.sketch.line(curve[0], StrokeKind.CURVE, closed=curve[1])

    def tied(self, reaction: Reaction, curve: Sequence[PagePoint], at: PagePoint) -> bool:
        """Draw the string or rod that keeps a place on a circle where the file calls it so; whether it does."""
        by = reaction.constraint.by
        called = is_string(reaction) or by is Keeper.ROD or (by is None and ROD.search(reaction.name))
        centre = circle_through(curve[:: max(len(curve) // 12, 1)]) if called else None
        if centre is None:
            return False
        field = self.system.down
        below = 0.0 if field is None else inner(toward(at, centre), self.page.way(self.pose.at(field)))
        if is_string(reaction) and below > 0 and self.system.problem.gravity is None:
            return True  # at rest, with forces as weights: a position in which it would not be taut
        if not any(same_ends((centre, at), other) for other in self.busy):
            self.sketch.line([centre, at], StrokeKind.STRING if is_string(reaction) else StrokeKind.ROD)
            self.busy.append((centre, at))
            self.sketch.hinge(centre)
        return True

    def forbidden_side(self, reaction: Reaction, row: Row, curve: Sequence[PagePoint]) -> int:
        """On which side of a curve its particle cannot be: 1 to the right of the way along it, −1 to the left, 0 if
        it may be on neither, as on a wire.
        """
        constraint = next((c for c in self.system.problem.constraints if c.name == row.name), None)
        if constraint is None or constraint.by in (Keeper.WIRE, Keeper.ROD, Keeper.STRING, Keeper.HINGE):
            return 0
        field = self.system.problem.gravity
        [name] = reaction.directions or ("",)
        force = reaction.per_unit(name)
        if force is None:
            return 0
        if constraint.side is not None:
            push = self.page.way(self.pose.at(force))
            push = scaled(push, push_sense(reaction))
        elif field is not None and constraint.by is Keeper.SURFACE:
            push = scaled(self.page.way(self.pose.at(field)), -1.0)
        else:
            return 0
        at = self.flat(self.places[name])
        here = min(range(len(curve) - 1), key=lambda n: apart(curve[n], at))
        left = left_of(toward(curve[here], curve[here + 1]))
        return 1 if left[0] * push[0] + left[1] * push[1] > 0 else -1

    def under(self, name: str, curve: Sequence[PagePoint], side: int) -> Sequence[PagePoint]:
        """The curve of a centre moved to where the outline of its disc or box touches: to the right if side is 1."""
        shape = self.system.problem.figure.shapes.get(name)
        if shape is None or not shape.lengths:
            return curve
        sizes = [abs(self.system.number(x)) * self.page.scale for x in shape.lengths]
        moved = []
        for n, at in enumerate(curve):
            way = toward(curve[max(n - 1, 0)], curve[min(n + 1, len(curve) - 1)])
            x, y = scaled(left_of(way), -side)
            reach = (sizes[0] * abs(x) + sizes[1] * abs(y)) / 2 if shape.kind is Outline.BOX else sizes[0]
            moved.append(beyond(at, (x, y), reach))
        return moved


def _lies_on(points: Sequence[PagePoint], curve: Sequence[PagePoint]) -> bool:
    """Whether points lie on a curve of short pieces."""
    return all(min(map(partial(apart, at), curve)) < CURVE_STEP for at in points[::9])
