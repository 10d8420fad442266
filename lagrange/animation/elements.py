"""The figure of a system as functions of its state: what is drawn, and between which places.

The picture on paper is drawn once, in one position (`pictures`). Here each of its parts is an element, a small record
of what it is (a rod, a spring, a disc, the arc of an angle) and of the places that it needs; places, lengths and
directions are expressions, the *cells*, whose values the page computes for every state. What there is to draw, and what
a coordinate measures, is recognised in the position of the picture, as there.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import combinations, pairwise
from typing import Any

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import UnitVector, t
from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.pictures.floats import FloatVector, NoValueError, plus
from lagrange.pictures.limits import LONGEST_ROD_LABEL
from lagrange.pictures.loads import as_words
from lagrange.pictures.poses import Pose, angle_mark, distance_marks, relative_angle_mark, stands_still
from lagrange.pictures.shapes import has_one_direction, plane_rotation, push_sense
from lagrange.pictures.sketch import apart, farthest, in_line, overlapping, same_ends, touches, toward
from lagrange.pictures.systems import SystemPicture
from lagrange.problem.model import BodyShape, Drawn, FigureLine, Keeper, Outline

DrawnElement = dict[str, Any]
_STROKES = {
    Drawn.RODS: "rod",
    Drawn.LINES: "reference",
    Drawn.OUTLINES: "body",
    Drawn.CURVE: "curve",
    Drawn.GROUND: "ground",
}
_PARTS = tuple(sp.Rational(*r) for r in ((1, 1), (1, 2), (2, 1), (1, 3), (2, 3), (1, 4), (3, 4)))


@dataclass
class Cells:
    """Expressions that the page evaluates, each once; a vector takes three in a row."""

    expressions: list[sp.Expr] = field(default_factory=list)
    places: dict[object, int] = field(default_factory=dict)

    def scalar(self, e: sp.Expr) -> int:
        """The number of the cell of an expression."""
        if e not in self.places:
            self.places[e] = len(self.expressions)
            self.expressions.append(sp.sympify(e, strict=True))
        return self.places[e]

    def vector(self, v: Vector) -> int:
        """The number of the first of the cells of a vector's components along i, j, k."""
        parts = v.fixed().components
        if parts not in self.places:
            self.places[parts] = len(self.expressions)
            self.expressions += [sp.sympify(c, strict=True) for c in parts]
        return self.places[parts]


@dataclass
class Elements:
    """Collects the elements of one figure.

    system  the system in the coordinates of the file
    chosen  the coordinates that the page changes, with the same position in them
    curves  points of curves and surfaces with the symbols along them
    traced  f, the two coordinates and the position of points that a constraint f = 0 keeps on a curve
    labels  what is written
    busy    pieces along which a line is drawn in the position of the picture
    boxed   what is drawn as a block
    """

    system: SystemPicture
    chosen: Pose | None
    cells: Cells = field(default_factory=Cells)
    items: list[DrawnElement] = field(default_factory=list)
    curves: list[tuple[Vector, tuple[sp.Symbol, ...]]] = field(default_factory=list)
    traced: list[tuple[sp.Expr, tuple[sp.Symbol, ...], Vector]] = field(default_factory=list)
    labels: list[sp.Expr | str] = field(default_factory=list)
    busy: list[tuple[PagePoint, PagePoint]] = field(default_factory=list)
    boxed: set[str] = field(default_factory=set)

    def all(self, inferred: Callable[[Elements], None] = lambda _: None) -> None:
        """Everything, from the back to the front; `inferred` adds what the file only implies."""
        self.declared()
        self.rods()
        inferred(self)
        self.links()
        self.supports()
        self.bodies()
        if "constraints" not in self.hidden:
            self.constraint_curves()
        self.points()
        self.marks()
        self.coordinates()
        field_ = self.system.problem.gravity
        if field_ is not None and "gravity" not in self.hidden and not field_.is_zero:
            self.add("gravity", v=self.cells.vector(field_), l=self.label(sp.Symbol("g")))

    def add(self, kind: str, **what: Any) -> None:
        """An element."""
        self.items.append({"k": kind, **what})

    def label(self, content: sp.Expr | str) -> int:
        """The number of a label."""
        self.labels.append(content)
        return len(self.labels) - 1

    @property
    def hidden(self) -> frozenset[str]:
        """The names of everything that is not drawn."""
        return self.system.hidden

    @property
    def configuration(self) -> Configuration:
        """The system in the coordinates of the file."""
        return self.system.configuration

    def at(self, v: Vector) -> int:
        """The cell of a place."""
        return self.cells.vector(v)

    def flat(self, v: Vector) -> PagePoint:
        """A place in the position of the picture."""
        return self.system.page(self.system.at(v))

    def meeting(self, at: PagePoint) -> PagePoint:
        """The sum of the directions of the lines that meet at a point."""
        ways = [toward(at, b if apart(a, at) < apart(b, at) else a) for a, b in self.busy if touches(at, a, b)]
        return sum(w[0] for w in ways), sum(w[1] for w in ways)

    def take(self, a: Vector, b: Vector) -> None:
        """Remember that a line is drawn between two places."""
        self.busy.append((self.flat(a), self.flat(b)))

    # What the file declares

    def declared(self) -> None:
        """Curves, circles, pulleys and lines of the section `figure`."""
        figure = self.system.problem.figure
        for curve in figure.curves:
            ends = [self.cells.scalar(e) for pair in curve.between for e in pair]
            self.curves.append((curve.point, curve.along))
            kind = "surface" if len(curve.along) == 2 else "curve"
            self.add(kind, f=len(self.curves) - 1, b=ends, c=_STROKES.get(curve.kind, "curve"))
        for circle in (*figure.circles, *figure.pulleys.values()):
            self.round(circle.kind, circle.centre, circle.radius, circle.axis)
        for line in figure.lines:
            self.line(line)

    def surface(self, point: Vector, along: tuple[sp.Symbol, ...], ends: Sequence[sp.Expr]) -> None:
        """A surface in space; `ends`: from where to where each of its two symbols runs."""
        self.curves.append((point, along))
        self.add("surface", f=len(self.curves) - 1, b=[self.cells.scalar(e) for e in ends], c="curve")

    def round(self, kind: Drawn, centre: Vector, radius: sp.Expr, axis: Vector | None) -> None:
        """A disc, ring, sphere, circle or pulley."""
        if axis is None and not self.system.view.planar:
            axis = Vector((sp.S.Zero, sp.S.Zero, sp.S.One))
        p, r = self.at(centre), self.cells.scalar(radius)
        a = -1 if axis is None else self.at(axis)
        match kind:
            case Drawn.SPHERE:
                self.add("sphere", p=p, r=r)
            case Drawn.RING:
                self.add("disc", p=p, r=r, a=a, s=1, c="body")
                self.add("disc", p=p, r=r, a=a, s=1, c="body", f=0.93)
            case Drawn.CURVE:
                self.add("disc", p=p, r=r, a=a, s=0, c="curve")
            case _:
                self.add("disc", p=p, r=r, a=a, s=2, c="body")
                if kind is Drawn.PULLEY:
                    self.add("dot", p=p, r=0.05)

    def line(self, line: FigureLine) -> None:
        """Rods, strings, ground, springs, blades and wheels."""
        places = [p for p in line.places if not isinstance(p, str)]
        ends = [self.at(p) for p in places]
        match line.kind:
            case Drawn.BLADES | Drawn.WHEELS:
                self.add("tool", p=ends[0], a=ends[1], w=0.035 if line.kind is Drawn.BLADES else 0.1)
                return
            case Drawn.STRINGS:
                pulleys = self.system.problem.figure.pulleys
                parts = [
                    [self.at(pulleys[p].centre), self.cells.scalar(pulleys[p].radius)]
                    if isinstance(p, str)
                    else self.at(p)
                    for p in line.places
                ]
                self.add("string", p=parts)
            case Drawn.SPRINGS | Drawn.DAMPERS:
                kind = "spring" if line.kind is Drawn.SPRINGS else "damper"
                self.add(kind, p=[ends[0], ends[-1]], o=0, l=-1)
            case Drawn.OUTLINES:
                self.add("face", p=ends, s=2, c="body")
            case Drawn.SUPPORTS:
                self.support(places[0])
                return
            case _:
                self.add("ground" if line.kind is Drawn.GROUND else "line", p=ends, c=_STROKES.get(line.kind, "rod"))
        for a, b in pairwise(places):
            self.take(a, b)

    # Rods and springs

    def rods(self) -> None:
        """The distances that constraints keep."""
        places = {p.name: p.position for p in self.configuration.points}
        for reaction, rod in self.system.rods:
            if {"constraints", reaction.name} & self.hidden:
                continue
            first = places[rod.ends[0]]
            second = places[rod.ends[1]] if rod.ends[1] else rod.centre
            if second is None:
                continue
            label = self.label(rod.length) if count_operations(rod.length) <= LONGEST_ROD_LABEL else -1
            self.add("line", p=[self.at(second), self.at(first)], c="rod", l=label)
            self.take(first, second)
            if not rod.ends[1]:
                self.mount(second)
        for a, b, by_constraints in self.system.kept_distances:
            if by_constraints:
                self.add("line", p=[self.at(places[a]), self.at(places[b])], c="rod", l=-1)
                self.take(places[a], places[b])

    def mount(self, at: Vector) -> None:
        """A hinge, with a piece of ground where it does not move."""
        self.add("dot", p=self.at(at), r=0.06, o=1)
        moving = {*self.configuration.slots.coordinates, *self.configuration.slots.prescribed, t}
        if not any(c.free_symbols & moving for c in at.fixed().components):
            self.support(at)

    def support(self, at: Vector) -> None:
        """A piece of ground at a point, on the other side than the lines that meet there."""
        place = self.flat(at)
        ways = [
            toward(place, b if apart(a, place) < apart(b, place) else a) for a, b in self.busy if touches(place, a, b)
        ]
        x, y = sum(w[0] for w in ways), sum(w[1] for w in ways)
        field_ = self.system.problem.gravity
        down = (0.0, 0.0) if field_ is None else self.system.page.way(self.system.pose.at(field_))
        if math.hypot(*down) > 1e-6:
            along = toward((0.0, 0.0), down)
            inward = along if x * along[0] + y * along[1] >= -1e-6 else (-along[0], -along[1])
        elif math.hypot(x, y) < 1e-6:
            inward = (0.0, -1.0)
        else:
            inward = (math.copysign(1.0, x), 0.0) if abs(x) > abs(y) else (0.0, math.copysign(1.0, y))
        self.add("wall", p=self.at(at), d=inward)

    def links(self) -> None:
        """Springs and dampers; those between the same points are side by side."""
        places = {p.name: p.position for p in self.configuration.points}
        ends = [[places[e] if isinstance(e, str) else e for e in link.ends] for link in self.configuration.links]
        drawn = [(self.flat(a), self.flat(b)) for a, b in ends]
        for n, link in enumerate(self.configuration.links):
            a, b = ends[n]
            alike = sum(same_ends(drawn[n], other) for other in drawn)
            before = sum(same_ends(drawn[n], other) for other in drawn[:n])
            shift = 0.24 - 0.48 * before if alike > 1 else 0.0
            stiffness = getattr(link, "stiffness", None)
            kind = "damper" if stiffness is None else "spring"
            label = stiffness if stiffness is not None else link.coefficient  # type: ignore[union-attr]
            self.add(kind, p=[self.at(a), self.at(b)], o=shift, l=self.label(label))
            self.busy.append(drawn[n])
            for end, other, named in ((a, b, link.ends[0]), (b, a, link.ends[1])):
                if isinstance(named, str):
                    continue
                if len(self.system.view.shown) == 1:
                    self.add("wall", p=self.at(end), d=toward(self.flat(end), self.flat(other)))
                else:
                    self.mount(end)

    def supports(self) -> None:
        """Open hinges where plane bodies are joined."""
        done: list[FloatVector] = []
        for body, joints in self.system.joints.items():
            rotation = plane_rotation(self.configuration, body)
            point = next(p for p in self.configuration.points if p.name == body)
            for joint in joints:
                if rotation is None or any(math.dist(joint, d) < 1e-6 for d in done):
                    continue
                done.append(joint)
                self.add("dot", p=self.at(self.fixed_in(point, joint)), r=0.06, o=1)

    def fixed_in(self, point: MassPoint, place: FloatVector) -> Vector:
        """The point of a plane body that is at a place in the position of the picture."""
        rotation = plane_rotation(self.configuration, point.name)
        assert rotation is not None
        here = self.system.pose.at(point.position)
        way = [place[n] - here[n] for n in range(3)]
        parts = []
        for axis in rotation.axes[:2]:
            e = self.system.pose.at(axis)
            parts.append(self.fitted(sum(w * c for w, c in zip(way, e, strict=True))))
        at = point.position.fixed()
        for axis, part in zip(rotation.axes[:2], parts, strict=True):
            at = at + axis.fixed() * part
        return at

    def fitted(self, number: float) -> sp.Expr:
        """A length as a simple multiple of one of the problem's, so that it scales with it; otherwise the number."""
        if abs(number) < 1e-9:
            return sp.S.Zero
        for p in self.system.problem.parameters:
            size = self.system.pose.values.get(p.symbol)
            for part in _PARTS if size else ():
                if abs(abs(number) - float(part) * abs(size)) < 1e-7:  # type: ignore[arg-type]
                    return part * p.symbol if number > 0 else -part * p.symbol
        return sp.Float(number)

    # Bodies

    def bodies(self) -> None:
        """Bodies with the shapes that the file gives them, or that their reactions reveal."""
        for p in self.configuration.points:
            shape = self.system.problem.figure.shapes.get(p.name)
            rotation = plane_rotation(self.configuration, p.name)
            if shape is not None:
                self.shaped(p, shape)
            elif p.name in self.hidden or p.name in self.boxed:
                continue
            elif rotation is not None and self.system.view.planar:
                self.plane_body(p)
            else:
                for r in (r for r in self.configuration.rotations if r.name == p.name):
                    called = next(b for b in self.system.problem.bodies if b.name == p.name).axes_called
                    names = called or tuple(f"e_{n}" for n in (1, 2, 3))
                    ways = [self.at(a) for a in r.axes]
                    bare = int(self.system.is_bare and not self.system.view.planar)
                    self.add(
                        "triad", p=self.at(p.position), a=ways, b=bare, l=[self.label(UnitVector(n)) for n in names]
                    )

    def shaped(self, p: MassPoint, shape: BodyShape) -> None:
        """A body whose shape the file gives."""
        turning = next((r for r in self.configuration.rotations if r.name == p.name), None)
        units = [Vector(tuple(sp.Integer(m == n) for m in range(3))) for n in range(3)]
        e1, e2, e3 = (self.at(a) for a in (units if turning is None else turning.axes))
        symmetric = 2 if turning is None else turning.inertia.symmetry_axis
        axis = (e1, e2, e3)[symmetric] if shape.axis is None else self.at(shape.axis)
        c, planar = self.at(p.position), self.system.view.planar
        lengths = [self.cells.scalar(x) for x in shape.lengths]
        match shape.kind:
            case Outline.DISC | Outline.RING:
                filled = 2 if shape.kind is Outline.DISC else 1
                self.add("disc", p=c, r=lengths[0], a=-1 if planar else axis, s=filled, c="body")
                if shape.kind is Outline.RING:
                    self.add("disc", p=c, r=lengths[0], a=-1 if planar else axis, s=1, c="body", f=0.93)
            case Outline.ROD:
                a, b = shape.ends
                self.add("capsule", p=[self.at(a), self.at(b)], w=0.09)
                self.take(a, b)
            case Outline.BOX:
                given = shape.axis is not None
                self.add("box", p=c, a=axis if given else e1, b=e2, w=lengths, x=int(given))
            case Outline.SPHERE:
                self.add("sphere", p=c, r=lengths[0])
            case Outline.CONE:
                self.add("cone", p=c, a=(e2 if planar and shape.axis is None else axis), r=lengths[0], h=lengths[1])
        if turning is not None and shape.kind in (Outline.DISC, Outline.RING, Outline.SPHERE):
            self.add("spoke", p=c, v=e1, r=lengths[0])
        self.add("dot", p=c, r=0.05)
        if plane_rotation(self.configuration, p.name) is not None and planar and "constraints" not in self.hidden:
            self.contacts(p)

    def plane_body(self, p: MassPoint) -> None:
        """A wheel, a rod between the points at which it is held, or an oval."""
        rotation = plane_rotation(self.configuration, p.name)
        assert rotation is not None
        known = self.system.shapes[p.name]
        here = self.system.pose.at(p.position)
        e1, e2 = (self.system.pose.at(a) for a in rotation.axes[:2])
        held = [tuple(here[n] + x * e1[n] + y * e2[n] for n in range(3)) for x, y in known.held]
        held += self.system.joints.get(p.name, [])
        c = self.at(p.position)
        flat = [self.system.page(h) for h in held]  # type: ignore[arg-type]
        if known.radius:
            self.add("disc", p=c, r=self.cells.scalar(self.fitted(known.radius)), a=-1, s=2, c="body")
            self.add("spoke", p=c, v=self.at(rotation.axes[0]), r=self.cells.scalar(self.fitted(known.radius)))
        elif held and in_line(self.system.page(here), flat):
            ends = [here, *held]
            pages = [self.system.page(e) for e in ends]  # type: ignore[arg-type]
            first, last = farthest(pages)
            a, b = (self.fixed_in(p, ends[pages.index(e)]) for e in (first, last))  # type: ignore[arg-type]
            self.add("capsule", p=[self.at(a), self.at(b)], w=0.12)
            self.take(a, b)
        else:
            self.add("oval", p=c, v=self.at(rotation.axes[0]))
        self.add("dot", p=c, r=0.06)
        if "constraints" not in self.hidden:
            self.contacts(p)

    def contacts(self, p: MassPoint) -> None:
        """What a plane body slides or rolls on: a line where its reaction has a constant direction, else a circle."""
        known = self.system.shapes.get(p.name)
        if known is None:
            return
        for reaction in self.system.reactions_on(p.name):
            force, moment = reaction.per_unit(p.name), reaction.moment_per_unit(p.name)
            at = self.acts_at(p, reaction)
            rolls = bool(known.radius) and reaction.name not in known.at
            is_known = rolls or reaction.name in known.at
            if force is None or moment is None or moment.is_zero or at is None or not is_known:
                continue
            together = known.together_with(reaction.name)
            if len(together) > 1 and stands_still(
                self.system.pose, at
            ):  # a hinge, and not a floor and a wall through it
                if reaction.name == together[0]:
                    self.add("dot", p=self.at(at), r=0.06, o=1)
                    self.support(at)
            elif has_one_direction(self.system.pose, reaction, p.name):
                self.add("rest", p=self.at(at), v=self.at(force), c=self.at(p.position), x=int(rolls))
            elif rolls:
                self.track(p, at)

    def acts_at(self, p: MassPoint, reaction: Reaction) -> Vector | None:
        """The point of a body at which a reaction acts: where it is held, otherwise that nearest to its centre."""
        force, moment = reaction.on(p.name), reaction.moments.get(p.name)
        if force is None or moment is None:
            return p.position.fixed()
        known = self.system.shapes.get(p.name)
        rotation = plane_rotation(self.configuration, p.name)
        if known is not None and rotation is not None and reaction.name in known.at:
            (x, y), here = known.at[reaction.name], self.system.pose.at(p.position)
            e1, e2 = (self.system.pose.at(a) for a in rotation.axes[:2])
            return self.fixed_in(p, plus(plus(here, e1, x), e2, y))
        f = force.fixed()
        square = f.dot(f)
        return None if square == 0 else p.position.fixed() + f.cross(moment.fixed()) * (1 / square)

    def track(self, p: MassPoint, at: Vector) -> None:
        """The circle on which a wheel rolls: about the centre on which it turns with one of the coordinates."""
        pose = self.chosen
        if pose is None:
            return
        rule = dict(pose.configuration.expressed)
        centre, touched = (v.fixed().map(lambda c: c.xreplace(rule)) for v in (p.position, at))
        for q in pose.coordinates:
            try:
                if angle_mark(pose, q, centre) is None:
                    continue
                middle = (centre + centre.map(lambda c, q=q: c.xreplace({q: q + sp.pi}))) * sp.Rational(1, 2)  # type: ignore[misc]
                away = touched - middle
                distances = [math.hypot(*x.at(away)) for x in (pose, *pose.others)]
                outside = math.hypot(*pose.at(centre - middle)) > distances[0]
            except NoValueError:
                continue
            if max(distances) - min(distances) < 1e-7:
                radius = self.cells.scalar(sp.sqrt(away.dot(away)))
                self.add("round", p=self.at(middle), r=radius, x=int(outside))
                return

    # Curves of constraints, points, names

    def constraint_curves(self) -> None:
        """The curves on which constraints keep particles in a plane."""
        if not self.system.view.planar:
            return
        turning = {r.name for r in self.configuration.rotations}
        for reaction in self.system.newton.reactions:
            if reaction.name in self.hidden or reaction.rod is not None:
                continue
            if reaction.directions is None or len(reaction.directions) != 1:
                continue
            [name] = reaction.directions
            row = next((r for r in self.configuration.rows if r.name == reaction.name), None)
            if row is None or row.finite is None or name in turning:
                continue
            position = next(p.position for p in self.configuration.points if p.name == name).fixed()
            used = set().union(*(c.free_symbols for c in position.components))
            own = tuple(q for q in self.configuration.slots.coordinates if q in used)
            f = sp.sympify(row.finite, strict=True)
            if len(own) != 2 or not (f.free_symbols & {*self.configuration.slots.coordinates}) <= {*own}:
                continue
            constraint = next((c for c in self.system.problem.constraints if c.name == row.name), None)
            solid = constraint is not None and (constraint.side is not None or constraint.by is Keeper.SURFACE)
            force = reaction.per_unit(name) if solid else None
            self.traced.append((f, own, position))
            side = 0 if constraint is None or force is None else push_sense(reaction) or 1
            push = -1 if force is None else self.at(force)
            self.add("trace", f=len(self.traced) - 1, v=push, s=side)

    def points(self) -> None:
        """The lettered points of the figure, and the particles with their names."""
        figure = self.system.problem.figure
        for name, place in figure.points.items():
            self.add("dot", p=self.at(place), r=0.05, l=self.label(name.replace("_", " ")), d=[0.6, 0.8])
        turning = {r.name for r in self.configuration.rotations}
        for p in self.configuration.points:
            if p.name in self.hidden:
                continue
            at = self.flat(p.position)
            x, y = self.meeting(at)
            prefer = toward((0, 0), (-x, -y)) if math.hypot(x, y) > 1e-3 else (0.7, 0.7)
            shown = 0.085 if p.name not in turning and p.name not in figure.shapes else 0.05
            self.add("dot", p=self.at(p.position), r=shown, l=self.label(as_words(p.name)), d=list(prefer))

    def marks(self) -> None:
        """The angles, lengths and arrows of the file."""
        chosen = set(self.chosen.coordinates) if self.chosen else set()
        known = {*self.configuration.slots.coordinates, *chosen}
        every = {q.symbol for q in self.system.problem.coordinates}
        every |= {q for c in self.system.problem.choices for q in c.coordinates}
        for mark in self.system.problem.figure.marks:
            used = mark.label.free_symbols.union(*(c.free_symbols for v in mark.vectors for c in v.fixed().components))
            if (used & every) - known:
                continue
            places = [self.at(v) for v in mark.vectors]
            label = self.label(mark.label)
            if mark.kind is Drawn.ANGLES:
                self.add("corner", p=places, l=label)
            elif mark.kind is Drawn.ARROWS:
                self.add("arrow", p=places, l=label)
            else:
                self.add("length", p=places, l=label)

    # Coordinates

    def coordinates(self) -> None:
        """What each of the coordinates that the page changes measures."""
        pose = self.chosen
        if pose is None:
            return
        rule = dict(pose.configuration.expressed)
        marked = {str(m.label) for m in self.system.problem.figure.marks} | self.hidden
        rest = [q for q in pose.coordinates if q.name not in marked]
        lengths = {rod.length for _, rod in self.system.rods}
        rest = [q for q in rest if q not in lengths]
        points = [(p.position, p.position.fixed().map(lambda c: c.xreplace(rule))) for p in self.system.marked_points]
        for q in list(rest):
            if self.angle(pose, q, points) or self.turn(pose, q):
                rest.remove(q)
        known: list[FloatVector] = [(0.0, 0.0, 0.0), *(pose.at(moved) for _, moved in points)]
        for position, moved in points:
            marks = distance_marks(pose, rest, moved, known)
            if not marks:
                continue
            numbers = [pose.coordinates.index(m.coordinate) for m in marks]
            names = [self.label(m.coordinate) for m in marks]
            floor = not self.system.view.planar and math.hypot(*marks[0].start) > 1e-9
            self.add("distance", q=numbers, p=self.at(position), l=names, f=int(floor))
            for m in marks:
                rest.remove(m.coordinate)

    def angle(self, pose: Pose, q: sp.Symbol, points: Sequence[tuple[Vector, Vector]]) -> bool:
        """The arc of an angle at a point; whether the coordinate is one."""
        number = pose.coordinates.index(q)
        for position, moved in points:
            try:
                mark = angle_mark(pose, q, moved)
            except NoValueError:
                continue
            if mark is not None:
                a, b = self.system.page(mark.centre), self.system.page(mark.point)
                guide = not any(overlapping((a, b), other) for other in self.busy)
                upright = not self.system.view.planar and math.hypot(*mark.centre) > 1e-6
                self.add("angle", q=number, p=self.at(position), l=self.label(q), g=int(guide), u=int(upright))
                if guide:
                    self.busy.append((a, b))
                return True
        for (first, one), (second, other_) in combinations(points, 2) if self.system.view.planar else ():
            for end, start, moved, origin in ((second, first, other_, one), (first, second, one, other_)):
                try:
                    mark = relative_angle_mark(pose, q, moved, origin)
                except NoValueError:
                    continue
                if mark is not None:
                    self.add("angle", q=number, p=self.at(end), o=self.at(start), l=self.label(q), g=0, u=0)
                    return True
        return False

    def turn(self, pose: Pose, q: sp.Symbol) -> bool:
        """The arc of the angle of a plane body; whether the coordinate is one."""
        if not self.system.view.planar:
            return False
        rule = dict(pose.configuration.expressed)
        for p in self.configuration.points:
            rotation = plane_rotation(self.configuration, p.name)
            if rotation is None or p.name in self.hidden:
                continue
            axis = rotation.axes[0].fixed()
            try:
                mark = angle_mark(pose, q, axis.map(lambda c: c.xreplace(rule)))
            except NoValueError:
                continue
            if mark is not None and math.hypot(*mark.centre) < 1e-9:
                self.add("turn", q=pose.coordinates.index(q), p=self.at(p.position), v=self.at(axis), l=self.label(q))
                return True
        return False
