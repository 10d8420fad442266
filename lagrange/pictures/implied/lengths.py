"""The letters of lengths that are drawn: of rods and arms, radii, sides of boxes, distances along axes.

A parameter is the length of something if it has the value of that length in the position drawn and in others with other
values of all parameters, which are no coincidence. Its letter stands at the line itself where that is drawn, otherwise
at a dimension line; at a radius of what is round. A letter that is in the figure already is not written again.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations, islice
from random import Random

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Sign, t
from lagrange.core.vectors import Vector
from lagrange.document.scene import FAINT, PagePoint, Polyline, StrokeKind
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, plus, projected, unit
from lagrange.pictures.implied.guides import cylinders_touched, hoops, ropes_to_supports
from lagrange.pictures.implied.halves import halves
from lagrange.pictures.limits import (
    CURVE_STEPS,
    DIMENSION_ROWS,
    MOST_OPTIONS,
    MOST_PLACES,
    SAME_ON_PAGE,
    SAME_PLACE,
    VARIATION,
)
from lagrange.pictures.linkages import links, parameter_of
from lagrange.pictures.poses import circle_of
from lagrange.pictures.shapes import in_space, plane_rotation
from lagrange.pictures.sketch import (
    NEAR,
    LabelRequest,
    Sketch,
    apart,
    beside,
    beyond,
    crossing,
    dimension_lines,
    inner_product,
    left_of,
    lies_on,
    overlapping,
    same_ends,
    scaled,
    touches,
    toward,
)
from lagrange.pictures.solids import TURN, across
from lagrange.pictures.systems import SystemPicture, rod_ends
from lagrange.pictures.views import PaperMap
from lagrange.problem.model import Outline

_ROUND = (Outline.DISC, Outline.RING, Outline.SPHERE, Outline.CONE)
_SHORTEST = 0.22
"""Length in centimetres of a line beside which a letter has room."""
_FACTORS = (sp.S.One, sp.Integer(2), sp.S.Half)


@record
class Round:
    """A circle, or the part of one that is drawn, in space; `rim` are places on it."""

    centre: FloatVector
    radius: float
    rim: tuple[FloatVector, ...]


def other_values(system: SystemPicture) -> list[SystemPicture]:
    """The same system in two positions with other values of all parameters, where the constraints allow it."""
    found = []
    pose, finite = system.pose, system.configuration.finite_constraints
    slopes = [[sp.sympify(f, strict=True).diff(q) for q in pose.coordinates] for f in finite]
    parameters = {p.symbol for p in system.problem.parameters if not isinstance(p.symbol, Sign)} | {t}
    random = Random(2)
    for _ in range(8):
        values = {s: v * (1 + random.uniform(-VARIATION, VARIATION)) if s in parameters else v
                  for s, v in pose.values.items()}  # fmt: skip
        for q in pose.coordinates:
            values[q] += random.uniform(-VARIATION, VARIATION)
        with suppress(NoValueError):
            at = replace(pose, values=projected(finite, slopes, pose.coordinates, values))
            varied = replace(system, pose=at)
            varied.figure_places  # noqa: B018  it has values
            found.append(varied)
        if len(found) == 2:
            break
    return found


def places_of(system: SystemPicture) -> dict[str, FloatVector]:
    """The places between which a length may be, by what is there."""
    at = {"O": (0.0, 0.0, 0.0)}
    at |= {p.name: system.pose.at(p.position) for p in system.configuration.points}
    at |= {f"point {name}": place for name, place in system.figure_places.items()}
    for n, (_, rod) in enumerate(system.rods):
        if rod.centre is not None:
            at[f"centre {n}"] = system.pose.at(rod.centre)
    for n, link in enumerate(system.links):
        at |= {f"link {n} {m}": system.pose.at(e) for m, e in enumerate(link.ends) if isinstance(e, Vector)}
    for name, shape in system.problem.figure.shapes.items():
        at |= {f"end {name} {m}": system.at(e) for m, e in enumerate(shape.ends)}
    for n, line in enumerate(system.problem.figure.lines):
        at |= {f"line {n} {m}": system.at(e) for m, e in enumerate(line.places) if isinstance(e, Vector)}
    at |= {f"rope {n}": end for n, (end, _) in enumerate(ropes_to_supports(system))}
    for n, load in enumerate(system.configuration.loads):
        with suppress(NoValueError):
            at[f"load {n}"] = system.pose.at(load.point)
    for kind, groups in (("joint", system.joints), ("carried", system.carried), ("fastened", system.fastened)):
        at |= {f"{kind} {name} {m}": place for name, places in groups.items() for m, place in enumerate(places)}
    at |= {f"link {name} {m}": place for name, held in links(system).held.items() for m, place in enumerate(held)}
    for p in system.configuration.points:
        rotation = plane_rotation(system.configuration, p.name)
        if rotation is not None:
            for m, held in enumerate(system.shapes[p.name].held):
                at[f"held {p.name} {m}"] = plus(system.pose.at(p.position), in_space(system.pose, rotation, held))
    return at


def rounds_of(system: SystemPicture) -> dict[str, Round]:
    """What is round, by what it is."""
    found: dict[str, Round] = {}
    figure, view = system.problem.figure, system.view
    for n, circle in enumerate((*figure.circles, *figure.pulleys.values())):
        axis = None if circle.axis is None else system.at(circle.axis)
        found[f"circle {n}"] = _whole(system, system.at(circle.centre), abs(system.number(circle.radius)), axis)
    for p in system.configuration.points:
        shape, centre = figure.shapes.get(p.name), system.pose.at(p.position)
        turning = next((r for r in system.configuration.rotations if r.name == p.name), None)
        if shape is not None and shape.kind in _ROUND:
            axis = None if shape.axis is None else system.at(shape.axis)
            if axis is None and turning is not None and shape.kind is not Outline.SPHERE:
                axis = system.pose.at(turning.axes[turning.inertia.symmetry_axis])
            if shape.kind is not Outline.CONE:
                found[f"shape {p.name}"] = _whole(system, centre, abs(system.number(shape.lengths[0])), axis)
        elif p.name in system.shapes and system.shapes[p.name].radius:
            found[f"wheel {p.name}"] = _whole(system, centre, system.shapes[p.name].radius, None)
        for q in system.pose.coordinates if p.name in system.paths else ():
            with suppress(NoValueError):
                mark = circle_of(system.pose, q, p.position)
                if mark is not None and any(math.dist(mark.point, at) < 1e-3 for at in system.paths[p.name]):
                    rim = tuple(system.paths[p.name])
                    found[f"path {p.name} {q}"] = Round(mark.centre, math.dist(mark.centre, mark.point), rim)
    for n, (centre, radius) in enumerate((*hoops(system), *cylinders_touched(system), *halves(system))):
        found[f"guide {n}"] = _whole(system, centre, radius, None)
    for n, r in enumerate(system.newton.reactions):
        if r.rod is not None and r.rod.centre is not None and not system.is_rod(r):
            first, second = rod_ends(r.rod, system.configuration, system.pose)
            found[f"track {n}"] = _whole(system, second, math.dist(first, second), None)
    for n, curve in enumerate(figure.curves):
        if len(curve.along) == 1 and view.planar:
            start, end = (system.number(e) for e in curve.between[0])
            steps = (start + (end - start) * k / CURVE_STEPS for k in range(CURVE_STEPS + 1))
            rim = tuple(system.at(curve.point, {curve.along[0]: s}) for s in steps)
            middle = _centre(rim)
            if middle is not None:
                found[f"curve {n}"] = Round(middle, math.dist(middle, rim[0]), rim)
    return found


def _whole(system: SystemPicture, centre: FloatVector, radius: float, axis: FloatVector | None) -> Round:
    """A circle about an axis, or with its outline on the page where that is None, as of a sphere."""
    u, v = across(system.view.toward_reader if axis is None or system.view.planar else unit(axis))
    rim = (plus(plus(centre, u, radius * math.cos(s)), v, radius * math.sin(s)) for s in TURN[:-1])
    return Round(centre, radius, tuple(rim))


def _centre(rim: Sequence[FloatVector]) -> FloatVector | None:
    """The centre of the circle in the plane of the page that a curve is part of; None if it is no circle."""
    a, b, c = rim[0], rim[len(rim) // 3], rim[2 * len(rim) // 3]
    u, v = minus(b, a), minus(c, a)
    normal = outer(u, v)
    size = inner(normal, normal)
    if size < SAME_PLACE:
        return None
    way = outer(plus((0.0, 0.0, 0.0), plus(tuple(inner(u, u) * x for x in v), u, -inner(v, v))), normal)  # type: ignore[arg-type]
    centre = plus(a, way, 1 / (2 * size))
    radii = [math.dist(centre, p) for p in rim]
    return centre if max(radii) - min(radii) < SAME_ON_PAGE else None


@dataclass
class Lengths:
    """Writes the letters into one figure.

    busy   pieces along which a line is drawn
    given  letters that are written already, or that are marked in another way
    """

    system: SystemPicture
    sketch: Sketch
    busy: Sequence[tuple[PagePoint, PagePoint]]
    systems: list[SystemPicture] = field(init=False)

    def __post_init__(self) -> None:
        self.systems = []

    def all(self) -> None:
        """Every letter that is the length of something."""
        missing = self.missing()
        if not missing:
            return
        self.systems = [self.system, *other_values(self.system)]
        if len(self.systems) < 3:
            return
        for symbol in missing:
            options = [*islice(self.options(symbol), MOST_OPTIONS)] or [*self.in_sums(symbol)]
            if options:
                first, *instead = options
                self.sketch.wanted.append(replace(first, optional=True, instead=tuple(instead)))

    def missing(self) -> list[sp.Symbol]:
        """The parameters without a letter in the figure."""
        written = {s for w in self.sketch.wanted if isinstance(w.content, sp.Expr) for s in w.content.free_symbols}
        values = self.system.pose.values
        own = (p.symbol for p in self.system.problem.parameters if not isinstance(p.symbol, Sign))
        return [s for s in own if s not in written and values.get(s) and s.name not in self.system.hidden]

    def options(self, symbol: sp.Symbol) -> Iterator[LabelRequest]:
        """The places for a letter, the best first."""
        for factor in _FACTORS:
            label = factor * symbol
            sizes = [float(factor) * s.pose.values[symbol] for s in self.systems]
            for name in self.rounds[0]:
                if _same(sizes, [r[name].radius for r in self.rounds if name in r]):
                    circle = self.rounds[0][name]
                    yield from self.at_radius(label, self.page(circle.centre), [*map(self.page, circle.rim)])
            for centre, rim in self.arcs if self.system.view.planar else ():
                is_known = parameter_of(self.system, round(apart(centre, rim[0]) / self.page.scale, 9))
                if is_known == symbol and factor == 1:
                    yield from self.at_radius(label, centre, rim)
            yield from self.at_lines(label, sizes)
            yield from self.at_sides(label, sizes)
            if self.system.view.planar:
                yield from self.along_axes(label, sizes)

    def in_sums(self, symbol: sp.Symbol) -> Iterator[LabelRequest]:
        """The places for a letter that is the length of nothing alone: R − r, k l."""
        for other in self.system.problem.parameters:
            if other.symbol != symbol and self.system.pose.values.get(other.symbol):
                for label in (symbol * other.symbol, symbol + other.symbol, symbol - other.symbol):
                    with suppress(NoValueError):
                        yield from self.at_lines(label, [s.number(label) for s in self.systems])

    @property
    def page(self) -> PaperMap:
        """From space to the page."""
        return self.system.page

    @cached_property
    def arcs(self) -> list[tuple[PagePoint, Sequence[PagePoint]]]:
        """The circles of which parts are drawn as ground or track, with their centres, on the page."""
        lines = (line.points for line in self.sketch.lines if line.kind in (StrokeKind.GROUND, StrokeKind.CURVE))
        found: list[tuple[PagePoint, Sequence[PagePoint]]] = []
        for points in lines:
            centre = _centre([(x, y, 0.0) for x, y in points]) if len(points) > 8 else None
            if centre is not None:
                found.append(((centre[0], centre[1]), points))
        return found

    @cached_property
    def rounds(self) -> list[dict[str, Round]]:
        """What is round in each of the systems."""
        return [rounds_of(s) for s in self.systems]

    @cached_property
    def places(self) -> list[dict[str, FloatVector]]:
        """The different places in each of the systems."""
        every = [places_of(s) for s in self.systems]
        known = [name for name in every[0] if all(name in e for e in every)]
        kept: list[str] = []
        for name in known:
            if all(any(math.dist(e[name], e[k]) > SAME_PLACE for e in every) for k in kept):
                kept.append(name)
        return [{name: e[name] for name in kept[:MOST_PLACES]} for e in every]

    # At what is round

    def at_radius(self, label: sp.Expr, centre: PagePoint, rim: Sequence[PagePoint]) -> Iterator[LabelRequest]:
        """At a radius that is drawn, or else at an arrow from the centre to the rim where it crosses least."""
        radius = max(apart(centre, at) for at in rim)
        if radius < _SHORTEST:
            return
        pose = self.system.pose
        measured = any(abs(pose.values[q] * self.page.scale - radius) < SAME_ON_PAGE for q in pose.coordinates)
        for line in self.sketch.lines:
            is_its = measured or line.kind is StrokeKind.DIMENSION
            for a, b in () if is_its else line.pieces:
                for start, end in ((a, b), (b, a)):
                    on_rim = any(apart(end, at) < 0.1 * radius for at in rim)
                    if apart(start, centre) < SAME_ON_PAGE and on_rim and abs(apart(start, end) - radius) < 0.02:
                        yield LabelRequest(label, beside(start, end), reaches=NEAR)
        ends = [at for n, at in enumerate(rim) if n % 2 == 0 and apart(centre, at) > 0.6 * radius]
        for end in sorted(ends, key=lambda at: self.cost(centre, at))[:8]:
            arrow = Polyline((centre, end), StrokeKind.DIMENSION, tip=True)
            outside = ((end, toward(centre, end)),)
            anchors = beside(centre, end, (0.5, 0.6, 0.7, 0.4)) if radius > 0.7 else outside
            yield LabelRequest(label, anchors, lines=(arrow,), reaches=NEAR)

    # Between places

    def at_lines(self, label: sp.Expr, sizes: Sequence[float]) -> Iterator[LabelRequest]:
        """At the lines between two places, the drawn ones first."""
        names = [*self.places[0]]
        found = []
        for a, b in combinations(names, 2):
            if _same(sizes, [math.dist(p[a], p[b]) for p in self.places]):
                ends = self.page(self.places[0][a]), self.page(self.places[0][b])
                if apart(*ends) > _SHORTEST:
                    found.append(ends)
        for ends in sorted(found, key=self.rank)[:4]:
            rank = self.rank(ends)
            if rank == 0 or (rank == 1 and all(map(self.is_dot, ends))):
                yield LabelRequest(label, beside(*ends, (0.5, 0.4, 0.6)), reaches=NEAR)
            if self.system.view.planar:
                yield from self.dimensions(label, *ends)
            elif rank == 3 and all(map(self.is_seen, ends)):
                yield LabelRequest(label, beside(*ends), lines=(Polyline(ends, StrokeKind.GUIDE),), reaches=NEAR)
            if rank <= 2:
                yield LabelRequest(label, beside(*ends), reaches=NEAR)

    def rank(self, ends: tuple[PagePoint, PagePoint]) -> int:
        """0 for a line that is drawn, 1 for a part of one, 2 for one with something in its middle, 3 for none, 4 where
        nothing is seen at its ends."""
        if any(same_ends(ends, b) for b in self.busy):
            inside = [d for d in self.sketch.dots if lies_on(d.at, *ends) and not touches(d.at, *ends)]
            return 2 if inside else 0
        if any(overlapping(ends, b) for b in self.busy):
            return 1
        return 3 if all(map(self.is_seen, ends)) else 4

    def is_dot(self, at: PagePoint) -> bool:
        """Whether there is a particle, mass centre or hinge at a place."""
        return any(apart(d.at, at) < 0.02 for d in self.sketch.dots)

    def is_seen(self, at: PagePoint) -> bool:
        """Whether there is a dot, the end of a line, or the origin of the axes."""
        if apart(at, self.page((0.0, 0.0, 0.0))) < 0.02 and "axes" not in self.system.hidden:
            return True
        return self.is_dot(at) or any(touches(at, *b) for b in self.busy)

    def along_axes(self, label: sp.Expr, sizes: Sequence[float]) -> Iterator[LabelRequest]:
        """At dimension lines along an axis of the file or of a body, between the levels of two places."""
        found = []
        axes = [self.axes_of(s) for s in self.systems]
        for a, b in combinations(self.places[0], 2):
            ways = [minus(p[b], p[a]) for p in self.places]
            for n in range(len(axes[0])):
                if _same(sizes, [abs(inner(w, x[n])) for w, x in zip(ways, axes, strict=True)]):
                    ends = self.page(self.places[0][a]), self.page(self.places[0][b])
                    way = toward((0.0, 0.0), self.page.way(axes[0][n]))
                    found.append((not all(map(self.is_seen, ends)), apart(*ends), ends, way))
        for _, _, (start, end), way in sorted(found)[:4]:
            yield from self.dimensions(label, start, end, way)

    def axes_of(self, system: SystemPicture) -> list[FloatVector]:
        """The axes of the file and of the plane bodies."""
        fixed = [tuple(float(m == n) for m in range(3)) for n in system.view.shown]
        turning = [plane_rotation(system.configuration, p.name) for p in system.configuration.points]
        return [*fixed, *(system.pose.at(x) for r in turning if r is not None for x in r.axes[:2])]  # type: ignore[list-item]

    def at_sides(self, label: sp.Expr, sizes: Sequence[float]) -> Iterator[LabelRequest]:
        """At the sides of boxes."""
        for name, shape in self.system.problem.figure.shapes.items():
            if shape.kind is not Outline.BOX or not self.system.view.planar:
                continue
            centre = next(p.position for p in self.system.configuration.points if p.name == name)
            turning = next((r for r in self.system.configuration.rotations if r.name == name), None)
            if turning is None:
                continue
            e = [self.system.pose.at(x) for x in turning.axes[:2]]
            half = [abs(self.system.number(x)) / 2 for x in shape.lengths]
            for n in (0, 1):
                if _same(sizes, [abs(s.number(shape.lengths[n])) for s in self.systems]):
                    for side in (-1.0, 1.0):
                        edge = plus(self.system.pose.at(centre), e[1 - n], side * half[1 - n])
                        ends = [self.page(plus(edge, e[n], half[n] * s)) for s in (1.0, -1.0)]
                        away = toward((0.0, 0.0), scaled(self.page.way(e[1 - n]), side))
                        yield from self.dimensions(label, ends[0], ends[1], None, away)

    def dimensions(
        self, label: sp.Expr, a: PagePoint, b: PagePoint, way: PagePoint | None = None, away: PagePoint | None = None
    ) -> Iterator[LabelRequest]:
        """Dimension lines from the level of one place to that of another, where they cross least.

        way   their direction, if it is not that from one place to the other
        away  the only side of the places on which they may be
        """
        along = toward(a, b) if way is None else way
        side = left_of(along)
        high = inner_product((b[0] - a[0], b[1] - a[1]), side)
        length = inner_product((b[0] - a[0], b[1] - a[1]), along)
        levels = [s * off + (max(0.0, high) if s > 0 else min(0.0, high)) for s in (1, -1) for off in DIMENSION_ROWS]
        if abs(high) < SAME_ON_PAGE and not any(overlapping((a, b), other) for other in self.busy):
            levels.insert(0, 0.0)
        choices = []
        for level in levels:
            if away is not None and level * inner_product(side, away) <= 0:
                continue
            start = beyond(a, side, level)
            end = beyond(start, along, length)
            lines = [*dimension_lines(start, end)]
            for place, foot in ((a, start), (b, end)):
                if apart(place, foot) > 0.2:
                    gap = toward(place, foot)
                    tail = (beyond(place, gap, 0.1), beyond(foot, gap, 0.08))
                    lines.append(Polyline(tail, StrokeKind.REFERENCE))
            plain = LabelRequest(label, beside(start, end), lines=tuple(lines[:3]), reaches=NEAR)
            cost = self.cost(start, end) + 0.3 * sum(self.cost(*line.points) for line in lines[3:]) + 0.2 * abs(level)
            choices += [(cost, level, replace(plain, lines=tuple(lines))), (cost + 1.5, level, plain)]
        yield from (request for _, _, request in sorted(choices, key=lambda c: c[:2])[:10])

    def cost(self, a: PagePoint, b: PagePoint) -> float:
        """How much a line from a to b would cross or cover."""
        inside = (beyond(a, toward(a, b), 0.05), beyond(b, toward(b, a), 0.05))
        total = 0.0
        for line in (*self.sketch.lines, *(face for _, face in self.sketch.filled)):
            if line.kind in FAINT or line.kind is StrokeKind.HATCH:
                continue
            for piece in line.pieces:
                total += 1.0 * (crossing(inside, piece) is not None)
                total += 4.0 * (apart(*piece) > 0.05 and overlapping(inside, piece))
        total += 3.0 * sum(lies_on(d.at, *inside) for d in self.sketch.dots)
        return total


def _same(first: Sequence[float], second: Sequence[float]) -> bool:
    return len(first) == len(second) and all(abs(a - b) < SAME_PLACE for a, b in zip(first, second, strict=True))
