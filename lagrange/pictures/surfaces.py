"""A particle on a surface or wire f = const whose function f is not specified: a generic one, with its normal.

The picture shows what the derivation says of every such surface: the normal ∇f, a virtual displacement δr in the
tangent plane, and, where time occurs in f, the surface a moment later, with a possible displacement dr = δr + (that of
the surface). The free body beside it has the applied forces, the normal force and the friction.

A particle in space on a surface or a curve that its constraints give: bowls, cones, cylinders, planes, wires.

One relation f(x, y, z) = 0 is a surface. If turning about a line along k through O leaves f as it is, the surface is
drawn by turning a profile, the curve of f in the plane through the axis and the particle; otherwise as a patch of
places around the particle. Two relations leave a curve, which is followed by steps along ∇f × ∇g, each brought back by
Newton's method.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import permutations, product

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import UnitVector, Unspecified, VectorSymbol, differential, t
from lagrange.core.vectors import Vector
from lagrange.document.names import Notation
from lagrange.document.scene import PagePoint, Scene, StrokeKind
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.results import Solution
from lagrange.pictures.declared import patch
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, place, plus, projected, unit
from lagrange.pictures.implied.guides import surface_of_coordinates
from lagrange.pictures.limits import SAME_PLACE
from lagrange.pictures.loads import as_words
from lagrange.pictures.poses import Pose
from lagrange.pictures.sketch import PARTICLE, Sketch, toward
from lagrange.pictures.systems import SystemPicture
from lagrange.pictures.views import View, view
from lagrange.problem.keys import Keeper, Outline
from lagrange.problem.model import BodyShape, Friction

_HALF_PATCH, _PIECES_OF_PATCH = 1.9, 16
_SHIFT = 0.8
_PLACE: FloatVector = (0.2, 3.3, 1.5)
"""Half the width of the patch, its pieces, its displacement in dt, and the place of the particle, in centimetres."""


@record
class _Surface:
    """A generic surface or wire, seen from a viewpoint.

    moves  the direction in which it is carried; None if it is at rest
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
    sketch.label(VectorSymbol(f"nabla({_function(solution).name})"), end, toward(at, end), optional=True)
    virtual = plus(here, way, 1.15)
    _arrow(sketch, surface, here, virtual, VectorSymbol(f"delta(r_{point.name})"), StrokeKind.FORCE)
    if surface.moves is not None:
        moved = plus(here, surface.moves, _SHIFT)
        possible = plus(virtual, surface.moves, _SHIFT)
        _arrow(sketch, surface, here, possible, VectorSymbol(f"d(r_{point.name})"), StrokeKind.FORCE)
        sketch.line([surface.page(virtual), surface.page(plus(virtual, surface.moves, _SHIFT))], StrokeKind.REFERENCE)
        _arrow(sketch, surface, here, moved, _carried(solution), StrokeKind.AXIS)
    sketch.label(as_words(point.name), at, (-0.6, 0.8), clear=PARTICLE, optional=True)
    return sketch.scene(notation)


def _body(sketch: Sketch, surface: _Surface) -> None:
    """The surface, and where it is a moment later."""
    steps = [_HALF_PATCH * (2 * k / _PIECES_OF_PATCH - 1) for k in range(_PIECES_OF_PATCH + 1)]
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
    axes, moves = dict(solution.problem.axes), None
    if relation.has(t):
        [function, *_] = relation.atoms(Unspecified)
        carried = [n for n, argument in enumerate(function.arguments) if argument.has(t) and n < 3]
        along = carried[0] if carried else max(used)
        moves = (float(along == 0), float(along == 1), float(along == 2))
        if not axes and along < 2:
            axes["ijk"[along]] = "right"  # across the page, where the shift is seen
    return _Surface(view(axes, used), moves)


def _carried(solution: Solution) -> sp.Expr | str:
    """What the surface is displaced by in dt: `u dt`."""
    for argument in _function(solution).arguments:
        rate = -sp.diff(argument, t)
        if rate.is_Symbol:
            return rate * differential(t)
    return "in dt"


def _function(solution: Solution) -> Unspecified:
    """The function f of the surface f = const."""
    [relation] = solution.own.configuration.finite_constraints
    function: Unspecified = next(iter(relation.atoms(Unspecified)))
    return function


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
        called = UnitVector(f"F_{point.name}") if len(loads) == 1 else as_words(load.name)
        sketch.label(called, end, toward(at, end), optional=True)
    if any(isinstance(f, Friction) for f in solution.problem.forces):
        back, ahead = surface.page(plus(here, way, -1.1)), surface.page(plus(here, way, 0.9))
        sketch.arrow(at, back, StrokeKind.FORCE)
        sketch.label("friction", back, toward(at, back), optional=True)
        sketch.line([at, ahead], StrokeKind.REFERENCE)
        sketch.label("velocity", ahead, toward(at, ahead), optional=True)
    sketch.label(as_words(point.name), at, (-0.7, 0.5), clear=PARTICLE, optional=True)
    return sketch.scene(notation)


# Space


_STEPS, _TURNS, _HALF = 12, 24, 0.45
"""Pieces of a profile, of a turn, and half the width of a patch as a part of the distance from O to the particle."""
_LONG = 260
"""Steps of a curve to either side of the particle."""
_TABLE = re.compile(r"\b(table|floor|horizontal plane|incline|slope|inclined plane|plane inclined)\b", re.IGNORECASE)
Field = Callable[[FloatVector], float]


@record
class InSpace:
    """What constraints in space look like: surfaces as grids of places, curves, and flat tables with their corners."""

    grids: tuple[list[list[FloatVector]], ...] = ()
    curves: tuple[list[FloatVector], ...] = ()
    tables: tuple[list[FloatVector], ...] = ()

    @property
    def places(self) -> tuple[FloatVector, ...]:
        """The places that have to fit on the page."""
        grids = (place for grid in self.grids for row in (grid[0], grid[-1]) for place in row)
        return (*grids, *(place for line in (*self.curves, *self.tables) for place in line))

    def draw(self, system: SystemPicture, sketch: Sketch) -> None:
        """Draw them."""
        for corners in self.tables:
            sketch.face([system.page(c) for c in corners], 2, -1e4)
        for grid in self.grids:
            patch(sketch, system.view, system.page, grid)
        for line in self.curves:
            sketch.line([system.page(place) for place in line], StrokeKind.CURVE)


def constraints_in_space(system: SystemPicture) -> InSpace:
    """The surface or the curve of every particle that is kept on one, and the tables on which others move."""
    grids, curves, tables = [], [], []
    for p in system.configuration.points if system.is_bare and not system.view.planar else ():
        rotation = next((r for r in system.configuration.rotations if r.name == p.name), None)
        if rotation is not None:
            with suppress(NoValueError):
                low = _lowest(system, p, rotation)
                if low is not None and _TABLE.search(system.text):
                    tables.append(_table_under(system.pose.at(p.position), low))
            continue
        if p.mass == 0:
            continue
        with suppress(NoValueError):
            relations, own = _relations(system, p)
            here = system.pose.at(p.position)
            if len(relations) == 2:
                curves.append(curve(system.pose, relations, own, p.position))
            elif len(relations) == 1:
                field = _field(relations[0], own, p.position.fixed().components, system.pose)
                grids.append(surface(field, here))
            elif _is_on_table(system, p):
                tables.append(_table(here))
            else:
                grid = surface_of_coordinates(system, p)
                grids += [grid] if grid else []
    return InSpace(tuple(grids), tuple(curves), tuple(tables))


def _is_on_table(system: SystemPicture, p: MassPoint) -> bool:
    """Whether the text speaks of a table and the particle moves in a horizontal plane."""
    x, y, z = p.position.fixed().components
    moving = {*system.pose.coordinates}
    flat = not z.free_symbols & moving and len((x.free_symbols | y.free_symbols) & moving) == 2
    return flat and bool(_TABLE.search(system.text))


def _table(here: FloatVector) -> list[FloatVector]:
    """The corners of a flat piece of a horizontal plane, around O and the particle."""
    reach = 1.2 * max(abs(here[0]), abs(here[1]), 1e-3)
    return [(a * reach, b * reach, here[2]) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def _lowest(system: SystemPicture, p: MassPoint, rotation: Rotation) -> float | None:
    """The height of the lowest point of a disc or sphere that rolls on one level; None for any other body."""
    shape = system.problem.figure.shapes.get(p.name)
    if shape is None or shape.kind not in (Outline.DISC, Outline.RING, Outline.SPHERE, Outline.CONE):
        return None
    axis = rotation.axes[rotation.inertia.symmetry_axis] if shape.axis is None else shape.axis
    if shape.kind is Outline.CONE and system.problem.gravity is not None:
        return _under_cone(system, p, shape, axis)
    heights = []
    for pose in (system.pose, *system.pose.others):
        upright = 1.0 if shape.kind is Outline.SPHERE else math.sqrt(max(1 - pose.at(axis)[2] ** 2, 0.0))
        heights.append(pose.at(p.position)[2] - abs(pose.number(shape.lengths[0])) * upright)
    moves = math.dist(system.pose.at(p.position), system.pose.others[0].at(p.position)) if system.pose.others else 0.0
    return heights[0] if moves > SAME_PLACE and max(heights) - min(heights) < SAME_PLACE else None


def _under_cone(system: SystemPicture, p: MassPoint, shape: BodyShape, axis: Vector) -> float | None:
    """The height of the plane on which the tip of a cone stays, with its rim on or above it: it rolls, or is a top."""
    tips, rims = [], []
    for pose in (system.pose, *system.pose.others):
        along, at = unit(pose.at(axis)), pose.at(p.position)
        radius, high = (abs(pose.number(x)) for x in shape.lengths)
        tips.append(plus(at, along, -0.75 * high))
        rims.append(at[2] + 0.25 * high * along[2] - radius * math.sqrt(max(1 - along[2] ** 2, 0.0)))
    stays = len(tips) > 2 and all(math.dist(tips[0], tip) < SAME_PLACE for tip in tips)
    return tips[0][2] if stays and rims[0] > tips[0][2] - SAME_PLACE else None


def _table_under(here: FloatVector, low: float) -> list[FloatVector]:
    """The corners of a flat piece of a horizontal plane under a body, as far as O."""
    reach = 1.3 * max(abs(here[0]), abs(here[1]), abs(here[2] - low))
    return [(here[0] + a * reach, here[1] + b * reach, low) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def _relations(system: SystemPicture, p: MassPoint) -> tuple[list[sp.Expr], list[sp.Symbol]]:
    """The relations on a particle alone, and its coordinates; none if it has not three coordinates of its own."""
    components = p.position.fixed().components
    own = [q for q in system.pose.coordinates if any(c.has(q) for c in components)]
    found: list[sp.Expr] = []
    if len(own) != 3:
        return found, own
    for row in system.configuration.rows:
        reaction = next((r for r in system.newton.reactions if r.name == row.name), None)
        if row.finite is None or reaction is None:
            continue
        f = sp.sympify(row.finite, strict=True)
        moving = f.free_symbols & {*system.pose.coordinates}
        if not moving & {*own}:
            continue
        if not moving <= {*own} or system.is_rod(reaction) or reaction.constraint.by in (Keeper.ROD, Keeper.STRING):
            return [], own
        found.append(f)
    return found, own


def _field(f: sp.Expr, own: Sequence[sp.Symbol], components: Sequence[sp.Expr], pose: Pose) -> Field:
    """f as a function of the place, for Cartesian, cylindrical and spherical coordinates."""
    position = Vector(tuple(components))
    for inverse, order in product((_as_they_are, _cylindrical, _spherical), permutations(own)):
        places = [p.at(position) for p in (pose, *pose.others)]
        if all(math.dist(_with(pose, order, inverse(at)).at(position), at) < SAME_PLACE for at in places):
            return lambda place, o=order, i=inverse: _with(pose, o, i(place)).number(f)  # type: ignore[misc]
    raise NoValueError("other coordinates than these")


def _with(pose: Pose, coordinates: Sequence[sp.Symbol], numbers: FloatVector) -> Pose:
    return Pose(pose.configuration, {**pose.values, **dict(zip(coordinates, numbers, strict=True))})


def _as_they_are(place: FloatVector) -> FloatVector:
    return place


def _cylindrical(place: FloatVector) -> FloatVector:
    x, y, z = place
    return math.hypot(x, y), math.atan2(y, x), z


def _spherical(place: FloatVector) -> FloatVector:
    x, y, z = place
    return math.hypot(*place), math.atan2(math.hypot(x, y), z), math.atan2(y, x)


def _slope(f: Field, at: FloatVector, size: float) -> FloatVector:
    step = 1e-5 * size
    ways = ((step, 0.0, 0.0), (0.0, step, 0.0), (0.0, 0.0, step))
    x, y, z = ((f(plus(at, w)) - f(minus(at, w))) / (2 * step) for w in ways)
    return x, y, z


def _onto(f: Field, at: FloatVector, way: FloatVector | None, size: float) -> FloatVector:
    """The place of the surface near another one, along a direction or the shortest way. Raises NoValueError."""
    for _ in range(30):
        off = f(at)
        slope = _slope(f, at, size)
        along = slope if way is None else way
        rate = inner(slope, along)
        if abs(rate) < 1e-9:
            raise NoValueError("no place of the surface")
        at = plus(at, along, -off / rate)
        if abs(off / rate) * math.hypot(*along) < SAME_PLACE * size:
            return at
    raise NoValueError("no place of the surface")


def surface(f: Field, here: FloatVector) -> list[list[FloatVector]]:
    """Places of a surface around the particle, or all around its axis."""
    size = max(math.hypot(*here), 1e-3)
    if _is_turned(f, here, size):
        profile = _profile(f, here, size)
        start = math.atan2(here[1], here[0])
        angles = [start + 2 * math.pi * n / _TURNS for n in range(_TURNS + 1)]
        return [[(r * math.cos(a), r * math.sin(a), z) for a in angles] for r, z in profile]
    normal = unit(_slope(f, here, size))
    least = min(range(3), key=lambda n: abs(normal[n]))
    u = unit(outer(tuple(1.0 if n == least else 0.0 for n in range(3)), normal))  # type: ignore[arg-type]
    v = outer(normal, u)
    steps = [_HALF * size * (2 * n / _STEPS - 1) for n in range(_STEPS + 1)]
    return [[_onto(f, plus(plus(here, u, a), v, b), normal, size) for b in steps] for a in steps]


def _is_turned(f: Field, here: FloatVector, size: float) -> bool:
    """Whether the surface is one of revolution about k through O: f vanishes where the particle is turned about it."""
    if math.hypot(here[0], here[1]) < 1e-2 * size:
        return False
    x, y, z = here
    turned = [(x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a), z) for a in (0.7, 1.9, 4.1)]
    scale = math.hypot(*_slope(f, here, size)) * size
    return all(abs(f(place)) < 1e-6 * scale for place in turned)


def _profile(f: Field, here: FloatVector, size: float) -> list[tuple[float, float]]:
    """Distance from the axis and height along the profile, from the axis, or from as far below, beyond the particle."""
    radius = math.hypot(here[0], here[1])
    out = (here[0] / radius, here[1] / radius, 0.0)
    around = _half_profile(f, here, out, size, 1.0, closed=True)
    if around[-1] == around[0]:
        return _chosen(around)
    up, down = (_half_profile(f, here, out, size, sense, closed=False) for sense in (1.0, -1.0))
    return _chosen([*reversed(down[1:]), *up])


def _half_profile(
    f: Field, here: FloatVector, out: FloatVector, size: float, sense: float, *, closed: bool
) -> list[tuple[float, float]]:
    """The profile to one side of the particle, as far as is shown; `closed`: far enough to come back, as on a torus."""
    radius, height, step = inner(here, out), here[2], size / 40
    at, points = here, [(radius, height)]
    for _ in range(300 if closed else 120):
        slope = _slope(f, at, size)
        r, z = inner(slope, out), slope[2]
        norm = math.hypot(r, z)
        if norm < 1e-9:
            break
        tangent = plus((0.0, 0.0, sense * r / norm), out, -sense * z / norm)
        try:
            at = _onto(f, plus(at, tangent, step), plus((0.0, 0.0, z / norm), out, r / norm), size)
        except NoValueError:
            break
        distance = inner(at, out)
        if distance < 0:
            points.append((0.0, points[-1][1] + (at[2] - points[-1][1]) / 2))
            break
        points.append((distance, at[2]))
        reached, wider = math.hypot(distance - radius, at[2] - height), distance - radius
        if closed and len(points) > 5 and reached < 0.9 * step:
            return [*points, points[0]]
        limit = 0.2 if wider > 0.05 * reached else 2.5 if wider < -0.05 * reached else 0.6
        if not closed and reached > limit * size:
            break
    return points


def _chosen(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """As many points of a profile as a surface has pieces."""
    chosen = [round(n * (len(points) - 1) / _STEPS) for n in range(_STEPS + 1)]
    return [points[n] for n in chosen] if len(points) > _STEPS else points


def curve(pose: Pose, relations: Sequence[sp.Expr], own: Sequence[sp.Symbol], position: Vector) -> list[FloatVector]:
    """The curve on which two relations between three coordinates hold, to both sides, or around until it closes.

    It is followed in the coordinates, which may be angles and go on beyond a turn. Raises NoValueError.
    """
    slopes = [[f.diff(q) for q in own] for f in relations]
    here = pose.at(position)
    size, radius = max(math.hypot(*here), 1e-3), math.hypot(here[0], here[1])
    step = size / 30
    halves = []
    for sense in (1.0, -1.0):
        reached, points, winds = pose, [here], radius > SAME_PLACE
        for n in range(_LONG):
            first, second = ([reached.number(e) for e in row] for row in slopes)
            way = outer((first[0], first[1], first[2]), (second[0], second[1], second[2]))
            ahead = _along(reached, own, unit(way), 1e-4)
            speed = math.dist(ahead.at(position), points[-1]) / 1e-4
            if speed < 1e-9:
                raise NoValueError("the curve has no direction")
            moved = _along(reached, own, unit(way), sense * step / speed)
            values = projected(relations, slopes, own, moved.values)
            reached = replace(reached, values={**reached.values, **values})
            at = reached.at(position)
            winds = winds and abs(math.hypot(at[0], at[1]) - radius) < SAME_PLACE * size  # about k, as a helix does
            if math.dist(at, (0.0, 0.0, 0.0)) > (2.4 if winds else 1.25) * size:
                break
            points.append(at)
            if n > 5 and math.dist(at, here) < 0.9 * step:
                return [*points, here]
        halves.append(points)
    return [*reversed(halves[1][1:]), *halves[0]]


def _along(pose: Pose, own: Sequence[sp.Symbol], way: FloatVector, by: float) -> Pose:
    return replace(pose, values={**pose.values, **{q: pose.values[q] + by * w for q, w in zip(own, way, strict=True)}})
