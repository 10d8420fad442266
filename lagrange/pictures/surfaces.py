"""A particle on a surface or wire f = const whose function f is not specified: a generic one, with its normal.

The picture shows what the derivation says of every such surface: the normal ∇f, a virtual displacement δr in the
tangent plane, and, where time occurs in f, the surface a moment later, with a possible displacement dr = δr + (that of
the surface). The free body beside it has the applied forces, the normal force and the friction.
"""

from __future__ import annotations

import math

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import UnitVector, Unspecified, VectorSymbol, differential, t
from lagrange.document.math_writer import Notation
from lagrange.document.scene import PagePoint, Scene, StrokeKind
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.results import Solution
from lagrange.pictures.declared import patch
from lagrange.pictures.floats import FloatVector, inner, minus, outer, place, plus, unit
from lagrange.pictures.sketch import PARTICLE, Sketch, toward
from lagrange.pictures.views import View, view
from lagrange.problem.model import Friction

_HALF, _PIECES = 1.9, 16
_SHIFT = 0.8
_PLACE: FloatVector = (0.2, 3.3, 1.5)
"""Half the width of the patch, its pieces, its displacement in dt, and the place of the particle, in centimetres."""


@record
class _Surface:
    """A generic surface or wire, seen from somewhere.

    moves  the direction in which it is carried; None where it is at rest
    """

    view: View
    moves: FloatVector | None

    def page(self, place: FloatVector) -> PagePoint:
        return self.view.flat(place)

    def height(self, x: float, y: float) -> float:
        """The surface above the point (x, y) from the particle: a hill that is steeper on one side."""
        return 0.3 * math.sin(0.9 * y + 0.9) - 0.3 * x - 0.07 * x * x - 0.12 * y

    def at(self, x: float, y: float) -> FloatVector:
        if self.view.planar:
            first, second = self.view.shown
            spot = [0.0, 0.0, 0.0]
            spot[first], spot[second] = 2.6 + x, 1.4 + 0.8 * (math.sin(1.1 * x + 0.5) - math.sin(0.5)) - 0.1 * x * x
            return spot[0], spot[1], spot[2]
        near, right, up = self.sides()
        heights = self.height(x, y) - self.height(0, 0)
        place = (0.0, 0.0, 0.0)
        for way, size in ((near, _PLACE[0] + x), (right, _PLACE[1] + y), (up, _PLACE[2] + heights)):
            place = plus(place, way, size)
        return place

    def sides(self) -> tuple[FloatVector, FloatVector, FloatVector]:
        """The unit vectors, or their opposites, that point at the reader, to the right, and up."""
        signed = []
        for n, (x, y) in enumerate(self.view.units):
            for sign in (1.0, -1.0):
                way = tuple(sign if m == n else 0.0 for m in range(3))
                signed.append((sign * x, sign * y, way))
        up = max(signed, key=lambda s: s[1])[2]
        right = max(signed, key=lambda s: s[0])[2]
        near = min((s for s in signed if inner(s[2], up) == 0 and inner(s[2], right) == 0), key=lambda s: s[0])[2]
        return near, right, up  # type: ignore[return-value]

    def tangent(self) -> FloatVector:
        return unit(minus(self.at(0.006, 0.008) if not self.view.planar else self.at(0.01, 0.0), self.at(0, 0)))

    def normal(self) -> FloatVector:
        if self.view.planar:
            way = self.tangent()
            first, second = self.view.shown
            n = [0.0, 0.0, 0.0]
            n[first], n[second] = -way[second], way[first]
            return n[0], n[1], n[2]
        normal = unit(outer(minus(self.at(0.01, 0), self.at(0, 0)), minus(self.at(0, 0.01), self.at(0, 0))))
        return normal if inner(normal, self.sides()[2]) > 0 else minus((0.0, 0.0, 0.0), normal)


def has_generic_surface(configuration: Configuration) -> bool:
    """Whether a single particle is kept on a surface or wire that is not specified."""
    relations = [sp.sympify(f, strict=True) for f in configuration.finite_constraints]
    return len(configuration.points) == len(relations) == 1 and relations[0].has(Unspecified)


def surface_scene(solution: Solution, notation: Notation) -> Scene | None:
    """The picture of the surface with the particle on it."""
    surface = _surface(solution)
    if surface is None:
        return None
    sketch = Sketch()
    [point] = solution.own.configuration.points
    here, normal, way = surface.at(0, 0), surface.normal(), surface.tangent()
    at = surface.page(here)
    _body(sketch, surface)
    for n in surface.view.shown:
        x, y = surface.view.units[n]
        sketch.arrow((0.0, 0.0), (x * 0.95, y * 0.95), StrokeKind.AXIS)
        sketch.label(UnitVector("ijk"[n]), (x * 0.95, y * 0.95), toward((0.0, 0.0), (x, y)), optional=True)
    sketch.arrow((0.0, 0.0), at, StrokeKind.DIMENSION)
    sketch.label_beside(UnitVector("r"), (0.0, 0.0), at, optional=True)
    sketch.label("O", (0.0, 0.0), (-0.7, -0.7), clear=0.05, optional=True)
    sketch.dot(at)
    end = surface.page(plus(here, normal, 1.25))
    sketch.arrow(at, end, StrokeKind.REACTION)
    sketch.label(UnitVector("n"), end, toward(at, end), optional=True)
    virtual = plus(here, way, 1.15)
    _arrow(sketch, surface, here, virtual, VectorSymbol(f"delta(r_{point.name})"), StrokeKind.FORCE)
    if surface.moves is not None:
        moved = plus(here, surface.moves, _SHIFT)
        possible = plus(virtual, surface.moves, _SHIFT)
        _arrow(sketch, surface, here, possible, VectorSymbol(f"d(r_{point.name})"), StrokeKind.FORCE)
        sketch.line([surface.page(virtual), surface.page(plus(virtual, surface.moves, _SHIFT))], StrokeKind.REFERENCE)
        _arrow(sketch, surface, here, moved, _carried(solution), StrokeKind.AXIS)
    sketch.label(point.name.replace("_", " "), at, (-0.6, 0.8), clear=PARTICLE, optional=True)
    return sketch.scene(notation)


def _body(sketch: Sketch, surface: _Surface) -> None:
    """The surface, and where it is a moment later."""
    steps = [_HALF * (2 * k / _PIECES - 1) for k in range(_PIECES + 1)]
    if surface.view.planar:
        curves = [[surface.at(x, 0.0) for x in steps]]
        sketch.line([surface.page(p) for p in curves[0]], StrokeKind.ROD)
    else:
        grid = [[surface.at(x, y) for y in steps] for x in steps]
        patch(sketch, surface.view, surface.page, grid)
        curves = [grid[0], grid[-1], [row[0] for row in grid], [row[-1] for row in grid]]
    if surface.moves is not None:
        for curve in curves:
            sketch.line([surface.page(plus(p, surface.moves, _SHIFT)) for p in curve], StrokeKind.REFERENCE)


def _arrow(
    sketch: Sketch, surface: _Surface, start: FloatVector, end: FloatVector, label: sp.Expr | str, kind: StrokeKind
) -> None:
    a, b = surface.page(start), surface.page(end)
    sketch.arrow(a, b, kind)
    sketch.label(label, b, toward(a, b), optional=True)


def _surface(solution: Solution) -> _Surface | None:
    configuration = solution.own.configuration
    if not has_generic_surface(configuration):
        return None
    [point] = configuration.points
    components = point.position.fixed().components
    used = frozenset(n for n, c in enumerate(components) if c != 0)
    if len(used) < 2:
        return None
    [relation] = (sp.sympify(f, strict=True) for f in configuration.finite_constraints)
    seen = view(solution.problem.axes, used)
    moves: FloatVector | None = None
    if relation.has(t):
        [function, *_] = relation.atoms(Unspecified)
        carried = [n for n, argument in enumerate(function.arguments) if argument.has(t) and n < 3]
        way = [0.0, 0.0, 0.0]
        way[carried[0] if carried else max(used)] = 1.0
        moves = way[0], way[1], way[2]
    return _Surface(seen, moves)


def _carried(solution: Solution) -> sp.Expr | str:
    """What the surface is displaced by in dt: `u dt`."""
    [relation] = (sp.sympify(f, strict=True) for f in solution.own.configuration.finite_constraints)
    [function, *_] = relation.atoms(Unspecified)
    for argument in function.arguments:
        rate = -sp.diff(argument, t)
        if rate.is_Symbol:
            return rate * differential(t)
    return "in dt"


def surface_free_body(solution: Solution, notation: Notation) -> Scene | None:
    """The particle with the forces on it: those applied, the normal force, friction against the velocity."""
    surface = _surface(solution)
    if surface is None or solution.law is None:
        return None
    newton = solution.law.newton
    sketch = Sketch()
    here, normal, way = surface.at(0, 0), surface.normal(), surface.tangent()
    at = surface.page(here)
    sketch.dot(at)
    [point] = solution.own.configuration.points
    for reaction in newton.reactions:
        end = surface.page(plus(here, normal, 1.3))
        sketch.arrow(at, end, StrokeKind.REACTION)
        label = UnitVector(f"R_{point.name}" if reaction.directions is not None else "R")
        sketch.label(label, end, toward(at, end), optional=True)
    loads = solution.law.configuration.loads  # without friction, which is drawn against the velocity
    for turn, load in enumerate(loads):
        parts = load.vector.fixed().components
        if any(c.has(Unspecified) for c in parts):
            vector: FloatVector = (0.2, 0.75, 0.62 - 0.3 * turn)
        else:
            symbols = set().union(*(c.free_symbols for c in parts))
            vector = unit(place(load.vector, dict.fromkeys(symbols, 1.0)))
        end = surface.page(plus(here, vector, 1.2))
        sketch.arrow(at, end, StrokeKind.FORCE)
        called = UnitVector(f"F_{point.name}") if len(loads) == 1 else load.name.replace("_", " ")
        sketch.label(called, end, toward(at, end), optional=True)
    if any(isinstance(f, Friction) for f in solution.problem.forces):
        back, ahead = surface.page(plus(here, way, -1.1)), surface.page(plus(here, way, 0.9))
        sketch.arrow(at, back, StrokeKind.FORCE)
        sketch.label("friction", back, toward(at, back), optional=True)
        sketch.line([at, ahead], StrokeKind.REFERENCE)
        sketch.label("velocity", ahead, toward(at, ahead), optional=True)
    sketch.label(point.name.replace("_", " "), at, (-0.7, 0.5), clear=PARTICLE, optional=True)
    return sketch.scene(notation)
