"""The shapes of bodies, and circles, from the viewpoint of the picture.

A circle with radius R about the axis a is R (u cos s + v sin s) with u, v perpendicular to a: on the page an ellipse. A
sphere is a circle with its equator, of which the half that is hidden is dashed. A cone is the convex hull of its tip
and its rim. Insides are filled lightly, so that they hide what is behind them.

Shapes of bodies whose file gives none, from what it does give: the moments of inertia about the mass centre.

A uniform disc has m R²/2, a ring m R², a sphere 2/5 m R², a shell 2/3 m R², a rod of length 2a has m a²/3 and one of
length l has m l²/12, across. So the number in front of m times a square tells the shape, and the square its size. A rod
lies along the line from its mass centre to a point at which it is held. A body that the text calls a top, with its mass
centre on its axis of symmetry at a constant distance from O, is a cone with its tip there.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

import sympy as sp

from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.pictures.floats import FloatVector, NoValueError, inner, outer, plus, unit
from lagrange.pictures.limits import SAME_ON_PAGE
from lagrange.pictures.shapes import coordinates_in_body, plane_rotation
from lagrange.pictures.sketch import Sketch, apart, beyond
from lagrange.pictures.systems import SystemPicture, is_string
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
                    self.sketch.capsule(page(a), page(b), 0.09)
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


# Implied shapes


_ROUND = {sp.Rational(1, 2): Outline.DISC, sp.Rational(2, 5): Outline.SPHERE, sp.Rational(2, 3): Outline.SPHERE}
_HALF_LENGTH = {sp.Rational(1, 3): sp.Integer(1), sp.Rational(1, 12): sp.Rational(1, 2)}
_RING = re.compile(r"hoop|\bring\b|\brim\b|wheel", re.IGNORECASE)
_TOP = re.compile(r"\btops?\b|gyroscope|spinning", re.IGNORECASE)
_ROTOR = re.compile(r"disc|disk|wheel|rotor", re.IGNORECASE)
_PULLEY = re.compile(r"\b(pulley|drum|wheel|winch|capstan|cylinder|disc|disk)s?\b", re.IGNORECASE)
_WIDE = sp.Rational(9, 20)
"""Radius of a top that is drawn as a cone, as a part of its height."""


def with_implied_shapes(system: SystemPicture) -> SystemPicture:
    """The system with a shape for every body whose moments of inertia tell one; not where the file draws lines."""
    if not system.is_bare:
        return system
    figure = system.problem.figure
    implied = dict(figure.shapes)
    for p in system.configuration.points:
        rotation = next((r for r in system.configuration.rotations if r.name == p.name), None)
        if rotation is None or p.name in implied:
            continue
        with suppress(NoValueError):
            shape = _plane(system, p) if plane_rotation(system.configuration, p.name) else _space(system, p, rotation)
            if shape is not None:
                implied[p.name] = shape
    if len(implied) == len(figure.shapes):
        return system
    return replace(system, problem=replace(system.problem, figure=replace(figure, shapes=implied)))


def ratio(moment: sp.Expr, mass: sp.Expr) -> tuple[sp.Rational, sp.Expr] | None:
    """A moment of inertia as number · mass · length²; None if it is no such product."""
    if mass == 0 or moment == 0:
        return None
    number, rest = sp.cancel(moment / mass).as_coeff_Mul()
    length = sp.sqrt(rest)
    if not isinstance(number, sp.Rational) or not rest.free_symbols or not _is_product(length):
        return None
    return number, length


def _is_product(length: sp.Expr) -> bool:
    return all(f.is_Symbol or f.is_number for f in sp.Mul.make_args(length))


def _plane(system: SystemPicture, p: MassPoint) -> BodyShape | None:
    rotation = plane_rotation(system.configuration, p.name)
    assert rotation is not None
    if system.shapes[p.name].radius:
        return None  # its contact says so already
    known = ratio(rotation.inertia.moments[2], p.mass)
    if known is None or known[0] not in {*_ROUND, *_HALF_LENGTH, sp.S.One}:
        radius = _rim(system, rotation)
        return None if radius is None else BodyShape(Outline.DISC, (radius,))
    number, length = known
    if number in _ROUND:
        return BodyShape(_ROUND[number], (length,))
    if number == 1 and _RING.search(system.text):
        return BodyShape(Outline.RING, (length,))
    if number not in _HALF_LENGTH:
        return None
    way = _along(system, p, rotation)
    if way is None:
        return None
    half = length * _HALF_LENGTH[number]
    return BodyShape(Outline.ROD, (), (p.position.fixed() - way * half, p.position.fixed() + way * half))


def _rim(system: SystemPicture, rotation: Rotation) -> sp.Expr | None:
    """The radius R of a pulley, as far as a string says it by x' = R φ'; None for any other body."""
    coordinates = system.configuration.slots.coordinates
    turning = rotation.axes[0].fixed().as_sum().free_symbols & {*coordinates}
    for reaction in system.newton.reactions if _PULLEY.search(system.text) else ():
        if not is_string(reaction) or len(reaction.row.coefficients) != len(coordinates):
            continue
        used = {q: a for q, a in zip(coordinates, reaction.row.coefficients, strict=True) if a != 0}
        angle = turning & {*used}
        if len(used) == 2 and len(angle) == 1:
            [q] = angle
            [other] = {*used} - angle
            return sp.Abs(sp.cancel(used[q] / used[other]))
    return None


def _along(system: SystemPicture, p: MassPoint, rotation: Rotation) -> Vector | None:
    """The unit vector along a rod: towards the points at which it is held, or else its first axis."""
    held = list(system.shapes[p.name].held)
    places = [*system.joints.get(p.name, ()), *system.marked.get(p.name, ()), *system.fastened.get(p.name, ())]
    held += [coordinates_in_body(system.pose, rotation, p.position, place) for place in places]
    held = [h for h in held if math.hypot(*h) > SAME_ON_PAGE]
    e1, e2 = rotation.axes[0].fixed(), rotation.axes[1].fixed()
    if not held:
        return e1
    x, y = max(held, key=lambda h: math.hypot(*h))
    if any(abs(x * b - y * a) > SAME_ON_PAGE for a, b in held):
        return None  # they are on no line
    size = math.hypot(x, y)
    parts = [sp.Integer(round(c)) if abs(c - round(c)) < SAME_ON_PAGE else sp.Float(c) for c in (x / size, y / size)]
    along: Vector = e1 * parts[0] + e2 * parts[1]
    return along


def _space(system: SystemPicture, p: MassPoint, rotation: Rotation) -> BodyShape | None:
    moments = rotation.inertia.moments
    known = [ratio(moment, p.mass) for moment in moments]
    if all(known) and len({*known}) == 1 and known[0] is not None and known[0][0] in (_FIFTHS, sp.Rational(2, 3)):
        return BodyShape(Outline.SPHERE, (known[0][1],))
    axis = rotation.inertia.symmetry_axis
    own = known[axis]
    if own is not None and own[0] == sp.Rational(1, 2):
        return BodyShape(Outline.DISC, (own[1],))
    if own is not None and own[0] == 1 and _RING.search(system.text):
        return BodyShape(Outline.RING, (own[1],))
    distance = _distance_on_axis(system, p, rotation, axis)
    if distance is None or not _TOP.search(system.text):
        return None
    if _ROTOR.search(p.name):
        return BodyShape(Outline.DISC, (sp.Float(_WIDE * distance),))
    height = sp.Rational(4, 3) * sp.Float(distance)
    return BodyShape(Outline.CONE, (_WIDE * height, height))


def has_axle(system: SystemPicture, p: MassPoint, rotation: Rotation) -> bool:
    """Whether a disc in space turns about O, from which its axis leads to its centre."""
    if system.view.planar or not system.is_bare:
        return False
    return _distance_on_axis(system, p, rotation, rotation.inertia.symmetry_axis) is not None


_FIFTHS = sp.Rational(2, 5)


def _distance_on_axis(system: SystemPicture, p: MassPoint, rotation: Rotation, axis: int) -> float | None:
    """The distance of the mass centre from O, if O is behind it on its axis in all positions."""
    distances = [*_distances(system, p, rotation, axis)]
    if len(distances) < 3 or max(distances) - min(distances) > SAME_ON_PAGE or distances[0] < SAME_ON_PAGE:
        return None
    return distances[0]


def _distances(system: SystemPicture, p: MassPoint, rotation: Rotation, axis: int) -> Iterator[float]:
    for pose in (system.pose, *system.pose.others):
        at, e = pose.at(p.position), pose.at(rotation.axes[axis])
        if math.hypot(*outer(at, e)) > SAME_ON_PAGE or inner(at, e) < 0:
            return
        yield inner(at, e)
