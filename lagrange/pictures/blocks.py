"""Blocks and carts as boxes, and the tables, planes, rails and walls on which the text says that something slides.

A particle that one coordinate moves along a straight line may fall, or hang, or slide on something: the words tell. A
line that is not vertical is ground if the text speaks of a table, plane or rail; a vertical one is a wall if it speaks
of a wall. A particle that the text calls a block, a cart, a slider or the like is a box that stands on the ground.

The angle of an incline, drawn at the foot of the plane where the file does not draw it.

A plane comes from a constraint, from the line on which a block moves, or from the turned direction of gravity: in none
of these is there an angle. A parameter whose value is the angle between a straight piece of ground and the horizontal,
and which the positions or the weight contain, is that angle.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import permutations

import sympy as sp

from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.pictures.floats import NoValueError, inner
from lagrange.pictures.inferred import CORNER, rail
from lagrange.pictures.limits import LEAST_SLOPE, SAME_ON_PAGE, SAME_SHAPE, SLOPE_ARC, STEEPEST_SLOPE
from lagrange.pictures.poses import is_distance
from lagrange.pictures.sketch import PARTICLE, Sketch, apart, beyond, left_of, lies_on, scaled, toward
from lagrange.pictures.systems import ROD, SystemPicture, is_string
from lagrange.problem.keys import Keeper, Outline

_VEHICLES = r"cart|car|carriage|trolley|wagon|truck|lorry|bus|train|locomotive|tram|sledge|sled"
_BOATS = r"boat|ship|barge|canoe|punt"
_BLOCK = rf"block|{_VEHICLES}|{_BOATS}|slider|piston|crate|box|collar|sleeve|carrier"
_WORD = re.compile(rf"\b({_BLOCK})\b", re.IGNORECASE)
_SEVERAL = re.compile(rf"\b({_BLOCK}|boxe)s\b", re.IGNORECASE)
_VEHICLE, _BOAT = (re.compile(rf"\b({words})\b", re.IGNORECASE) for words in (_VEHICLES, _BOATS))
_BOARD = re.compile(r"\b(plank|board|slab|raft|tray|platform|carpet|mat)\b", re.IGNORECASE)
_QUARTER = re.compile(r"\bquarter", re.IGNORECASE)
_GROUND = re.compile(
    r"\b(table|floor|ground|rail|track|guide|incline|slope|plane|ladder|ice|road)s?\b|horizontal(ly)?\b.*\b(line|surface)",
    re.IGNORECASE,
)
FLOOR = re.compile(r"\b(floor|ground|table)s?\b", re.IGNORECASE)
_IN_PLANE = re.compile(r"\b(in|of) (a|the|its|one) (\w+ )?plane\b", re.IGNORECASE)
_HANGING = re.compile(r"\bhang|suspended|pendulum", re.IGNORECASE)
WALL = re.compile(r"\bwalls?\b", re.IGNORECASE)
WIDE, HIGH = 0.62, 0.42
"""Width and height of a block, in centimetres."""
BOARD = 0.16
"""Thickness of a board."""


def is_vehicle(name: str) -> bool:
    """Whether something is called a car or the like."""
    return bool(_VEHICLE.search(name.replace("_", " ")))


@record
class Way:
    """The straight line on which a particle moves, on the page.

    along  its direction
    up     the direction away from what carries it
    """

    at: PagePoint
    along: PagePoint
    up: PagePoint

    @property
    def is_upright(self) -> bool:
        """Whether the line is vertical on the page."""
        return abs(self.along[0]) < SAME_ON_PAGE


class Blocks:
    """Boxes, ground and walls.

    corners  where strings bend around a pulley at the edge of something, with the centre of the pulley
    half     half the width of each box along its way, by particle
    on_wedge the face on which a particle slides, by particle; None for a wedge itself
    boards   the middle of each board under others, by particle
    tops     the upper sides of the boards
    on_board how high the top of the board is on which a particle slides, by particle
    cut      a block in which another particle slides on a circle, and that particle
    """

    def __init__(
        self,
        system: SystemPicture,
        sketch: Sketch,
        busy: Sequence[tuple[PagePoint, PagePoint]],
        down: PagePoint,
        corners: list[tuple[PagePoint, PagePoint]],
    ) -> None:
        self.system = system
        self.sketch = sketch
        self.busy = busy
        self.down = down
        self.corners = corners
        self.half: dict[str, float] = {}
        self.carried: list[tuple[Way, float]] = []
        self.on_wedge: dict[str, Way | None] = {}
        self.boards: dict[str, PagePoint] = {}
        self.on_board: dict[str, float] = {}
        self.tops: list[tuple[PagePoint, PagePoint]] = []
        self.cut: set[str] = set()
        self.ridges: list[PagePoint] = []

    def boxes(self) -> None:
        """Draw wedges and blocks, and record which of them the ground carries."""
        if not (self.system.is_bare and self.system.view.planar):
            return
        self.wedges()
        self.cuts()
        kept_on = [way for p in self.particles() if (way := self.surface(p)) is not None]
        self.ridges += [at for at, _ in self.corners if sum(self.is_on(way, at) for way in kept_on) > 1]
        ways = {p.name: way for p in self.particles() if (way := self.way(p)) is not None}
        stacked = self.stacks({p.name: ways[p.name] for p in self.particles() if p.name in ways and self.is_block(p)})
        self.planks(ways)
        for p in self.particles():
            way = ways.get(p.name)
            if p.name in self.boards or p.name in self.cut:
                continue
            if self.is_block(p):
                self.block(p, way, stacked.get(p.name))
            if p.name in stacked.values():
                continue
            if p.name in self.on_board:
                continue
            if way is not None and p.name not in self.on_wedge and self.is_carried(way, p):
                self.carried.append((way, self.height(p) / 2 if p.name in self.half else 0.0))
        self.carried += [*self.wheels(), *self.feet(), *self.ends_of_rods()]

    def stacks(self, ways: Mapping[str, Way]) -> dict[str, str]:
        """The block on top of another one that moves on a parallel line, by the block below."""
        found: dict[str, str] = {}
        for lower, upper in permutations(ways, 2):
            a, b = ways[lower], ways[upper]
            rise = inner((b.at[0] - a.at[0], b.at[1] - a.at[1]), a.up)
            if not a.is_upright and abs(inner(a.along, b.along)) > 1 - SAME_ON_PAGE and rise > HIGH / 2:
                found.setdefault(lower, upper)
        return found

    def planks(self, ways: Mapping[str, Way]) -> None:
        """Boards on which others move along the same line: under these, or on the ground on which they are kept."""
        for p in self.particles():
            kept = self.surface(p) is not None
            way = self.surface(p) or ways.get(p.name)
            if way is not None and is_vehicle(p.name) and self.under_roller(p, way):
                continue
            is_board = _BOARD.search(p.name.replace("_", " "))
            upon = {name for r in self.system.newton.reactions for name in r.acts_on
                    if r.constraint.side is not None and len(r.acts_on) == 2 and p.name in r.acts_on}  # fmt: skip
            if way is None or way.is_upright or not (is_board or (kept and upon and self.is_block(p))):
                continue
            page, pose = self.system.page, self.system.pose
            near = {q.name: page(pose.at(q.position)) for q in self.particles() if q.name != p.name}
            riders = {name: at for name, at in near.items() if self.is_on(way, at) and (is_board or name in upon)}
            high = [inner((at[0] - way.at[0], at[1] - way.at[1]), way.up) for name, at in near.items() if name in upon]
            on_top = kept and not riders and len(high) == 1 and high[0] > PARTICLE
            riders |= {name: at for name, at in near.items() if on_top and name in upon}
            rolling = dict(self.rolling_on(way)) if is_board else {}
            riders |= rolling
            if not riders:
                continue
            boxes = any(self.is_block(q) for q in self.particles() if q.name in riders)
            thick = high[0] if on_top else BOARD if is_board else HIGH
            top = thick if kept else 0.0 if rolling else -HIGH / 2 if boxes else -PARTICLE
            self.on_board |= dict.fromkeys(riders, SAME_ON_PAGE if on_top else top if kept else 0.0)
            places = [inner(at, way.along) - inner(way.at, way.along) for at in riders.values()]
            start, end = min([*places, 0.0]) - 0.8, max([*places, 0.0]) + 0.8
            corners = [beyond(beyond(way.at, way.along, x), way.up, y) for x, y in
                       ((start, top), (end, top), (end, top - thick), (start, top - thick))]  # fmt: skip
            self.sketch.face(corners, 2, -1.0)
            self.tops.append((corners[0], corners[1]))
            self.boards[p.name] = beyond(beyond(way.at, way.along, (start + end) / 2), way.up, top - thick / 2)
            if not kept and self.is_carried(way, p):
                self.carried += [
                    (Way(beyond(way.at, way.along, x), way.along, way.up), thick - top) for x in (start, end)
                ]

    def under_roller(self, p: MassPoint, way: Way) -> bool:
        """Draw a cart under what rolls on it, with a post at its own place if that is at the height of the centre."""
        page, system = self.system.page, self.system
        joined = {n for r in system.newton.reactions if p.name in r.acts_on for n in r.acts_on if n != p.name}
        bodies = {b.name: page(system.pose.at(b.position)) for b in system.configuration.points if b.name in joined}
        rolling = {n: at for n, at in bodies.items() if n in system.shapes and self.is_on(way, at) and self.radius(n)}
        if not rolling or way.is_upright:
            return False
        low = max(map(self.radius, rolling)) * page.scale
        places = [inner(at, way.along) - inner(way.at, way.along) for at in rolling.values()]
        start, end = min([*places, 0.0]) - 0.8, max([*places, 0.0]) + 0.8

        def place(x: float, y: float) -> PagePoint:
            return beyond(beyond(way.at, way.along, x), way.up, y)

        top = (place(start, -low), place(end, -low))
        self.sketch.face([*top, place(end, -low - HIGH), place(start, -low - HIGH)], 2, -1.0)
        self.sketch.line([place(0.0, -low), place(0.0, 0.3)], StrokeKind.ROD)
        self.tops.append(top)
        self.on_board |= dict.fromkeys(rolling, 0.0)
        self.boards[p.name] = place((start + end) / 2, -low - HIGH / 2)
        self.carried += [(Way(place(x, 0.0), way.along, way.up), low + HIGH) for x in (start, end)]
        return True

    def radius(self, name: str) -> float:
        """Of a round body, in the units of the problem; 0 for any other."""
        shape, known = self.system.problem.figure.shapes.get(name), self.system.shapes.get(name)
        if shape is not None and shape.kind in (Outline.DISC, Outline.RING, Outline.SPHERE):
            return abs(self.system.number(shape.lengths[0]))
        return known.radius if known else 0.0

    def rolling_on(self, way: Way) -> Iterator[tuple[str, PagePoint]]:
        """The round bodies whose lowest points are on a line, with these."""
        page, pose = self.system.page, self.system.pose
        for p in self.system.configuration.points:
            radius = self.radius(p.name)
            at = beyond(page(pose.at(p.position)), way.up, -radius * page.scale)
            if radius and self.is_on(way, at):
                yield p.name, at

    def cuts(self) -> None:
        """Blocks with a round hollow or hump on which another particle slides: a constant distance, by no rod."""
        for first, second, kept in self.system.kept_distances:
            if not kept or not self.system.is_surface_between(first, second):
                continue
            points = {p.name: p for p in self.particles()}
            if {first, second} - {*points}:
                continue
            moving = {*self.system.pose.coordinates}
            base, rider = sorted(
                (first, second), key=lambda n: len(points[n].position.fixed().as_sum().free_symbols & moving)
            )
            centre, at = (self.system.page(self.system.pose.at(points[n].position)) for n in (base, rider))
            radius, way = apart(centre, at), toward(centre, at)
            side = scaled(left_of(self.down), math.copysign(1.0, inner(way, left_of(self.down)) or 1.0))

            def place(x: float, y: float, c: PagePoint = centre, s: PagePoint = side) -> PagePoint:
                return beyond(beyond(c, s, x), self.down, y)

            half = math.pi / 2
            if inner(way, self.down) > 0:
                low = 0.0 if _QUARTER.search(self.system.text) else -half
                arc = [
                    place(radius * math.sin(a), radius * math.cos(a))
                    for a in (half - (half - low) * n / 32 for n in range(33))
                ]
                deep, wide = radius + 0.45, radius + 0.5
                rest = [place(-0.7, radius)] if low == 0 else [place(-wide, 0.0)]
                corners = [place(wide, deep), place(wide, 0.0), *arc, *rest, place(-0.7 if low == 0 else -wide, deep)]
            else:
                deep, wide = 0.0, radius
                corners = [
                    place(radius * math.sin(a), -radius * math.cos(a))
                    for a in (half - math.pi * n / 48 for n in range(49))
                ]
            self.sketch.face(corners, 2, -2.0)
            rail(self.sketch, place(0.0, deep), self.down, wide + 0.7)
            self.cut |= {base, rider}

    def wedges(self) -> None:
        """Wedges: particles called so, on whose sloping faces others slide, each by a coordinate of its own."""
        for wedge in [p for p in self.particles() if "wedge" in p.name]:
            level = self.way(wedge)
            faces: list[tuple[str, PagePoint, PagePoint, PagePoint]] = []
            for rider in [p for p in self.particles() if p.name != wedge.name and p.mass != 0]:
                with suppress(NoValueError):
                    found = None if level is None else self.face_under(wedge, rider)
                    faces += [] if found is None else [(rider.name, *found)]
            if faces:
                self.wedge(wedge, faces)

    def face_under(self, wedge: MassPoint, rider: MassPoint) -> tuple[PagePoint, PagePoint, PagePoint] | None:
        """Where a particle is on a wedge, where its coordinate begins, and the direction down the face."""
        pose, page = self.system.pose, self.system.page
        relative = rider.position.fixed() - wedge.position.fixed()
        moving = [q for q in pose.coordinates if not relative.partial(q).is_zero]
        if len(moving) != 1 or not is_distance(pose, moving[0], relative):
            return None
        [q] = moving
        at, top = page(pose.at(rider.position)), page(pose.moved(q, -pose.values[q]).at(rider.position))
        along = toward(top, at)
        if inner(along, self.down) < 0:
            along, top = scaled(along, -1.0), beyond(at, along, 0.9)
        return (at, top, along) if 0.1 < inner(along, self.down) < 0.95 else None

    def wedge(self, wedge: MassPoint, faces: Sequence[tuple[str, PagePoint, PagePoint, PagePoint]]) -> None:
        """A wedge with one face and an upright back, or with two faces that meet at its ridge, and the ground."""
        level, side = self.system.page(self.system.pose.at(wedge.position)), left_of(self.down)
        ridge = faces[0][2]
        joined = [f for f in faces if apart(f[2], ridge) < 0.05]
        two = len(joined) > 1 and inner(joined[0][3], side) * inner(joined[1][3], side) < 0
        deep = inner(level, self.down) - inner(ridge, self.down)
        needed = max((apart(top, at) + 0.5 * WIDE) * inner(along, self.down) for _, at, top, along in joined)
        if deep <= needed:
            deep = max((apart(top, at) + 1.2) * inner(along, self.down) for _, at, top, along in joined)
        toes = [
            beyond(ridge, along, deep / inner(along, self.down)) for _, _, _, along in (joined if two else joined[:1])
        ]
        heel = toes[1] if two else beyond(ridge, self.down, deep)
        self.sketch.face([ridge, toes[0], heel], 2, -2.0)
        foot, wide = ((toes[0][0] + heel[0]) / 2, (toes[0][1] + heel[1]) / 2), apart(toes[0], heel)
        rail(self.sketch, foot, self.down, wide / 2 + 0.7)
        self.ridges += [ridge] if two else []
        self.on_wedge[wedge.name] = None
        for name, at, _, along in joined:
            up = left_of(along)
            self.on_wedge[name] = Way(at, along, up if inner(up, self.down) < 0 else scaled(up, -1.0))

    def wheels(self) -> Iterator[tuple[Way, float]]:
        """The ways of round bodies that roll, on no support that the reactions show, with their radii."""
        for name, shape in self.system.problem.figure.shapes.items():
            p = next((p for p in self.system.configuration.points if p.name == name), None)
            if p is None or shape.kind not in (Outline.DISC, Outline.RING, Outline.SPHERE):
                continue
            way = self.way(p)
            rolls = re.search(r"\brolls?|rolling", self.system.text) and not self.system.reactions_on(name)
            if way is not None and not way.is_upright and rolls:
                yield way, abs(self.system.number(shape.lengths[0])) * self.system.page.scale

    def feet(self) -> Iterator[tuple[Way, float]]:
        """Where the lowest points of a weightless frame, which no constraint keeps there, move on a level floor."""
        points, page = self.system.configuration.points, self.system.page
        if any(p.mass != 0 for p in points) or not FLOOR.search(self.system.text):
            return
        poses = (self.system.pose, *self.system.pose.others)
        ways = {p.name: [page(x.at(p.position)) for x in poses] for p in points}
        lowest = max(inner(way[0], self.down) for way in ways.values())
        for name, way in ways.items():
            levels = [inner(at, self.down) for at in way]
            stays = max(levels) - min(levels) < SAME_ON_PAGE and lowest - levels[0] < SAME_ON_PAGE
            if stays and max(apart(way[0], at) for at in way) > SAME_ON_PAGE and not self.system.reactions_on(name):
                yield Way(way[0], left_of(self.down), scaled(self.down, -1.0)), 0.0

    def ends_of_rods(self) -> Iterator[tuple[Way, float]]:
        """Where an end of a rod slides that coordinates alone keep on a floor or at a wall, if the text has both."""
        page, text = self.system.page, self.system.text
        for name, shape in self.system.problem.figure.shapes.items():
            if not shape.ends or self.system.reactions_on(name) or not (WALL.search(text) and FLOOR.search(text)):
                continue
            for end in shape.ends:
                poses = (self.system.pose, *self.system.pose.others)
                places = [page(x.at(end)) for x in poses]
                reach = [max(abs(at[n] - places[0][n]) for at in places) for n in (0, 1)]
                if min(reach) < SAME_ON_PAGE < max(reach):
                    along = (0.0, 1.0) if reach[0] < SAME_ON_PAGE else (1.0, 0.0)
                    side = left_of(along)
                    yield Way(places[0], along, side if inner(side, self.down) <= 0 else scaled(side, -1.0)), 0.0

    def particles(self) -> Iterator[MassPoint]:
        """The particles, and the bodies that do not turn: a cart may be either."""
        moving = {*self.system.configuration.slots.coordinates}
        turning = {
            r.name
            for r in self.system.configuration.rotations
            if any(axis.fixed().as_sum().free_symbols & moving for axis in r.axes)
        }
        other = turning | {*self.system.problem.figure.shapes} | self.system.hidden
        yield from (p for p in self.system.configuration.points if p.name not in other)

    def way(self, p: MassPoint) -> Way | None:
        """The line on which a particle moves by each of its coordinates, with nothing drawn to keep it there."""
        pose, page = self.system.pose, self.system.page
        moving = [q for q in pose.coordinates if not p.position.fixed().partial(q).is_zero]
        if not moving:
            return None
        with suppress(NoValueError):
            at = page(pose.at(p.position))
            ways = [toward(at, page(pose.moved(q, 1.0).at(p.position))) for q in moving]
            on_line = all(abs(w[0] * ways[0][1] - w[1] * ways[0][0]) < SAME_ON_PAGE for w in ways)
            if on_line and all(is_distance(pose, q, p.position) for q in moving):
                along = ways[0]
                side = left_of(along)
                return Way(at, along, side if inner(side, self.down) <= 0 else scaled(side, -1.0))
        return None

    def surface(self, p: MassPoint) -> Way | None:
        """The line of a constraint on which a particle alone is kept, or the tangent of its curve."""
        pose, page = self.system.pose, self.system.page
        for reaction in self.system.newton.reactions:
            by = reaction.constraint.by
            link = by in (Keeper.ROD, Keeper.STRING) or (
                by is None and (ROD.search(reaction.name) or is_string(reaction))
            )
            if link or reaction.rod is not None or set(reaction.directions or ()) != {p.name}:
                continue
            force = reaction.per_unit(p.name)
            if force is None:
                continue
            with suppress(NoValueError):
                push = toward((0.0, 0.0), page.way(pose.at(force)))
                up = push if inner(push, self.down) <= 0 else scaled(push, -1.0)
                return Way(page(pose.at(p.position)), left_of(up), up)
        return None

    def is_block(self, p: MassPoint) -> bool:
        """Whether the text calls a particle a block, or a spring pulls it along a table or rail."""
        way = self.way(p) if any(p.name in link.ends for link in self.system.links) else None
        if way is not None and not way.is_upright and _GROUND.search(_IN_PLANE.sub("", self.system.text)):
            return True
        name = p.name.replace("_", " ")
        text = f"{self.system.problem.title} {self.system.problem.description}"
        weighed = re.search(rf"\b(?i:{_BLOCK})s? of mass \$?{re.escape(str(p.mass))}\b", text)
        called = weighed or re.search(rf"\b(?i:{_BLOCK})s?( of mass \w+)?,? \(?{re.escape(name)}\b", text)
        weightless = all(q.mass == 0 for q in self.system.configuration.points)  # at rest: weights are forces
        others = [q for q in self.particles() if q.mass != 0 or weightless]
        return (
            (p.mass != 0 or weightless)
            and "wedge" not in name
            and bool(_WORD.search(name) or called or _SEVERAL.search(text) or (len(others) == 1 and _WORD.search(text)))
        )

    def is_carried(self, way: Way, p: MassPoint) -> bool:
        """Whether the text says that something carries what moves on a line, or a vehicle stands on it."""
        if way.is_upright:
            return bool(WALL.search(self.system.text))
        if self.is_block(p) and _VEHICLE.search(p.name.replace("_", " ")):
            return True
        return bool(_GROUND.search(_IN_PLANE.sub("", self.system.text)))

    def height(self, p: MassPoint) -> float:
        """The height of a block: more where a spring and a damper hold it side by side."""
        pairs = [frozenset(link.ends) for link in self.system.links if p.name in link.ends]
        return HIGH if len({*pairs}) == len(pairs) else 2 * HIGH

    def block(self, p: MassPoint, way: Way | None, carries: str | None) -> None:
        """A box: on the ground, on a plane that is drawn, or around its particle; up to a block that it carries."""
        kept = self.on_wedge.get(p.name) or self.surface(p) or self.along_bar(p)
        on = kept or way
        at = self.system.page(self.system.pose.at(p.position))
        hangs = on is None or (kept is None and way is not None and way.is_upright)
        up = scaled(self.down, -1.0) if hangs or on is None else on.up
        side = left_of(up)
        height = self.height(p)
        low, high = (0.0, height) if kept is not None else (-height / 2, height / 2)
        if self.on_board.get(p.name):
            low, high = self.on_board[p.name], self.on_board[p.name] + height
        elif kept is not None and self.along_bar(p) is not None:
            low, high = -height / 2, height / 2
        left, right = WIDE / 2, -WIDE / 2
        if carries is not None and on is not None:
            position = next(q.position for q in self.particles() if q.name == carries)
            x, y = self.system.page(self.system.pose.at(position))
            high = inner((x - at[0], y - at[1]), up) - HIGH / 2
            reach = inner((x - at[0], y - at[1]), side)
            left, right = max(reach, 0.0) + WIDE, min(reach, 0.0) - WIDE
            self.carried += [(Way(beyond(at, side, x), on.along, on.up), height / 2) for x in (left, right)]
        corners = ((left, low), (right, low), (right, high), (left, high))
        if _BOAT.search(p.name.replace("_", " ")):
            corners = ((0.6 * left, low), (0.6 * right, low), (1.4 * right, high), (1.4 * left, high))
        self.sketch.face([beyond(beyond(at, side, x), up, y) for x, y in corners], 2, -1.0)
        if kept is None:
            self.half[p.name] = height / 2 if hangs else WIDE / 2

    def along_bar(self, p: MassPoint) -> Way | None:
        """The line of the rod body on which a collar sits."""
        at = self.system.page(self.system.pose.at(p.position))
        for shape in self.system.problem.figure.shapes.values():
            if shape.kind is not Outline.ROD or re.search(r"\b(collar|sleeve|slider|ring|bead)", p.name) is None:
                continue
            a, b = (self.system.page(self.system.at(end)) for end in shape.ends)
            if lies_on(at, a, b) and min(apart(at, a), apart(at, b)) > 0.3:
                along = toward(a, b)
                side = left_of(along)
                return Way(at, along, side if inner(side, self.down) <= 0 else scaled(side, -1.0))
        return None

    def grounds(self) -> None:
        """One piece of ground for all that move on one line, with gaps for the rods that are drawn."""
        carried = self.carried
        done: list[Way] = []
        mounted = []
        for way, _ in carried:
            if any(self.same(way, other) for other in done):
                continue
            done.append(way)
            reach = [(other.at, h) for other, h in carried if self.same(way, other)]
            places, here = [inner(at, way.along) for at, _ in reach], inner(way.at, way.along)
            low = max(h for _, h in reach)
            margin = max(WIDE / 2, low) + 0.7
            start, end = min(places) - margin, max(places) + margin
            down = scaled(way.up, -1.0)
            foot = beyond(way.at, down, low)
            for at, centre in self.stops(way):
                stop = inner(at, way.along)
                start, end = (start, stop) if stop > sum(places) / len(places) else (stop, end)
                if centre is not None:
                    back = 2.4 * CORNER if stop < sum(places) / len(places) else -2.4 * CORNER
                    start, end, stop = (
                        (start + back, end, stop + back) if back > 0 else (start, end + back, stop + back)
                    )
                    self.sketch.line([centre, beyond(foot, way.along, stop - here)], StrokeKind.LINK)
                    mounted.append(centre)
            middle, half = (start + end) / 2 - here, (end - start) / 2
            if way.is_upright:
                self.wall(way, beyond(way.at, way.along, middle), half)
            else:
                through = [line for line in self.busy if apart(*line) > 2 * HIGH]
                rail(self.sketch, beyond(foot, way.along, middle), down, half, through)
        for at, centre in self.corners:
            if centre in mounted or any(apart(at, ridge) < 0.3 for ridge in self.ridges):
                continue  # at the edge of a table, or on the ridge of a wedge
            inward = toward(at, centre)
            held = beyond(centre, inward, 3 * CORNER)
            self.sketch.line([centre, held], StrokeKind.LINK)
            self.sketch.wall(held, (-inward[0], -inward[1]), 0.3)

    def stops(self, way: Way) -> list[tuple[PagePoint, PagePoint | None]]:
        """Where a ground ends: walls, and pulleys at its edge, each with the centre of the pulley."""
        moving = {*self.system.pose.coordinates}
        ends = {e for link in self.system.links for e in link.ends if isinstance(e, Vector)}
        places = [
            self.system.page(self.system.pose.at(e)) for e in ends if not e.fixed().as_sum().free_symbols & moving
        ]
        if WALL.search(self.system.text) and not places:
            places.append((0.0, 0.0))
        found: list[tuple[PagePoint, PagePoint | None]] = [(e, None) for e in places if self.is_on(way, e)]
        return [*found, *((at, centre) for at, centre in self.corners if self.is_on(way, at))]

    def is_on(self, way: Way, at: PagePoint) -> bool:
        """Whether a place is on a line."""
        return self.same(way, Way(at, way.along, way.up))

    def wall(self, way: Way, centre: PagePoint, long: float) -> None:
        """A wall along which something slides, on the other side than the rest of the system."""
        others = [self.system.page(self.system.pose.at(p.position)) for p in self.system.configuration.points]
        mean = sum(x for x, _ in others) / len(others)
        inward = (1.0, 0.0) if mean >= way.at[0] else (-1.0, 0.0)
        self.sketch.wall(centre, inward, long)

    @staticmethod
    def same(a: Way, b: Way) -> bool:
        """Whether two ways are on one line."""
        across = left_of(a.along)
        turned = abs(a.along[0] * b.along[1] - a.along[1] * b.along[0])
        return turned < SAME_ON_PAGE and abs(inner(across, (b.at[0] - a.at[0], b.at[1] - a.at[1]))) < SAME_ON_PAGE


# Slopes


def mark_slopes(system: SystemPicture, sketch: Sketch, down: PagePoint) -> None:
    """Draw the angle of each slope once: a dashed horizontal through the foot of the plane, an arc, the letter."""
    field = system.down
    if field is None or not system.view.planar or len(system.view.shown) < 2:
        return
    drawn = {mark.label for mark in system.problem.figure.marks}
    placed = [c for p in system.configuration.points for c in p.position.fixed().components]
    used = {s for c in (*field.fixed().components, *placed) for s in c.free_symbols}
    angles = [p.symbol for p in system.problem.parameters if p.symbol in used and p.symbol not in drawn]
    grounds = [line for line in sketch.lines if line.kind is StrokeKind.GROUND and len(line.points) == 2]
    for line in grounds:
        low, high = sorted(line.points, key=lambda at: -(at[0] * down[0] + at[1] * down[1]))
        symbol = next((s for s in angles if _is_slope(system, s, low, high, down)), None)
        if symbol is not None:
            _mark(sketch, symbol, low, high, down)
            angles.remove(symbol)


def _slope(low: PagePoint, high: PagePoint, down: PagePoint) -> float:
    """The angle of a line with the horizontal."""
    way = toward(low, high)
    return math.asin(max(-1.0, min(1.0, -(way[0] * down[0] + way[1] * down[1]))))


def _is_slope(system: SystemPicture, symbol: sp.Symbol, low: PagePoint, high: PagePoint, down: PagePoint) -> bool:
    try:
        size = system.pose.number(symbol)
    except NoValueError:
        return False
    slope = _slope(low, high, down)
    return LEAST_SLOPE < slope < STEEPEST_SLOPE and abs(slope - size) < SAME_SHAPE and apart(low, high) > 2 * SLOPE_ARC


def _mark(sketch: Sketch, symbol: sp.Symbol, low: PagePoint, high: PagePoint, down: PagePoint) -> None:
    up_slope = toward(low, high)
    level = (-down[1], down[0])
    if level[0] * up_slope[0] + level[1] * up_slope[1] < 0:
        level = (-level[0], -level[1])
    slope = _slope(low, high, down)
    ways = [(level[0] * math.cos(a) - down[0] * math.sin(a), level[1] * math.cos(a) - down[1] * math.sin(a))
            for a in (slope * k / 12 for k in range(13))]  # fmt: skip
    sketch.line([low, beyond(low, level, SLOPE_ARC + 0.35)], StrokeKind.REFERENCE)
    arc = [beyond(low, way, SLOPE_ARC) for way in ways]
    sketch.arc(arc, StrokeKind.ANGLE)
    sketch.label(symbol, arc[6], toward(low, arc[6]), optional=True)
