"""What the section `figure` of a file adds to a picture: the ground, strings over pulleys, curves and surfaces, marks.

A string goes around a pulley on the side away from its neighbours: from a point at the distance d of the centre, it
touches the circle of radius R where the angle at the centre is arccos(R/d) from the direction of the point.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import sympy as sp

from lagrange.core.symbols import UnitVector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, plus, unit
from lagrange.pictures.limits import CURVE_STEPS, FACES_OF_TURN, NEARLY_FLAT, SAME_ON_PAGE, SURFACE_FACES
from lagrange.pictures.sketch import PARTICLE, Sketch, apart, beyond, left_of, overlapping, toward
from lagrange.pictures.solids import LIGHT, Solids
from lagrange.pictures.springs_dampers import draw_damper, draw_spring
from lagrange.pictures.systems import SystemPicture
from lagrange.pictures.views import View
from lagrange.problem.model import AppliedForce, Drawn, FigureCircle, FigureCurve, FigureLine, FigureMark, Potential

_STROKES = {
    Drawn.GROUND: StrokeKind.GROUND,
    Drawn.RODS: StrokeKind.ROD,
    Drawn.STRINGS: StrokeKind.STRING,
    Drawn.LINES: StrokeKind.REFERENCE,
    Drawn.OUTLINES: StrokeKind.BODY,
    Drawn.CURVE: StrokeKind.CURVE,
}


@dataclass
class DeclaredParts:
    """Draws what the file declares.

    busy  pieces along which a line is drawn
    """

    system: SystemPicture
    sketch: Sketch
    busy: list[tuple[PagePoint, PagePoint]]
    solids: Solids = field(init=False)

    def __post_init__(self) -> None:
        self.solids = Solids(self.system, self.sketch)

    def all(self) -> None:
        """Everything but points and marks. Raises NoValueError."""
        figure = self.system.problem.figure
        for curve in figure.curves:
            self.curve(curve)
        for circle in (*figure.circles, *figure.pulleys.values()):
            self.circle(circle)
        for line in figure.lines:
            self.chain(line)

    def page(self, place: FloatVector) -> PagePoint:
        """The image of a place."""
        return self.system.page(place)

    def circle(self, circle: FigureCircle) -> None:
        """A disc, ring, sphere or circle."""
        centre, radius = self.system.at(circle.centre), abs(self.system.number(circle.radius))
        axis = None if circle.axis is None else self.system.at(circle.axis)
        if axis is None and not self.system.view.planar:
            axis = (0.0, 0.0, 1.0)
        match circle.kind:
            case Drawn.SPHERE:
                self.solids.sphere(centre, radius)
            case Drawn.RING:
                self.solids.disc(centre, axis, radius, 1)
                self.solids.disc(centre, axis, radius * 0.93, 1)
            case Drawn.CURVE:
                self.solids.disc(centre, axis, radius, 0, StrokeKind.CURVE)
            case Drawn.PULLEY:
                self.solids.disc(centre, axis, radius, LIGHT)
                self.sketch.dot(self.page(centre), 0.05)
            case _:
                self.solids.disc(centre, axis, radius, LIGHT)

    def curve(self, curve: FigureCurve) -> None:
        """A curve, or a surface in space."""
        ends = [(self.system.number(a), self.system.number(b)) for a, b in curve.between]
        if len(curve.along) == 2:
            self.surface(curve, ends)
            return
        [(start, end)] = ends
        [symbol] = curve.along
        points = [
            self.page(self.system.at(curve.point, {symbol: start + (end - start) * k / CURVE_STEPS}))
            for k in range(CURVE_STEPS + 1)
        ]
        if curve.kind is Drawn.GROUND:
            self.sketch.ground(points)
        elif curve.kind is Drawn.OUTLINES:
            self.sketch.face(points, LIGHT)
        else:
            self.sketch.line(points, _STROKES[curve.kind])

    def surface(self, curve: FigureCurve, ends: Sequence[tuple[float, float]]) -> None:
        """A surface in faces, the darker the more they turn away from the light, with some lines of the grid."""
        u, v = curve.along

        def place(m: float, n: float) -> FloatVector:
            values = [a + (b - a) * k for (a, b), k in zip(ends, (m, n), strict=True)]
            return self.system.at(curve.point, {u: values[0], v: values[1]})

        turns = [math.dist(place(*first), place(*last)) < SAME_ON_PAGE < math.dist(place(*first), place(0.3, 0.3))
                 for first, last in (((0, 0.7), (1, 0.7)), ((0.7, 0), (0.7, 1)))]  # fmt: skip
        rows, columns = (FACES_OF_TURN if turn else SURFACE_FACES for turn in turns)
        grid = [[place(m / rows, n / columns) for n in range(columns + 1)] for m in range(rows + 1)]
        patch(self.sketch, self.system.view, self.system.page, grid)

    def chain(self, line: FigureLine) -> None:
        """Rods, strings, ground, springs, wheels."""
        if line.kind in (Drawn.BLADES, Drawn.WHEELS):
            self.tool(line)
            return
        points = (
            self.string(line)
            if line.kind is Drawn.STRINGS
            else [self.page(self.system.at(p)) for p in line.places if not isinstance(p, str)]
        )
        if line.kind in (Drawn.SPRINGS, Drawn.DAMPERS):
            (draw_spring if line.kind is Drawn.SPRINGS else draw_damper)(self.sketch, points[0], points[-1])
            letter = self.coefficient(line.kind)
            if letter is not None and letter.name not in self.system.hidden:
                self.sketch.label_beside(letter, points[0], points[-1], optional=True, clear=0.12)
        elif line.kind is Drawn.OUTLINES:
            self.sketch.face(points, LIGHT)
        elif line.kind is Drawn.GROUND:
            self.sketch.ground(points)
        elif line.kind is Drawn.SUPPORTS:
            return
        else:
            self.sketch.line(points, _STROKES[line.kind])
        self.busy += pairwise(points)

    def coefficient(self, kind: Drawn) -> sp.Symbol | None:
        """The stiffness of the only spring that is drawn, or the coefficient of the only damper: that of the potential,
        or of the force with a velocity, which is proportional to it.
        """
        problem = self.system.problem
        if sum(line.kind is kind for line in problem.figure.lines) != 1:
            return None
        if kind is Drawn.SPRINGS:
            sizes: list[tuple[sp.Expr, ...]] = [(f.energy,) for f in problem.forces if isinstance(f, Potential)]
        else:
            speeds = {*problem.slots.velocities}
            vectors = [f.vector.fixed() for f in problem.forces if isinstance(f, AppliedForce)]
            sizes = [v.components for v in vectors if v.as_sum().free_symbols & speeds]
        found = [
            p.symbol
            for p in problem.parameters
            for size in sizes
            if all(sp.expand(c - p.symbol * sp.expand(c).coeff(p.symbol)) == 0 for c in size)
        ]
        return found[0] if len(found) == 1 else None

    def string(self, line: FigureLine) -> list[PagePoint]:
        """The way of a string, around pulleys where it meets them."""
        pulleys = self.system.problem.figure.pulleys
        rough = [self.page(self.system.at(pulleys[p].centre if isinstance(p, str) else p)) for p in line.places]
        points: list[PagePoint] = []
        for n, place in enumerate(line.places):
            if not isinstance(place, str):
                points.append(rough[n])
                continue
            radius = abs(self.system.number(pulleys[place].radius)) * self.system.page.scale
            before, after = rough[max(n - 1, 0)], rough[min(n + 1, len(rough) - 1)]
            points += around(rough[n], radius, before, after)
        return points

    def tool(self, line: FigureLine) -> None:
        """A blade or a wheel seen from above: of the same size on every page."""
        at, along = (self.system.at(p) for p in line.places if not isinstance(p, str))
        centre, way = self.page(at), self.system.page.way(along)
        if self.system.view.planar:
            way = toward((0.0, 0.0), way)
        half = 0.42 if line.kind is Drawn.BLADES else 0.3
        wide = 0.035 if line.kind is Drawn.BLADES else 0.1
        side = left_of(way)
        corners = [
            beyond(beyond(centre, way, s * half), side, r * wide) for s, r in ((1, 1), (-1, 1), (-1, -1), (1, -1))
        ]
        self.sketch.face(corners, 4)

    def points(self, called: Callable[[str], sp.Expr | str]) -> None:
        """The lettered points."""
        for name, place in self.system.figure_places.items():
            at = self.page(place)
            self.sketch.dot(at, PARTICLE * 0.6)
            self.sketch.label(called(name), at, (0.6, 0.8), clear=PARTICLE, optional=True)

    def marks(self) -> None:
        """Angles, lengths and arrows."""
        for mark in self.system.marks:
            try:
                vectors = [self.system.at(v) for v in mark.vectors]
            except NoValueError:
                continue
            if mark.kind is Drawn.ANGLES:
                self.angle(mark, *vectors)
            else:
                self.length(mark, *vectors)

    def angle(self, mark: FigureMark, at: FloatVector, start: FloatVector, end: FloatVector) -> None:
        """The arc from one direction to the other, with thin lines along those that have none."""
        u, w = unit(start), unit(end)
        size = math.acos(max(-1.0, min(1.0, inner(u, w))))
        if size < 0.03:
            return
        normal = outer(u, w)
        v = unit(outer(normal, u)) if math.hypot(*normal) > 1e-9 else unit(outer((0.0, 0.0, 1.0), u))
        ways = [plus((math.cos(s) * u[0], math.cos(s) * u[1], math.cos(s) * u[2]), v, math.sin(s)) for s in
                (size * k / 20 for k in range(21))]  # fmt: skip
        centre = self.page(at)
        arcs = sum(line.kind is StrokeKind.ANGLE and apart(centre, line.points[0]) < 1.6 for line in self.sketch.lines)
        radius = 0.62 + 0.22 * arcs
        flat = [self.system.page.way(w) for w in ways]
        for way in (flat[0], flat[-1]):
            side = (centre, beyond(centre, way, radius + 0.35))
            if not any(_along(side, b) for b in self.busy):
                self.sketch.line(side, StrokeKind.REFERENCE)
        arc = [beyond(centre, way, radius) for way in flat]
        self.sketch.arc(arc, StrokeKind.ANGLE)
        self.sketch.label(mark.label, arc[10], toward(centre, arc[10]), optional=True)

    def length(self, mark: FigureMark, start: FloatVector, end: FloatVector) -> None:
        """A length between two places, or an arrow."""
        a, b = self.page(start), self.page(end)
        if apart(a, b) < 0.2:
            return
        if mark.kind is Drawn.ARROWS:
            self.sketch.arrow(a, b, StrokeKind.FORCE if self.is_force(mark.label) else StrokeKind.AXIS)
            self.sketch.label(self.short(mark.label), b, toward(a, b), optional=True)
            return
        if not any(_along((a, b), other) for other in self.busy):
            self.sketch.dimension(a, b)
        self.sketch.label_beside(mark.label, a, b, optional=True)

    def is_force(self, label: sp.Expr) -> bool:
        """Whether a label is made of the letters of applied forces, as W or F cos ωt."""
        loads = self.system.configuration.loads
        letters = {s for f in loads for s in f.vector.fixed().as_sum().free_symbols}
        letters -= {s for p in self.system.configuration.points for s in p.position.fixed().as_sum().free_symbols}
        return bool(label.free_symbols & letters) and not isinstance(label, UnitVector)

    def short(self, label: sp.Expr) -> sp.Expr:
        """The name of an axis without that of its body, where there is only one."""
        bodies = self.system.problem.bodies
        name = str(label)
        if isinstance(label, UnitVector) and len(bodies) == 1 and name.endswith(f"_{bodies[0].name}"):
            return UnitVector(name.removesuffix(f"_{bodies[0].name}"))
        return label


def _along(a: tuple[PagePoint, PagePoint], b: tuple[PagePoint, PagePoint]) -> bool:
    return overlapping(a, b)


def around(centre: PagePoint, radius: float, before: PagePoint, after: PagePoint) -> list[PagePoint]:
    """The arc on which a string from one point to another goes around a circle, away from the two points."""
    middle = ((before[0] + after[0]) / 2, (before[1] + after[1]) / 2)
    away = toward(middle, centre)
    turns = []
    for p in (before, after):
        distance = apart(centre, p)
        way = toward(centre, p)
        lean = math.acos(max(-1.0, min(1.0, radius / distance))) if distance > radius else 0.0
        base = math.atan2(way[1], way[0])
        candidates = (base + lean, base - lean)
        turns.append(max(candidates, key=lambda t: _outside(t, away, p, middle)))
    first, last = turns
    top = math.atan2(away[1], away[0])
    first = top + _wrapped(first - top)
    last = top + _wrapped(last - top)
    return [
        beyond(centre, (math.cos(first + (last - first) * k / 24), math.sin(first + (last - first) * k / 24)), radius)
        for k in range(25)
    ]


def _outside(turn: float, away: PagePoint, p: PagePoint, middle: PagePoint) -> float:
    """How far a point of the circle lies on the side of p, and away from both points."""
    side = (p[0] - middle[0], p[1] - middle[1])
    size = math.hypot(*side) or 1.0
    return math.cos(turn) * (0.5 * away[0] + side[0] / size) + math.sin(turn) * (0.5 * away[1] + side[1] / size)


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi


def _brightness(grid: Sequence[Sequence[FloatVector]], m: int, n: int, light: FloatVector) -> float:
    """The cosine of the angle between the normal of a face and the light; −1 for a face without an area."""
    normal = outer(minus(grid[m + 1][n + 1], grid[m][n]), minus(grid[m][n + 1], grid[m + 1][n]))
    return -1.0 if math.hypot(*normal) < 1e-12 else abs(inner(unit(normal), light))


def patch(
    sketch: Sketch, view: View, page: Callable[[FloatVector], PagePoint], grid: Sequence[Sequence[FloatVector]]
) -> None:
    """A surface given by a grid of places: light from the upper left, in front of what is farther from the reader.

    What bends little is of one shade, as the border of two would be a staircase of faces.
    """
    light = unit(plus(view.toward_reader, (0.2, -0.5, 0.9)))
    rows, columns = len(grid) - 1, len(grid[0]) - 1
    sides = [[row[0] for row in grid], [row[-1] for row in grid]]
    meets = all(math.dist(a, b) < SAME_ON_PAGE for a, b in zip(*sides, strict=True))  # all around an axis
    brightness = [_brightness(grid, m, n, light) for m in range(rows) for n in range(columns)]
    seen = [b for b in brightness if b >= 0]
    flat = not seen or max(seen) - min(seen) < NEARLY_FLAT
    for m in range(rows):
        for n in range(columns):
            corners = [grid[m][n], grid[m + 1][n], grid[m + 1][n + 1], grid[m][n + 1]]
            bright = brightness[m * columns + n]
            if bright < 0:
                continue
            shade = 2 if bright > 0.75 or flat else 3 if bright > 0.4 else 4
            depth = sum(inner(c, view.toward_reader) for c in corners) / 4
            sketch.face([page(c) for c in corners], shade, depth - 1e3, StrokeKind.FACE)
    edges = [*([] if meets else sides), list(grid[0]), list(grid[-1])]
    for edge in edges:
        points = [page(p) for p in edge]
        if max(apart(points[0], p) for p in points) > 0.05:
            sketch.line(points, StrokeKind.CURVE)
    for k in (1, 2, 3):
        sketch.line([page(p) for p in grid[rows * k // 4]], StrokeKind.GRID)
        sketch.line([page(row[columns * k // 4]) for row in grid], StrokeKind.GRID)
