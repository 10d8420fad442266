"""What the coordinates alone show of a system whose file draws no lines: rods, strings, pulleys, paths, pivots.

A bob at l sin θ i − l cos θ j has no constraint, and so no rod that `rods` could draw. But when θ changes alone it
moves on a circle: about a fixed point or another particle, at a distance that no coordinate changes. What keeps it
there is a rod or a string if the text mentions one; otherwise it may as well be a hoop, and nothing is drawn. A
coordinate that is called the length of a rope is one. A string x + y = L runs from weight to weight over pulleys where
x and y begin. A particle with one coordinate, which moves on no circle or line, stays on a curve.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer
from lagrange.pictures.implied.nested_pulleys import nested_pulleys
from lagrange.pictures.implied.turning_guides import turning_guides
from lagrange.pictures.limits import SAME_ON_PAGE
from lagrange.pictures.poses import circle_of, is_distance, relative_angle_mark
from lagrange.pictures.sketch import (
    HINGE,
    Sketch,
    apart,
    beyond,
    in_line,
    left_of,
    lies_on,
    overlapping,
    same_ends,
    scaled,
    toward,
)
from lagrange.pictures.systems import ROD, SystemPicture, is_string
from lagrange.problem.model import Keeper, Outline

STRINGS = re.compile(r"\b(string|rope|cord|thread|cable|wire rope|chain)s?\b|hangs|hoist|crane", re.IGNORECASE)
_PENDULUM = re.compile("pendulum", re.IGNORECASE)
_PULLEY, _PULLEYS = (re.compile(rf"\b(pulley|peg|drum){s}\b", re.IGNORECASE) for s in ("", "s"))
LARGE_PULLEY = 2.2
"""How wide the only pulley may be that leads a string from one level to the same, in centimetres."""
PULLEY = 0.32
"""Radius of a pulley on the page, in centimetres."""
CORNER = 0.2
"""Radius of a pulley at the edge of a table or plane."""
_CURVE = re.compile(
    r"\b(wire|curve|track|hoop|ring|bowl|groove|parabola|ellipse|cycloid|circle|circular|path|slope|hill|rail|surface|spiral)",
    re.IGNORECASE,
)
_GUIDE = re.compile(
    r"\b(on|along|in|inside|upon) (a|an|the|its)( [\w-]+){0,4} (rod|tube|wire|pipe|spoke|bar|groove)\b", re.IGNORECASE
)
"""Words for what something slides along."""
BEARING = 0.4
"""Height of the wedge or roller under a beam."""
GAP = 0.22
"""Half the gap in the ground that a rope goes through."""


class Inferred:
    """Lines that the coordinates show.

    pivots   their fixed ends
    corners  where a string bends around a pulley at an edge, and the centre of that pulley, which something has to hold
    """

    def __init__(self, system: SystemPicture, sketch: Sketch, busy: list[tuple[PagePoint, PagePoint]]) -> None:
        self.system = system
        self.sketch = sketch
        self.busy = busy
        self.pose = system.pose
        self.pivots: list[PagePoint] = []
        self.corners: list[tuple[PagePoint, PagePoint]] = []

    def all(self) -> None:
        """Draw them."""
        if self.system.is_bare:
            self.strings()
            with suppress(NoValueError):
                self.machine()
            with suppress(NoValueError):
                self.hanging()
            self.hangers()
            for p in self.particles():
                if not self.guide(p) and not self.arm(p):
                    self.path(p)

    def particles(self) -> Iterator[MassPoint]:
        """The particles which coordinates alone place: on which no reaction acts, but for rods and strings."""
        bodies = {r.name for r in self.system.configuration.rotations}
        kept = (r for r in self.system.newton.reactions if r.rod is None and r.constraint.by is not Keeper.STRING)
        bound = {name for r in kept for name in (r.directions or {})}
        points = self.system.configuration.points
        weightless = all(p.mass == 0 for p in points)  # at rest: the points of rods, at which loads act
        bound |= {p.name for p in points for rod in self.system.rods_at_rest if p.position.fixed() == rod.middle}
        yield from (p for p in points if (p.mass != 0 or weightless) and p.name not in bodies and p.name not in bound)

    def at(self, position: Vector) -> PagePoint:
        """A place on the page."""
        return self.system.page(self.pose.at(position))

    def guide(self, p: MassPoint) -> bool:
        """The straight rod or tube through a fixed place, which turns, and along which a particle slides."""
        linked = {e for link in self.system.links for e in link.ends}
        if not _GUIDE.search(self.system.text) or p.name in linked:
            return False
        poses = (self.pose, *self.pose.others)
        later = replace(self.pose, values={**self.pose.values, t: self.pose.values.get(t, 0.0) + 0.3})
        if [*turning_guides(self.system)]:
            return True
        for q in self.pose.coordinates:
            with suppress(NoValueError):
                if not is_distance(self.pose, q, p.position):
                    continue
                starts = [x.with_zero([q]).at(p.position) for x in (*poses, later)]
                ways = [minus(x.at(p.position), x.with_zero([q]).at(p.position)) for x in (*poses, later)]
                turns = any(math.hypot(*outer(ways[0], w)) > SAME_ON_PAGE for w in ways)
                if turns and all(math.dist(starts[0], s) < SAME_ON_PAGE for s in starts):
                    start, at = self.system.page(starts[0]), self.at(p.position)
                    end = beyond(at, toward(start, at), 0.8)
                    self.sketch.line([start, end], StrokeKind.ROD)
                    self.busy.append((start, end))
                    if self.system.view.planar:
                        self.pivots.append(start)
                    return True
        return False

    def hangers(self) -> None:
        """The strings and rods of chains, from a fixed place to the joints of bodies and to particles."""
        bodies = {r.name for r in self.system.configuration.rotations}
        for joint in self.system.swinging_joints if not self.system.is_round else ():
            rope, bar = STRINGS.search(self.system.text), ROD.search(self.system.text)
            if not (rope or bar):
                continue
            kind = StrokeKind.STRING if rope and (joint.name in bodies or not bar) else StrokeKind.ROD
            centre, end = self.system.page(joint.mark.centre), self.system.page(joint.mark.point)
            middles = [self.at(p.position) for p in self.system.configuration.points if p.name in bodies]
            if any(lies_on(at, centre, end) and min(apart(at, centre), apart(at, end)) > 0.1 for at in middles):
                continue  # a body leads there
            if not any(same_ends((centre, end), line) for line in self.busy):
                self.sketch.line([centre, end], kind)
                self.busy.append((centre, end))
                if joint.is_fixed:
                    self.pivots.append(centre)
                if joint.name in bodies or not joint.is_fixed:
                    self.sketch.hinge(end if joint.name in bodies else centre)

    def arm(self, p: MassPoint) -> bool:
        """The rod or string on which a particle swings; whether it moves on a circle."""
        origins = [o.position for o in self.system.configuration.points if o.name != p.name]
        for q in self.pose.coordinates:
            with suppress(NoValueError):
                mark = circle_of(self.pose, q, p.position)
                if mark is None:
                    continue
                if p.mass == 0 and self._is_braced(p, mark.centre):
                    continue
                fixed = self._is_fixed(q, p.position)
                moving = [o for o in origins if math.dist(self.pose.at(o), mark.centre) < SAME_ON_PAGE]
                moving = [o for o in moving if relative_angle_mark(self.pose, q, p.position, o) is not None]
                if not fixed and not moving:
                    continue  # the whole system turns about that point
                kind = self._kind(math.dist(mark.centre, mark.point), q, p.position)
                if kind is not None:
                    centre, end = self.system.page(mark.centre), self.at(p.position)
                    if any(same_ends((centre, end), line) or overlapping((centre, end), line) for line in self.busy):
                        return True  # the rod of a constraint, or of which this is a part
                    self.sketch.line([centre, end], kind)
                    self.busy.append((centre, end))
                    if fixed and not moving:
                        self.pivots.append(centre)
                return kind is not None
        return False

    def _is_braced(self, p: MassPoint, centre: FloatVector) -> bool:
        """Whether a point of a frame is at a constant distance from others, not in line with the centre."""
        places = {o.name: self.pose.at(o.position) for o in self.system.configuration.points}
        others = {o.name: [x.at(o.position) for x in self.pose.others] for o in self.system.configuration.points}
        ends = [
            places[end]
            for a, b, _ in self.system.kept_distances
            for end in ((a if b == p.name else b),)
            if p.name in (a, b)
            and all(abs(math.dist(x, centre) - math.dist(places[end], centre)) < SAME_ON_PAGE for x in others[end])
        ]
        arm = minus(places[p.name], centre)
        ways = [minus(end, centre) for end in ends]
        return any(math.hypot(*outer(arm, way)) > SAME_ON_PAGE for way in ways)

    def _is_fixed(self, q: sp.Symbol, position: Vector) -> bool:
        marks = [circle_of(pose, q, position) for pose in (self.pose, *self.pose.others)]
        centres = [m.centre for m in marks if m is not None]
        return len(centres) > 1 and all(math.dist(centres[0], c) < SAME_ON_PAGE for c in centres)

    def _kind(self, length: float, q: sp.Symbol, position: Vector) -> StrokeKind | None:
        """A rod, a string, or None if it may be neither."""
        marks = [circle_of(pose, q, position) for pose in (self.pose, *self.pose.others)]
        lengths = [math.dist(m.centre, m.point) for m in marks if m is not None]
        called = " ".join(f"{c.meaning}" for c in self.system.problem.coordinates if c.symbol != q)
        if any(abs(x - length) > SAME_ON_PAGE for x in lengths):
            return StrokeKind.STRING if STRINGS.search(called) else None
        if self.system.is_round:
            return None
        if STRINGS.search(self.system.text) and not ROD.search(_PENDULUM.sub("", self.system.text)):
            return StrokeKind.STRING
        return StrokeKind.ROD if ROD.search(self.system.text) else None

    def path(self, p: MassPoint) -> None:
        """The curve on which a particle with one coordinate moves, if it is no line."""
        if ROD.search(self.system.text) and not _CURVE.search(self.system.text):
            return  # rods keep it there
        points = [self.system.page(place) for place in self.system.paths.get(p.name, ())]
        if points and not in_line(points[0], points[1:]):
            self.sketch.line(points, StrokeKind.CURVE)

    def strings(self) -> None:
        """The strings between weights, each at its own coordinate, over pulleys where these begin."""
        slots = self.system.configuration.slots
        for reaction in self.system.newton.reactions:
            row = reaction.row
            if len(row.coefficients) != len(slots.coordinates):
                continue  # the constraint is in the coordinates of the file, and the picture in those of a choice
            used = {q: a for q, a in zip(slots.coordinates, row.coefficients, strict=True) if a != 0}
            if not is_string(reaction):
                continue
            if len(used) != 2 or row.finite is None:
                continue
            straight = [q for q, a in used.items() if a.is_number]
            if len(straight) == 1:
                turning = next(q for q in used if q != straight[0])
                with suppress(NoValueError):
                    if not self._around_cylinder(straight[0], turning):
                        self._to_a_boom(straight[0], turning, row.finite)
                continue
            pairs = [self._held_by(q) for q in used]
            if any(len(pair) != 1 for pair in pairs):
                continue
            ends = [pair[0].position for pair in pairs]
            with suppress(NoValueError):
                match sorted(abs(a) for a in used.values() if a.is_number):
                    case [one, other] if one == other:
                        self._over_pulleys(ends, [*used])
                    case [one, other] if other == 2 * one:
                        order = sorted(zip(used, ends, strict=True), key=lambda e: abs(used[e[0]]))
                        self._under_pulley([v for _, v in order], [q for q, _ in order])

    def machine(self) -> None:
        """A weight and a moving pulley on one string, two weights on the string over that pulley."""
        configuration, down = self.system.configuration, self.system.down
        found = nested_pulleys(configuration, [r for r in self.system.newton.reactions if is_string(r)])
        if found is None or down is None or not self.system.view.planar:
            return
        falls = toward((0.0, 0.0), self.system.page.way(self.pose.at(down)))
        across, up = left_of(falls), scaled(falls, -1.0)
        points = [p for q in found.held for p in configuration.points if not p.position.fixed().partial(q).is_zero]
        ends = [self.at(p.position) for p in points]
        start = self.system.page(self.pose.moved(found.weight, -self.pose.values[found.weight]).at(points[0].position))
        deep = abs(self.pose.values[found.pulley]) * self.system.page.scale

        def below(side: PagePoint, by: float) -> PagePoint:
            """The point straight above or below another one, so far below the level of the upper pulley."""
            return beyond(side, falls, inner((start[0] - side[0], start[1] - side[1]), falls) + by)

        middle = ((ends[1][0] + ends[2][0]) / 2, (ends[1][1] + ends[2][1]) / 2)
        axle, corner = below(middle, deep), below(middle, 0.0)
        small, large = abs(inner((ends[1][0] - middle[0], ends[1][1] - middle[1]), across)), apart(start, corner) / 2
        if any(inner((e[0] - axle[0], e[1] - axle[1]), falls) < small for e in ends[1:]) or deep < large:
            return
        pairs = [(start, ends[0]), (corner, axle), *((below(e, deep), e) for e in ends[1:])]
        for pair in pairs:
            self.sketch.line([*pair], StrokeKind.STRING)
            self.busy.append(pair)
        top = ((start[0] + corner[0]) / 2, (start[1] + corner[1]) / 2)
        for centre, radius in ((top, large), (axle, small)):
            self.sketch.circle(centre, radius, 1)
            self.sketch.dot(centre, 0.6 * HINGE, open_=True)
        hook = beyond(top, up, large + PULLEY)
        self.sketch.line([top, hook], StrokeKind.LINK)
        self.sketch.wall(hook, falls, 0.6)

    def _held_by(self, q: sp.Symbol) -> list[MassPoint]:
        """What hangs on the part of a string whose length is q: weights, or the massless point which q alone moves."""
        points = [p for p in self.system.configuration.points if not p.position.fixed().partial(q).is_zero]
        ends = [
            p
            for p in points
            if p.mass == 0 and p.position.fixed().as_sum().free_symbols & {*self.pose.coordinates} == {q}
        ]
        weightless = all(p.mass == 0 for p in self.system.configuration.points)
        return ends or [p for p in points if p.mass != 0 or weightless]

    def hanging(self) -> None:
        """The strings from which bodies hang, off the rim of a wheel with a fixed centre."""
        field, figure = self.system.problem.gravity, self.system.problem.figure
        if field is None or not self.system.view.planar:
            return
        up = toward((0.0, 0.0), self.system.page.way(self.pose.at(field * sp.Integer(-1))))
        across = left_of(up)
        poses = (self.pose, *self.pose.others)
        wheels = [p for p in self.system.configuration.points if p.name in figure.shapes]
        for wheel in wheels:
            shape = figure.shapes[wheel.name]
            if shape.kind not in (Outline.DISC, Outline.RING):
                continue
            radius = abs(self.system.number(shape.lengths[0])) * self.system.page.scale
            for p in self.system.configuration.points:
                ways = [(self.system.page(x.at(p.position)), self.system.page(x.at(wheel.position))) for x in poses]
                offsets = [inner((a[0] - c[0], a[1] - c[1]), across) for a, c in ways]
                below = inner((ways[0][0][0] - ways[0][1][0], ways[0][0][1] - ways[0][1][1]), up)
                at_rim = all(abs(abs(x) - radius) < 10 * SAME_ON_PAGE and x * offsets[0] > 0 for x in offsets)
                if p.name != wheel.name and p.mass != 0 and below < -0.3 and at_rim:
                    top = beyond(ways[0][1], across, offsets[0])
                    self.sketch.line([top, ways[0][0]], StrokeKind.STRING)
                    self.busy.append((top, ways[0][0]))

    def _tops(self, positions: Sequence[Vector], used: Sequence[sp.Symbol]) -> list[PagePoint]:
        """Where the coordinates of the ends of a string begin."""
        lifted = [self.pose.moved(q, -self.pose.values[q]) for q in used]
        return [self.system.page(pose.at(v)) for pose, v in zip(lifted, positions, strict=True)]

    def _under_pulley(self, positions: Sequence[Vector], used: Sequence[sp.Symbol]) -> None:
        """A rope from the ceiling under a pulley with the second weight, then over a fixed pulley to the first."""
        (weight, carried), tops = positions, self._tops(positions, used)
        ends = [self.at(weight), self.at(carried)]
        downs = [toward(a, b) for a, b in zip(tops, ends, strict=True) if apart(a, b) > 4 * PULLEY]
        if len(downs) != 2 or abs(downs[0][0] - downs[1][0]) > SAME_ON_PAGE or not self.system.view.planar:
            return
        across, up = left_of(downs[0]), (-downs[0][0], -downs[0][1])
        apart_by = inner((tops[0][0] - tops[1][0], tops[0][1] - tops[1][1]), across)
        side = across if apart_by > 0 else (-across[0], -across[1])
        if abs(apart_by) < 3 * PULLEY:
            return
        level = beyond(tops[1], up, 3 * PULLEY)
        near, far = beyond(ends[1], side, PULLEY), beyond(ends[1], side, -PULLEY)
        wheel = beyond(ends[1], up, 2 * PULLEY)
        gap = abs(apart_by) - PULLEY  # between the rope that goes up and the rope that comes down
        one = gap < 6 * PULLEY
        radius = gap / 2 if one else PULLEY
        middles = [beyond(tops[1], side, PULLEY + x) for x in ((radius,) if one else (radius, gap - radius))]
        rise = 2 * PULLEY
        for at, top in ((near, tops[1]), (far, level)):
            on = beyond(at, up, rise)
            shift = inner((at[0] - tops[1][0], at[1] - tops[1][1]), side)
            high = beyond(top, side, shift)
            self.sketch.line([high, on], StrokeKind.STRING)
            self.busy.append((high, on))
        self.sketch.line([tops[0], ends[0]], StrokeKind.STRING)
        self.busy.append((tops[0], ends[0]))
        self.sketch.circle(wheel, PULLEY, 1)
        self.sketch.line([wheel, ends[1]], StrokeKind.LINK)
        if not one:
            self.sketch.line([beyond(m, up, radius) for m in middles], StrokeKind.STRING)
        hooks = []
        for middle in middles:
            self.sketch.circle(middle, radius, 1)
            hook = beyond(middle, up, inner((level[0] - middle[0], level[1] - middle[1]), up))
            hooks.append(hook if apart(hook, middle) > radius else beyond(middle, up, radius + PULLEY))
            self.sketch.line([middle, hooks[-1]], StrokeKind.LINK)
        for centre in (wheel, *middles):
            self.sketch.dot(centre, 0.6 * HINGE, open_=True)
        for held in (*hooks, beyond(level, side, -PULLEY)):
            self.sketch.wall(held, (-up[0], -up[1]), 0.45)

    def _around_cylinder(self, straight: sp.Symbol, turning: sp.Symbol) -> bool:
        """A string that leaves a circle straight, and lies on it as far as a particle that moves there."""
        points = self.system.configuration.points
        hung = [p for p in points if not p.position.fixed().partial(straight).is_zero]
        moving = [p for p in points if not p.position.fixed().partial(turning).is_zero]
        if len(hung) != 1 or len(moving) != 1 or hung == moving or not self.system.view.planar:
            return False
        mark = circle_of(self.pose, turning, moving[0].position)
        if mark is None:
            return False
        centre, at, bottom = self.system.page(mark.centre), self.at(moving[0].position), self.at(hung[0].position)
        [top] = self._tops([hung[0].position], [straight])
        radius = apart(centre, at)
        touches = abs(inner(toward(top, bottom), toward(centre, top))) < SAME_ON_PAGE
        if abs(apart(centre, top) - radius) > SAME_ON_PAGE or not touches:
            return False
        start, end = (math.atan2(p[1] - centre[1], p[0] - centre[0]) for p in (at, top))
        turn = math.remainder(end - start, 2 * math.pi)
        ways = (start + turn * n / 24 for n in range(25))
        string = [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in ways]
        self.sketch.line([*string, bottom], StrokeKind.STRING)
        self.busy.append((top, bottom))
        return True

    def _to_a_boom(self, straight: sp.Symbol, turning: sp.Symbol, finite: sp.Expr) -> None:
        """A rope from a weight over a fixed pulley to a point that swings, at a distance that is a root."""
        points = self.system.configuration.points
        hung = [p for p in points if not p.position.fixed().partial(straight).is_zero]
        swinging = [p for p in points if not p.position.fixed().partial(turning).is_zero]
        roots = [e for e in finite.atoms(sp.Pow) if e.exp == sp.S.Half and e.has(turning) and not e.has(straight)]
        if len(hung) != 1 or not self.system.view.planar:
            return
        pulleys = ((p, self._pulley(turning, p.position, root)) for p in swinging for root in roots)
        found = next(((p, at) for p, at in pulleys if at is not None), None)
        if found is None:
            return
        end, pulley = self.at(found[0].position), found[1]
        [top], bottom = self._tops([hung[0].position], [straight]), self.at(hung[0].position)
        if apart(top, bottom) < 0.5 or apart(pulley, end) < 0.5:
            return
        if apart(top, pulley) < SAME_ON_PAGE:
            self._around_corner(pulley, [bottom, end], [toward(top, bottom), toward(pulley, end)])
            return
        middle = ((top[0] + pulley[0]) / 2, (top[1] + pulley[1]) / 2)
        if (radius := apart(top, pulley) / 2) < 2 * PULLEY:
            self.sketch.circle(middle, radius, 1)
            self.sketch.dot(middle, 0.6 * HINGE, open_=True)
            for a, b in ((top, bottom), (pulley, end)):
                self.sketch.line([a, b], StrokeKind.STRING)
                self.busy.append((a, b))
            return
        for corner, ends in ((top, (bottom, middle)), (pulley, (middle, end))):
            self._around_corner(corner, ends, [toward(corner, e) for e in ends])

    def _pulley(self, q: sp.Symbol, position: Vector, distance: sp.Expr) -> PagePoint | None:
        """The fixed place from which a point that moves with q is at this distance: |r|² − d² is linear in r there."""
        poses = [self.pose.moved(q, step) for step in (0.0, 0.4, -0.3, 0.7, -0.6)]
        places = [self.system.page(pose.at(position)) for pose in poses]
        lengths = [pose.number(distance) * self.system.page.scale for pose in poses]
        (x, y), *others = places
        rows = [
            (2 * (u - x), 2 * (v - y), u * u + v * v - d * d - (x * x + y * y - lengths[0] ** 2))
            for (u, v), d in zip(others, lengths[1:], strict=True)
        ]
        (a, b, c), (d, e, f) = rows[:2]
        if abs(determinant := a * e - b * d) < SAME_ON_PAGE:
            return None
        at = (c * e - b * f) / determinant, (a * f - c * d) / determinant
        fits = all(abs(apart(at, place) - length) < SAME_ON_PAGE for place, length in zip(places, lengths, strict=True))
        return at if fits else None

    def _over_pulleys(self, positions: Sequence[Vector], used: Sequence[sp.Symbol]) -> None:
        if len(positions) != 2:
            return
        tops, bottoms = self._tops(positions, used), [self.at(v) for v in positions]
        downs = [toward(a, b) for a, b in zip(tops, bottoms, strict=True) if apart(a, b) > 0.5]
        if len(downs) == 2 and apart(*tops) < SAME_ON_PAGE:
            self._around_corner(tops[0], bottoms, downs)
            return
        if len(downs) != 2 or abs(downs[0][0] - downs[1][0]) > SAME_ON_PAGE:
            return
        along = toward(tops[0], tops[1])
        up = (-downs[0][0], -downs[0][1])
        field = self.system.down
        falls = None if field is None else toward((0.0, 0.0), self.system.page.way(self.pose.at(field)))
        if falls is not None and inner(falls, up) > 0.5:  # heights are counted from below, and weights hang
            up = scaled(falls, -1.0)
            highest = max(inner(at, up) for at in bottoms) + 1.4
            tops = [beyond(at, up, highest - inner(at, up)) for at in bottoms]
            along = toward(tops[0], tops[1])
        if abs(along[0] * up[0] + along[1] * up[1]) > SAME_ON_PAGE:
            return
        text = self.system.text
        alone = _PULLEY.search(text) and not _PULLEYS.search(text)
        one = apart(*tops) < (LARGE_PULLEY if alone else 4 * PULLEY)
        radius = apart(*tops) / 2 if one else PULLEY
        centres = [beyond(tops[0], along, radius), beyond(tops[1], along, -radius)][: 1 if one else 2]
        for top, bottom in zip(tops, bottoms, strict=True):
            self.sketch.line([top, bottom], StrokeKind.STRING)
            self.busy.append((top, bottom))
        if not one:
            self.sketch.line([beyond(c, up, radius) for c in centres], StrokeKind.STRING)
        for centre in centres:
            self.sketch.circle(centre, radius, 1)
            hook = beyond(centre, up, 3 * PULLEY)
            self.sketch.line([centre, hook], StrokeKind.LINK)
            self.sketch.dot(centre, 0.6 * HINGE, open_=True)
            self.sketch.wall(hook, (-up[0], -up[1]), 0.45)

    def _around_corner(self, corner: PagePoint, ends: Sequence[PagePoint], ways: Sequence[PagePoint]) -> None:
        """A string over a small pulley at a corner, or through a hole there."""
        bisector = (ways[0][0] + ways[1][0], ways[0][1] + ways[1][1])
        half = math.hypot(*bisector) / 2  # the cosine of half the angle between the two parts
        if not self.system.view.planar or not 0.2 < half < 0.98:
            for end in ends:
                self.sketch.line([corner, end], StrokeKind.STRING)
                self.busy.append((corner, end))
            self.sketch.dot(corner, HINGE, open_=True)
            return
        inward = toward((0.0, 0.0), bisector)
        sine = math.sqrt(1 - half**2)
        centre = beyond(corner, inward, CORNER / sine)
        for way, end in zip(ways, ends, strict=True):
            self.sketch.line([beyond(corner, way, CORNER * half / sine), end], StrokeKind.STRING)
            self.busy.append((corner, end))
        self.sketch.circle(centre, CORNER, 1)
        self.sketch.dot(centre, 0.6 * HINGE, open_=True)
        self.corners.append((corner, centre))


def rail(
    sketch: Sketch, at: PagePoint, down: PagePoint, half: float, through: Sequence[tuple[PagePoint, PagePoint]] = ()
) -> None:
    """The ground under a box that only moves along it, with a gap where a rod or rope goes through.

    at  in the lower side of the box
    """
    side = left_of(down)
    gaps = [gap for a, b in through if (gap := _crossing(a, b, at, down, side)) is not None and abs(gap) < half]
    start = -half
    for gap in sorted(gaps):
        if gap - GAP > start:
            sketch.ground([beyond(at, side, start), beyond(at, side, gap - GAP)])
        start = gap + GAP
    if start < half:
        sketch.ground([beyond(at, side, start), beyond(at, side, half)])


def _crossing(a: PagePoint, b: PagePoint, at: PagePoint, down: PagePoint, side: PagePoint) -> float | None:
    """Where a line crosses the level of `at`, measured along it; None if it ends before."""
    (x, y), (u, v) = ([inner((p[0] - at[0], p[1] - at[1]), w) for w in (side, down)] for p in (a, b))
    return None if y * v >= 0 else x + (u - x) * y / (y - v)


def fulcrum(sketch: Sketch, at: PagePoint, down: PagePoint, high: float = 0.62) -> None:
    """The wedge on which a lever turns, and the ground under it."""
    side = left_of(down)
    foot, half = beyond(at, down, high), 0.58 * high
    sketch.line([at, beyond(foot, side, half), beyond(foot, side, -half)], StrokeKind.BODY, closed=True)
    rail(sketch, foot, down, half + 0.44 * high / 0.62)


def roller(sketch: Sketch, at: PagePoint, down: PagePoint) -> None:
    """A roller under the end of a beam, and the ground on which it may move."""
    radius = BEARING / 2
    sketch.circle(beyond(at, down, radius), radius, 1)
    rail(sketch, beyond(at, down, BEARING), down, 1.4 * BEARING)
