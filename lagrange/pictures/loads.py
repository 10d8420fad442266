"""The forces and moments on one particle or body, as arrows with labels, and the curve on which a constraint keeps it.

The arrows on a free body must add up to its applied force; if one would be missing, there is no picture. `Arrows` draws
the applied forces, the blows of an impact and gravity into a picture of the system.

The curve f(a, b) = 0 of a particle with the coordinates a, b has the direction (−∂f/∂b, ∂f/∂a). It is traced from the
particle in small steps, each brought back onto the curve by Newton's iteration, until it leaves the picture or closes.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import pairwise

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, VectorSymbol, t
from lagrange.core.vectors import Vector
from lagrange.document.scene import Box, PagePoint, StrokeKind
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.kinematics import Load
from lagrange.mechanics.constraints.springs_dampers import DamperForce, StretchedSpring
from lagrange.mechanics.dynamics.newton import FreeBody
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, plus, projected, unit, value
from lagrange.pictures.limits import CURVE_STEP, LONGEST_FORCE_LABEL, MOST_CURVE_STEPS
from lagrange.pictures.poses import Pose
from lagrange.pictures.shapes import force_and_moment, plane_rotation, reaction_point
from lagrange.pictures.sketch import Sketch, beyond, crossing, lies_on, scaled, toward
from lagrange.pictures.solids import across
from lagrange.pictures.systems import SystemPicture, ends_of, with_other_values
from lagrange.problem.keys import Outline
from lagrange.problem.model import AppliedForce, Friction


def constraint_curve(
    pose: Pose,
    row: Row,
    position: Vector,
    on_page: Callable[[FloatVector], PagePoint],
    frame: Box,
    but: Sequence[sp.Symbol] = (),
) -> tuple[list[PagePoint], bool] | None:
    """The curve on the page and whether it is closed; None if the constraint is not on one particle in a plane.

    but  coordinates that keep their values
    """
    if row.finite is None:
        return None
    moving = set(pose.coordinates) - {*but}
    f = sp.sympify(row.finite, strict=True)
    placed = set().union(*(c.free_symbols for c in position.fixed().components)) - {*but}
    own = [q for q in pose.coordinates if q in placed]
    if len(own) != 2 or not (f.free_symbols & moving) <= set(own):
        return None
    slopes = [f.diff(q) for q in own]
    try:
        forward, closed = _traced(pose, f, slopes, own, position, on_page, frame, 1)
        if closed:
            return forward, True
        backward, _ = _traced(pose, f, slopes, own, position, on_page, frame, -1)
    except NoValueError:
        return None
    return [*reversed(backward[1:]), *forward], False


def _traced(
    pose: Pose,
    f: sp.Expr,
    slopes: Sequence[sp.Expr],
    own: Sequence[sp.Symbol],
    position: Vector,
    on_page: Callable[[FloatVector], PagePoint],
    frame: Box,
    sense: int,
) -> tuple[list[PagePoint], bool]:
    """The points of the curve in one sense from the particle, which is the first, and whether it closes."""
    fixed = position.fixed()
    partials = [fixed.map(lambda c, q=q: c.diff(q)) for q in own]  # type: ignore[misc]
    reached = pose
    points = [on_page(pose.at(fixed))]
    origin = on_page((0.0, 0.0, 0.0))
    for number in range(MOST_CURVE_STEPS):
        a, b = (value(e, reached.values) for e in slopes)
        way = (-b * sense, a * sense)
        moved = [on_page(reached.at(p)) for p in partials]
        # Centimetres on the page for one unit of `way`: steps have the same length there, whatever the coordinates are.
        speed = math.hypot(*(sum(w * (m[n] - origin[n]) for w, m in zip(way, moved, strict=True)) for n in (0, 1)))
        if speed < 1e-9:
            raise NoValueError("the curve has no direction")
        step = {q: reached.values[q] + CURVE_STEP / speed * w for q, w in zip(own, way, strict=True)}
        reached = Pose(pose.configuration, projected([f], [slopes], own, dict(reached.values) | step))
        points.append(on_page(reached.at(fixed)))
        x, y = points[-1]
        if not (frame.left <= x <= frame.right and frame.bottom <= y <= frame.top):
            return points[:-1], False
        if number > 5 and math.hypot(x - points[0][0], y - points[0][1]) < CURVE_STEP * 0.9:
            return points, True
    raise NoValueError("the curve does not end")


NOWHERE: FloatVector = (0.0, 0.0, 0.0)
_SOMEWHERE = ((0.83, 0.56, 0.0), (0.7, 0.4, 0.6))
"""The direction in which a force given by undefined functions is drawn: in the plane, in space."""


@record
class Acting:
    """A force or moment.

    vector     its direction
    offset     from the particle or mass centre to the point where it acts
    """

    on: str
    label: sp.Expr | str
    vector: FloatVector
    kind: StrokeKind
    offset: FloatVector = NOWHERE
    is_moment: bool = False


def loads_on(system: SystemPicture, name: str) -> list[Acting]:
    """The named applied forces and moments on a particle or body. Raises NoValueError."""
    return [*_loads(system, name), *_pulls(system, name), *_torques(system, name)]


def acting_on(system: SystemPicture, body: FreeBody) -> list[Acting]:
    """All forces and moments on a free body. Raises NoValueError, also if one could not be drawn."""
    acting = loads_on(system, body.name)
    acting += _rest(system, body)
    acting += _friction_at_rest(system, body.name)
    for reaction in body.bound:
        acting += _reaction(system, body, reaction.name)
    return acting


def given_loads(system: SystemPicture, name: str) -> list[Acting]:
    """The applied forces on a particle or body, without springs and dampers. Raises NoValueError."""
    return [*_loads(system, name)]


def _posed(system: SystemPicture, *vectors: Vector) -> Pose:
    return with_other_values(system.pose, [c for v in vectors for c in v.fixed().components])


def _loads(system: SystemPicture, name: str) -> Iterator[Acting]:
    centre = next(p.position for p in system.configuration.points if p.name == name)
    rough = [f.name for f in system.problem.forces if isinstance(f, Friction)]
    for load in system.configuration.loads:
        if load.on != name:
            continue
        if any(c.has(Unspecified) for c in load.vector.components):
            alone = sum(other.on == name for other in system.configuration.loads) == 1
            label = named_force(name if alone else load.name)
            yield Acting(name, label, _SOMEWHERE[not system.view.planar], StrokeKind.FORCE)
            continue
        pose = _posed(system, load.vector, load.point - centre)
        vector = pose.at(load.vector)
        if math.hypot(*vector) > 1e-9:
            where = minus(pose.at(load.point), pose.at(centre))
            yield Acting(name, force_label(load, rough[0] if len(rough) == 1 else ""), vector, StrokeKind.FORCE, where)


def force_label(load: Load, only_friction: str) -> sp.Expr | str:
    """The magnitude of a load if that is short; otherwise the vector F with its name, or what it is where there is no
    other friction. A force P along a unit vector is drawn for P > 0.
    """
    parts = [c for c in load.vector.components if c != 0]
    if len(parts) == 1:
        size = -parts[0] if parts[0].could_extract_minus_sign() else parts[0]
    else:
        size = sp.sqrt(textbook_form(load.vector.dot(load.vector)))
    unsigned = {a: a.args[0] for a in size.atoms(sp.Abs) if a.args[0].is_Symbol}
    size = size.xreplace(unsigned)
    turns = any(not f.args[0].has(t) for f in size.atoms(sp.cos, sp.sin))
    if count_operations(size) <= LONGEST_FORCE_LABEL and not turns and not size.has(sp.Abs):
        return size
    return "friction" if load.name == only_friction else named_force(load.name)


def named_force(name: str) -> sp.Expr:
    """The vector F with the name of a force as its index."""
    return VectorSymbol(f"F_{name}")


def without_velocities(vector: Vector, system: SystemPicture) -> Vector:
    """What is left of a force or moment at rest: of that of a motor and its resistance, that of the motor."""
    slots = system.configuration.slots
    return vector.fixed().map(lambda c: c.xreplace(dict.fromkeys(slots.velocities, sp.S.Zero)))


def _pulls(system: SystemPicture, name: str) -> Iterator[Acting]:
    configuration = system.configuration
    for link in configuration.links:
        for own, sign in zip(link.ends, (-1, 1), strict=True):
            if own == name:
                first, second = ends_of(link, configuration, system.pose)
                away = minus(first, second)
                pull = _pull(link, system.pose)
                label = pull if count_operations(pull) <= LONGEST_FORCE_LABEL else named_force(link.name)
                yield Acting(name, label, (sign * away[0], sign * away[1], sign * away[2]), StrokeKind.FORCE)
            elif not isinstance(own, str) and _moves(system, own):
                raise NoValueError("a spring fastened next to a particle")


def _pull(link: StretchedSpring | DamperForce, pose: Pose) -> sp.Expr:
    """The force with which it pulls its ends together; on a line the distance may have the other sign."""
    if isinstance(link, DamperForce) and pose.number(link.distance) < 0:
        return link.pull_at(sp.expand(-link.rate))
    return link.pull


def _moves(system: SystemPicture, end: Vector) -> bool:
    moving = set(system.configuration.slots.coordinates)
    return any(c.free_symbols & moving for c in end.fixed().components)


def _torques(system: SystemPicture, name: str) -> Iterator[Acting]:
    for torque in system.configuration.torques:
        if torque.on == name:
            vector = _posed(system, torque.vector).at(torque.vector)
            parts = [c for c in torque.vector.components if c != 0]
            size = parts[0] if len(parts) == 1 else None
            short = size is not None and count_operations(size) <= LONGEST_FORCE_LABEL
            label: sp.Expr | str = size if short and size is not None else as_words(torque.name)
            if short and size is not None and size.could_extract_minus_sign():
                label = -size
            yield Acting(name, label, vector, StrokeKind.FORCE, is_moment=True)


def _rest(system: SystemPicture, body: FreeBody) -> list[Acting]:
    """The part of the applied force without a name of its own: friction, or one force field."""
    names = {f.name for f in system.configuration.loads if f.on == body.name}
    others = [n for n in body.loads if n and n not in names]
    springs = (s.energy for s in system.configuration.springs)
    field = sp.expand(system.configuration.potential - sp.Add(*springs)) != 0
    if not others and not field:
        return []
    if system.configuration.is_outright:
        raise NoValueError("a Lagrangian is given, and no force")
    if len(others) + field != 1:
        raise NoValueError("several forces that cannot be distinguished")
    vector = body.applied
    for load in system.configuration.loads:
        if load.on == body.name:
            vector = vector - load.vector
    if any(c.has(Unspecified) for c in vector.fixed().components):
        raise NoValueError("a force without a direction")
    if any(body.name in link.ends for link in system.configuration.links):
        raise NoValueError("a field as well as a spring")
    direction = _posed(system, vector).at(vector)
    if math.hypot(*direction) < 1e-9:
        return []
    if others:
        return [Acting(body.name, friction_label(system, others[0]), direction, StrokeKind.FORCE)]
    return [*_of_field(system, body.name, vector)]


def _of_field(system: SystemPicture, name: str, vector: Vector) -> Iterator[Acting]:
    """The force −∇V, or those of the springs that V is made of, each with its magnitude where that is short."""
    components = vector.fixed().components
    axes = [n for n, c in enumerate(components) if c != 0]
    alone = not any(load.on == name for load in system.configuration.loads)
    if len(axes) > 1:
        size = sp.sqrt(textbook_form(vector.dot(vector)))
        label = size if _is_short(size) else named_force(name) if alone else "−∇V"
        yield Acting(name, label, _posed(system, vector).at(vector), StrokeKind.FORCE)
        return
    terms = _by_parameter(sp.expand(components[axes[0]]), system)
    pose = _posed(system, vector)
    beside = replace(pose, values=dict(pose.values) | {q: pose.values[q] + 0.3 for q in pose.coordinates})
    for stiffness, stretch in terms:
        here = next((x for x in (pose, beside) if abs(x.number(stretch)) > 1e-9), None)
        if here is None:
            continue
        value_ = here.number(stiffness * stretch)
        size = stiffness * sp.expand(-stretch if value_ < 0 else stretch)
        label = size if _is_short(size) else named_force(name) if alone and len(terms) == 1 else "−∇V"
        way = tuple(math.copysign(1.0, value_) if n == axes[0] else 0.0 for n in range(3))
        yield Acting(name, label, way, StrokeKind.FORCE)  # type: ignore[arg-type]


def _by_parameter(whole: sp.Expr, system: SystemPicture) -> list[tuple[sp.Expr, sp.Expr]]:
    """A force as those of springs, each of which is its stiffness times a stretch: c x and c_1 (x - y)."""
    parameters = [p.symbol for p in system.problem.parameters if whole.has(p.symbol)]
    terms = [(k, whole.coeff(k)) for k in parameters if not whole.coeff(k).free_symbols & {*parameters}]
    terms = [(k, rest) for k, rest in terms if rest != 0]
    return terms if terms and sp.expand(whole - sp.Add(*(k * c for k, c in terms))) == 0 else [(sp.S.One, whole)]


def _is_short(size: sp.Expr) -> bool:
    return bool(count_operations(size) <= LONGEST_FORCE_LABEL and not size.has(sp.cos, sp.sin, sp.exp, sp.Abs))


def friction_label(system: SystemPicture, name: str) -> sp.Expr | str:
    """μ N where one force N presses, μ |N| where that may have either sign; otherwise the word."""
    rough = next((f for f in system.problem.forces if isinstance(f, Friction) and f.name == name), None)
    pressing = {r.name: r for r in system.newton.reactions}
    reaction = None if rough is None or len(rough.constraints) != 1 else pressing.get(rough.constraint)
    if rough is None or reaction is None or not rough.coefficient.is_Symbol:
        return "friction"
    size = reaction.force if reaction.constraint.side is not None else sp.Abs(reaction.force)
    return rough.coefficient * size


def _friction_at_rest(system: SystemPicture, name: str) -> Iterator[Acting]:
    """The components of friction at rest on a body, each in the direction in which it is positive."""
    centre = next(p.position for p in system.configuration.points if p.name == name)
    for contact in system.contacts:
        sign = 1 if contact.friction.on == name else -1 if contact.opposite == name else 0
        if not sign:
            continue
        offset = minus(system.at(contact.place), system.at(centre))
        for force, tangent in zip(contact.components, contact.tangents, strict=True):
            yield Acting(name, force, system.at(tangent * sp.Integer(sign)), StrokeKind.REACTION, offset)


def _touching(system: SystemPicture, name: str, reaction: str) -> FloatVector | None:
    """From the mass centre of a body to the point at which a rough contact presses, if it is one."""
    centre = next(p.position for p in system.configuration.points if p.name == name)
    places = (c.place for c in system.contacts if c.reaction.name == reaction and name in (c.friction.on, c.opposite))
    place = next(places, None)
    return None if place is None else minus(system.at(place), system.at(centre))


def _reaction(system: SystemPicture, body: FreeBody, name: str) -> Iterator[Acting]:
    reaction = next(r for r in body.bound if r.name == name)
    force, moment = reaction.per_unit(body.name), reaction.moment_per_unit(body.name)
    pose = _posed(system, *(v for v in (force, moment) if v is not None))
    if reaction.rod is not None and reaction.tension is not None:
        span = unit(pose.at(reaction.rod.span))
        sign = -1.0 if body.name == reaction.rod.ends[0] else 1.0
        yield Acting(body.name, reaction.tension, (sign * span[0], sign * span[1], sign * span[2]), StrokeKind.REACTION)
        return
    push, turn = force_and_moment(pose, reaction, body.name)
    rotation = plane_rotation(system.configuration, body.name)
    if rotation is not None and math.hypot(*push) > 1e-9:
        where = _touching(system, body.name, name)
        if where is None:
            where = reaction_point(pose, rotation, reaction, system.shapes[body.name])
        yield Acting(body.name, _times_size(reaction.force, force), push, StrokeKind.REACTION, where or NOWHERE)
        return
    if math.hypot(*push) > 1e-9:
        yield Acting(body.name, _times_size(reaction.force, force), push, StrokeKind.REACTION)
    if math.hypot(*turn) > 1e-9:
        yield Acting(body.name, _times_size(reaction.force, moment), turn, StrokeKind.REACTION, is_moment=True)


def _times_size(unknown: sp.Symbol, direction: Vector | None) -> sp.Expr:
    """λ|∇f| if that is short; λ otherwise."""
    assert direction is not None
    size = sp.sqrt(textbook_form(direction.dot(direction)))
    return unknown * size if size.is_Symbol or size.is_Integer else unknown


_NUMBERED = re.compile(r"([A-Z])(\d+)")
_LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def as_words(name: str) -> str:
    """A name from a problem file as it is written in a picture: P₁, the lying part."""
    numbered = _NUMBERED.fullmatch(name)
    if numbered:
        return numbered[1] + numbered[2].translate(_LOWERED)
    return name.replace("_", " ").replace(".", " ")


# -- The arrows in a picture of a system: applied forces, the blows of an impact, and gravity beside it ----------------


ARROW = 1.15
"""Length of the arrows of unit vectors and loads, in centimetres."""
MOMENT = 0.85
TURN_OF_MOMENT = 1.9
"""Radius of the arrow of a moment, in centimetres, outside of the arcs of angles; and how far it turns."""
_SOLID = (Outline.BOX, Outline.DISC, Outline.SPHERE)


class Arrows:
    """Draws arrows into a sketch; `places` are those of particles and mass centres."""

    def __init__(self, system: SystemPicture, sketch: Sketch, places: Mapping[str, FloatVector]) -> None:
        self.system = system
        self.sketch = sketch
        self.places = places
        self.pose = system.pose
        self.page = system.page

    def flat(self, place: FloatVector) -> PagePoint:
        """A place on the page."""
        return self.page(place)

    def loads(self) -> None:
        """The applied forces."""
        for name in self.places:
            for acting in given_loads(self.system, name):
                self.load(acting)

    def given(self) -> None:
        """The forces that the file gives by their letters, P or F cos ωt, where free bodies show all forces."""
        named = {f.name for f in self.system.problem.forces if isinstance(f, AppliedForce)}
        drawn = {str(m.label) for m in self.system.marks}
        for load in self.system.configuration.loads:
            vector = without_velocities(load.vector, self.system)
            if load.name not in named or vector.is_zero or vector != load.vector.fixed() or load.on not in self.places:
                continue
            label = force_label(load, "")
            if isinstance(label, sp.Expr) and str(label) not in drawn:
                with suppress(NoValueError):
                    pose = _posed(self.system, load.vector)
                    where = minus(pose.at(load.point), self.places[load.on])
                    self.load(Acting(load.on, label, pose.at(load.vector), StrokeKind.FORCE, where))

    def moments(self) -> None:
        """The applied moments that have a letter, as arrows around their bodies."""
        drawn = {str(m.label) for m in self.system.marks}
        for torque in self.system.configuration.torques:
            vector = without_velocities(torque.vector, self.system)
            parts = [c for c in vector.components if c != 0]
            if len(parts) != 1 or count_operations(parts[0]) > LONGEST_FORCE_LABEL or torque.on not in self.places:
                continue
            label = -parts[0] if parts[0].could_extract_minus_sign() else parts[0]
            if str(label) not in drawn and not label.has(sp.sin, sp.cos):
                drawn.add(str(label))  # of an internal moment only one of the two
                with suppress(NoValueError):
                    self.moment(label, _posed(self.system, vector).at(vector), self.places[torque.on])

    def moment(self, label: sp.Expr, vector: FloatVector, at: FloatVector) -> None:
        """One of them: an arc where it crosses least in the plane, an ellipse around the axis in space."""
        middle = self.flat(at)
        if self.system.view.planar:
            sense = math.copysign(1.0, inner(vector, self.system.view.toward_reader))
            arcs = (self._arc(middle, math.pi * n / 6, sense) for n in range(12))
            arc = min(arcs, key=lambda points: sum(map(self._crossed, pairwise(points))))
            self.sketch.arc(arc, StrokeKind.FORCE)
            self.sketch.label(label, arc[12], toward(middle, arc[12]), optional=True)
            return
        u, v = across(unit(vector))
        along = toward((0.0, 0.0), self.page.way(vector))
        ways = [beyond(scaled(self.page.way(u), math.cos(s)), self.page.way(v), math.sin(s)) for s in
                (math.pi * (-0.8 + 1.6 * k / 24) for k in range(25))]  # fmt: skip
        free = [d for d in (0.6, -0.6, 0.9, -0.9, 1.2, -1.2, 0.0) if self.is_on_line(beyond(middle, along, d))]
        centre = beyond(middle, along, (free or [0.6])[0])
        arc = [beyond(centre, w, 0.42) for w in ways]
        self.sketch.arc(arc, StrokeKind.FORCE)
        self.sketch.label(label, arc[12], toward(centre, arc[12]), optional=True)

    def _arc(self, middle: PagePoint, start: float, sense: float) -> list[PagePoint]:
        turns = (start + sense * TURN_OF_MOMENT * k / 24 for k in range(25))
        return [beyond(middle, (math.cos(a), math.sin(a)), MOMENT) for a in turns]

    def _crossed(self, piece: tuple[PagePoint, PagePoint]) -> int:
        lines = (*self.sketch.lines, *(face for _, face in self.sketch.filled))
        return sum(crossing(piece, other) is not None for line in lines for other in line.pieces)

    def is_on_line(self, at: PagePoint) -> bool:
        """Whether a straight line is drawn through a place."""
        lines = (line for line in self.sketch.lines if line.kind in (StrokeKind.ROD, StrokeKind.BODY))
        return any(lies_on(at, *piece) for line in lines for piece in line.pieces)

    def load(self, acting: Acting) -> None:
        """One of them; moments are drawn apart."""
        if acting.is_moment:
            return
        start = self.flat(plus(self.places[acting.on], acting.offset))
        way = toward((0.0, 0.0), self.page.way(acting.vector))
        end = beyond(start, way, ARROW)
        if self.pushes(acting):
            start, end = beyond(start, way, -ARROW), start
            self.sketch.arrow(start, end, StrokeKind.FORCE)
            self.sketch.label(acting.label, start, scaled(way, -1.0))
            return
        self.sketch.arrow(start, end, StrokeKind.FORCE)
        self.sketch.label(acting.label, end, way)

    def pushes(self, acting: Acting) -> bool:
        """Whether a force acts on the outline of a box or a round body and points into it."""
        shape = self.system.problem.figure.shapes.get(acting.on)
        if shape is None or shape.kind not in _SOLID or not self.system.view.planar:
            return False
        inside = self.page.way(minus(NOWHERE, acting.offset))
        way = self.page.way(acting.vector)
        into = inner(way, inside) / math.hypot(*way)
        if shape.kind is Outline.BOX:
            turning = next((r for r in self.system.configuration.rotations if r.name == acting.on), None)
            axes = [self.pose.at(a) for a in turning.axes[:2]] if turning is not None else [(1.0, 0, 0), (0, 1.0, 0)]
            sides = [
                abs(inner(unit(acting.vector), a) * self.system.number(x))
                for a, x in zip(axes, shape.lengths, strict=True)
            ]
            return into > 0.95 * sum(sides) / 2
        return into > 0.2 * math.hypot(*inside)

    def impulses(self) -> None:
        """The blows of an impact, each as an arrow that ends where it strikes."""
        impact = self.system.problem.impact
        drawn = {str(m.label) for m in self.system.marks}
        for blow in impact.impulses if impact is not None else ():
            if not isinstance(blow, AppliedForce):
                continue
            with suppress(NoValueError):
                size = sp.sqrt(textbook_form(blow.vector.dot(blow.vector)))
                if str(size) in drawn:
                    continue
                pose = with_other_values(self.pose, blow.vector.fixed().components)
                way = toward((0.0, 0.0), self.page.way(pose.at(blow.vector)))
                at = self.places[blow.on] if blow.at is None else self.system.at(blow.at)
                start = beyond(self.flat(at), way, -ARROW)
                self.sketch.arrow(start, self.flat(at), StrokeKind.FORCE)
                self.sketch.label(size if size.is_Symbol else as_words(blow.name), start, scaled(way, -1.0))

    def gravity(self) -> None:
        """An arrow in the direction of gravity, to the right of the picture."""
        field = self.system.problem.gravity
        if field is None or field.is_zero:
            return
        way = self.page.way(self.pose.at(field))
        size = sp.sqrt(textbook_form(field.dot(field)))
        if math.hypot(*way) < 1e-9 or not size.is_Symbol:
            return
        way = toward((0, 0), way)
        corners = [p for line in self.sketch.lines for p in line.points] + [d.at for d in self.sketch.dots]
        corners += [p for _, face in self.sketch.filled for p in face.points]
        box = Box.around(corners)
        x = box.right + 0.75
        start = (x, (box.top + box.bottom) / 2 - way[1] * 0.45)
        end = beyond(start, way, 0.9)
        self.sketch.arrow(start, end, StrokeKind.AXIS)
        self.sketch.label_beside(size, start, end)
