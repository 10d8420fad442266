"""Free-body diagrams: each particle and body on its own, with an arrow for every force and moment on it.

An applied force has its direction in the position drawn; an unknown reaction has the direction in which it is positive.
All arrows have the same length: magnitudes are not drawn. Forces with nearly the same point and direction are shifted
apart.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.core.vectors import FIXED, Vector, unit_vector
from lagrange.document.math_writer import Notation
from lagrange.document.scene import PagePoint, Scene, StrokeKind, side_by_side
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.dynamics.newton import FreeBody
from lagrange.pictures.floats import FloatVector, NoValueError, minus, outer, plus, unit
from lagrange.pictures.implied.body_shapes import is_bar, with_implied_shapes
from lagrange.pictures.limits import MOST_BODIES, TEXT_WIDTH
from lagrange.pictures.loads import Acting, Arrows, acting_on, as_words
from lagrange.pictures.shapes import in_space, plane_rotation
from lagrange.pictures.sketch import BAR, PARTICLE, Sketch, apart, beyond, farthest, left_of, toward
from lagrange.pictures.solids import TURN, across
from lagrange.pictures.systems import SystemPicture
from lagrange.problem.model import Outline

LARGEST_WHEEL = 0.75
"""Radius of a round body, in centimetres."""
LENGTH = 1.35
"""Length of an arrow, in centimetres."""
LARGEST = 1.1
"""Half the width of any other body whose shape the file gives."""
_NEAR = math.cos(math.radians(20))
"""Cosine of the angle between arrows below which their labels would collide."""


def free_body_scene(system: SystemPicture, notation: Notation) -> Scene | None:
    """The diagrams side by side; None if one of them cannot be drawn."""
    system = with_implied_shapes(system)
    bodies = system.newton.bodies
    if not bodies or len(bodies) > MOST_BODIES or system.configuration.has_forces_built_in:
        return None  # a pendulum's free body without its tension is none
    try:
        panels = [_panel(system, body, notation) for body in bodies]
    except NoValueError:
        return None
    drawn = [p for p in panels if p is not None]
    return side_by_side(drawn, TEXT_WIDTH) if len(drawn) == len(panels) else None


def supported_rod_scene(
    system: SystemPicture, normals: Mapping[str, Vector], sizes: Mapping[str, sp.Symbol], notation: Notation
) -> Scene | None:
    """A rod with its loads and the normal forces at its supports; None if it cannot be drawn."""
    sketch, page = Sketch(), system.page
    try:
        places = {p.name: system.pose.at(p.position) for p in system.configuration.points}
        start, end = farthest([page(at) for at in places.values()])
        sketch.line([start, end], StrokeKind.ROD)
        Arrows(system, sketch, places).loads()
        for name, normal in normals.items():
            at, way = page(places[name]), toward((0, 0), page.way(system.pose.at(normal)))
            sketch.arrow(at, beyond(at, way, LENGTH), StrokeKind.REACTION)
            sketch.label(sizes[name], beyond(at, way, LENGTH), way)
    except NoValueError:
        return None
    for name, place in places.items():
        sketch.dot(page(place))
        sketch.label(as_words(name), page(place), (0.0, -1.0), clear=PARTICLE)
    return sketch.scene(notation)


def _panel(system: SystemPicture, body: FreeBody, notation: Notation) -> Scene | None:
    acting = acting_on(system, body)
    if not acting:
        raise NoValueError("nothing acts on it")
    sketch = Sketch()
    rotation = plane_rotation(system.configuration, body.name)
    turning = any(r.name == body.name for r in system.configuration.rotations)
    crowded = _crowded(system, acting)
    radius = PARTICLE
    wheel = _wheel(system, body)
    scale = min(system.page.scale, LARGEST_WHEEL / wheel) if wheel else system.page.scale
    outline = [] if wheel and system.view.planar else _declared(system, body)
    if outline and not wheel:
        scale = min(scale, LARGEST / max(math.hypot(*p) for p in outline))
    if outline:
        sketch.face([(x * scale, y * scale) for x, y in outline], 2)
    elif rotation is not None and system.view.planar:
        _outline(sketch, system, body, rotation, wheel, scale)
    elif turning:
        sketch.ellipse((0.0, 0.0), (0.5, 0.12), (-0.1, 0.34))
    elif crowded:
        radius = 0.3
        sketch.ellipse((0.0, 0.0), (radius, 0.0), (0.0, radius))
    if not crowded or turning:
        sketch.dot((0.0, 0.0), PARTICLE)
    used: list[tuple[PagePoint, PagePoint]] = []
    for a in acting:
        _arrow(sketch, system, a, radius if crowded and not turning else 0.0, used, scale)
    x, y = -sum(w[0] for _, w in used), -sum(w[1] for _, w in used)
    prefer = toward((0, 0), (x, y)) if math.hypot(x, y) > 0.3 else (0.8, 0.5)
    sketch.label(as_words(body.name), (0.0, 0.0), prefer, clear=radius)
    return sketch.scene(notation)


def _ways(system: SystemPicture, acting: Sequence[Acting]) -> list[PagePoint]:
    return [toward((0, 0), system.page.way(a.vector)) for a in acting if not a.is_moment]


def _crowded(system: SystemPicture, acting: Sequence[Acting]) -> bool:
    """Whether two forces have nearly the same direction."""
    ways = _ways(system, acting)
    return any(a[0] * b[0] + a[1] * b[1] > _NEAR for n, a in enumerate(ways) for b in ways[:n])


def _arrow(
    sketch: Sketch,
    system: SystemPicture,
    a: Acting,
    edge: float,
    used: list[tuple[PagePoint, PagePoint]],
    scale: float,
) -> None:
    x, y = system.page.way(a.offset)
    start = (x * scale, y * scale)
    on_page = system.page.way(a.vector)
    kind = a.kind
    if a.is_moment and system.view.planar:
        normal = _out_of_page(system, a)
        radius = 0.5 + 0.22 * sum(line.tip and len(line.points) > 2 for line in sketch.lines)
        middle = sketch.turning((0.0, 0.0), radius, normal > 0, kind)
        sketch.label(a.label, middle, toward((0, 0), middle))
        return
    if math.hypot(*on_page) < 0.12 * math.hypot(*a.vector):
        raise NoValueError("it points at the reader")
    way = toward((0, 0), on_page)
    same = [u for u in used if apart(u[0], start) < 0.3 and u[1][0] * way[0] + u[1][1] * way[1] > _NEAR]
    used.append((start, way))
    if same:
        # To the right, to the left, further to the right, ...
        shift = 0.19 * (1 if len(same) % 2 else -1) * ((len(same) + 1) // 2) * 2
        start = beyond(start, left_of(way), shift)
    start = beyond(start, way, math.sqrt(max(edge**2 - (0.38 * len(same)) ** 2, 0)) if edge else 0.0)
    end = beyond(start, way, LENGTH)
    sketch.arrow(start, end, kind, double=a.is_moment)
    sketch.label(a.label, end, way)


def _out_of_page(system: SystemPicture, a: Acting) -> float:
    """The component of a moment out of the page: positive if it turns counterclockwise there."""
    first, second = (n for n in range(3) if system.view.units[n] != (0.0, 0.0))
    u, v = system.view.units[first], system.view.units[second]
    orientation = u[0] * v[1] - u[1] * v[0]  # −1 where the axes of the file make a left-handed page
    third = ({0, 1, 2} - {first, second}).pop()
    sign = -1 if third == 1 else 1  # i × k = −j
    return a.vector[third] * sign * orientation


def _wheel(system: SystemPicture, body: FreeBody) -> float:
    """The radius of a round body, in the units of the problem; 0 for any other."""
    shape = system.problem.figure.shapes.get(body.name)
    if shape is not None and shape.kind in (Outline.DISC, Outline.RING, Outline.SPHERE):
        return abs(system.number(shape.lengths[0]))
    known = system.shapes.get(body.name)
    return known.radius if known else 0.0


def _declared(system: SystemPicture, body: FreeBody) -> list[PagePoint]:
    """The outline of a body whose shape the file gives, about its mass centre, in the units of the problem."""
    shape = system.problem.figure.shapes.get(body.name)
    if shape is None or shape.kind in (Outline.ROD, Outline.CONE):
        return []
    lengths = [abs(system.number(x)) for x in shape.lengths]
    turning = next((r for r in system.configuration.rotations if r.name == body.name), None)
    e1, e2, e3 = (
        system.pose.at(a) for a in (turning.axes if turning is not None else (unit_vector(FIXED, n) for n in range(3)))
    )
    if shape.axis is not None:
        e3 = unit(system.at(shape.axis))
        e1, e2 = (e3, outer((0.0, 0.0, 1.0), e3)) if shape.kind is Outline.BOX else across(e3)
    origin: FloatVector = (0.0, 0.0, 0.0)
    if shape.kind is Outline.BOX:
        half = [x / 2 for x in lengths]
        corners = ((1, 1), (-1, 1), (-1, -1), (1, -1))
        return [system.page.way(plus(plus(origin, e1, a * half[0]), e2, b * half[1])) for a, b in corners]
    if shape.kind is Outline.SPHERE:
        return [(lengths[0] * math.cos(s), lengths[0] * math.sin(s)) for s in TURN]
    if shape.axis is None and turning is not None:
        e3 = (e1, e2, e3)[turning.inertia.symmetry_axis]
    u, v = (e1, e2) if system.view.planar else across(e3)
    return [system.page.way(plus(plus(origin, u, lengths[0] * math.cos(s)), v, lengths[0] * math.sin(s))) for s in TURN]


def _outline(
    sketch: Sketch, system: SystemPicture, body: FreeBody, rotation: Rotation, wheel: float, scale: float
) -> None:
    known = system.shapes[body.name]

    def flat(point: tuple[float, float]) -> PagePoint:
        x, y = system.page.way(in_space(system.pose, rotation, point))
        return x * scale, y * scale

    held = [flat(h) for h in known.held]
    centre = system.pose.at(body.particle.position)
    shape = system.problem.figure.shapes.get(body.name)
    for declared in shape.ends if shape is not None and shape.kind is Outline.ROD else ():
        x, y = system.page.way(minus(system.at(declared), centre))
        held.append((x * scale, y * scale))
    for joint in system.joints.get(body.name, ()):
        x, y = system.page.way(minus(joint, centre))
        held.append((x * scale, y * scale))
    e1 = toward((0, 0), system.page.way(system.pose.at(rotation.axes[0])))
    if wheel:
        sketch.circle((0.0, 0.0), wheel * scale, 2)
    elif held:
        far = max(held, key=lambda h: math.hypot(*h))
        pairs = [(a, b) for a in (*held, (0.0, 0.0)) for b in (*held, (0.0, 0.0))]
        start, end = max(pairs, key=lambda p: apart(*p))
        side = left_of(toward((0, 0), far))
        if all(abs(h[0] * side[0] + h[1] * side[1]) < 0.06 for h in held):
            sketch.capsule(start, end, BAR)
        elif is_bar(system, body.name):  # bent
            for h in held:
                sketch.capsule((0.0, 0.0), h, BAR)
        else:
            reach = max(math.hypot(*h) for h in held) + 0.18
            way = toward((0, 0), far)
            sketch.ellipse((0.0, 0.0), (way[0] * reach, way[1] * reach), (side[0] * 0.6 * reach, side[1] * 0.6 * reach))
    else:
        sketch.ellipse((0.0, 0.0), (e1[0] * 0.62, e1[1] * 0.62), (-e1[1] * 0.36, e1[0] * 0.36))
