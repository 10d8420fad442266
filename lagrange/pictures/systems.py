"""A system in a general position on a page: rods, joints, shapes of bodies, and distances that are constant.

All of this is read off the solution, in floating point: a property is believed if it holds in the position drawn and in
several others. A `PaperMap` maps space to centimetres; its scale is chosen so that all points fit.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from itertools import combinations, product

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.coordinates import of_mass_centre
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.constraints.springs_dampers import DamperForce, StretchedSpring
from lagrange.mechanics.dynamics.free_bodies import Rod
from lagrange.mechanics.dynamics.newton import Newton, Reaction, newton_equations
from lagrange.mechanics.equilibrium.friction.balance import RoughContact
from lagrange.mechanics.results import Solution
from lagrange.pictures.floats import FloatValues, FloatVector, NoValueError, inner, minus, place, value
from lagrange.pictures.implied.lettered import with_lettered_points
from lagrange.pictures.implied.nested_pulleys import hung_side_by_side, nested_pulleys
from lagrange.pictures.implied.rods_at_rest import RodAtRest, is_possible, with_letters
from lagrange.pictures.implied.senses import BOWL
from lagrange.pictures.implied.side_by_side import beside
from lagrange.pictures.implied.springs_of_potentials import springs_of_potentials
from lagrange.pictures.joints import SwingingJoint, circle_centres, holds, on_circle, same_everywhere, swinging_joints
from lagrange.pictures.limits import HEIGHT, LARGEST_SCALE, LONGEST_LINE, MOST_POINTS, SAME_PLACE, WIDTH
from lagrange.pictures.poses import Pose, angle_mark, circle_of, general_pose, notable
from lagrange.pictures.shapes import Shape, coordinates_in_body, plane_rotation, shape
from lagrange.pictures.views import PaperMap, View, seen_from, view
from lagrange.problem.model import AppliedForce, Drawn, Figure, FigureMark, Keeper, Outline, Problem

ROD = re.compile(
    r"pendulum|linkage|\b(rod|arm|link|bar|crank|rocker|lever|beam|pole|stick|hinge)s?\b|\bhinged\b", re.IGNORECASE
)
"""Words for what keeps a distance."""
BEAM = re.compile(r"\b(beam|girder|truss|bridge|support|roller|plank|bracket|frame)s?\b", re.IGNORECASE)
"""Words for what stands on bearings."""
ROPE = re.compile("string|rope|cord|cable|thread", re.IGNORECASE)
_WEIGHT = re.compile(r"[Ww]eight\w*|W|w")
_HOOP = re.compile(r"hoop|\bring\b|circular|bowl|track|loop|dome|sphere|wire\b|bead|tube", re.IGNORECASE)


@record
class SystemPicture:
    """A system in one position on a page.

    newton    the free bodies and reactions
    contacts  those with friction at rest
    around    further places that have to fit on the page
    rods_at_rest  rods that the file gives by their centre and ends alone
    springs   those that the file gives by their energy alone
    """

    problem: Problem
    configuration: Configuration
    newton: Newton
    pose: Pose
    view: View
    contacts: tuple[RoughContact, ...] = ()
    around: tuple[FloatVector, ...] = ()
    rods_at_rest: tuple[RodAtRest, ...] = ()
    springs: tuple[StretchedSpring, ...] = ()

    def at(self, vector: Vector, more: FloatValues | None = None) -> FloatVector:
        """A vector of the file in the position drawn, whatever its coordinates are. Raises NoValueError."""
        expressed, values = self.configuration.expressed, {**self.pose.values, **(more or {})}
        return place(vector.fixed().map(lambda c: c.xreplace(expressed)) if expressed else vector, values)

    def number(self, expression: sp.Expr) -> float:
        """The value of an expression of the file. Raises NoValueError."""
        return value(sp.sympify(expression, strict=True).xreplace(dict(self.configuration.expressed)), self.pose.values)

    @cached_property
    def figure_places(self) -> dict[str, FloatVector]:
        """The places of the points that the figure adds, and of the mass centre where coordinates lead to it."""
        places = {name: self.at(v) for name, v in self.problem.figure.points.items()}
        centre = self.mass_centre
        return places if centre is None else places | {centre.name: self.pose.at(centre.position)}

    @cached_property
    def mass_centre(self) -> MassPoint | None:
        """The mass centre of several particles where coordinates x_C, y_C, ... are its own; it has their index."""
        own = of_mass_centre(self.configuration, self.configuration.slots.coordinates)
        called = {q.name.partition("_")[2] for q in own}
        taken = {p.name for p in self.configuration.points} | {*self.problem.figure.points, ""}
        if len(own) < 2 or len(called) > 1 or called & taken:
            return None
        points, zero = self.configuration.points, Vector.zero()
        total = sp.Add(*(p.mass for p in points))
        at = sum((p.position.fixed() * (p.mass / total) for p in points), zero).map(textbook_form)
        return MassPoint(called.pop(), sp.S.Zero, at, zero, zero, ())

    @cached_property
    def marks(self) -> tuple[FigureMark, ...]:
        """The marks of the figure, without those of other coordinates than those drawn."""
        own = {*self.pose.coordinates}
        every = {q.symbol for q in self.problem.coordinates} | {q for c in self.problem.choices for q in c.coordinates}
        return tuple(m for m in self.problem.figure.marks if not (m.label.free_symbols & every) - own)

    @property
    def links(self) -> tuple[StretchedSpring | DamperForce, ...]:
        """The springs and dampers that are drawn."""
        return (*self.configuration.links, *self.springs)

    @property
    def down(self) -> Vector | None:
        """The direction of gravity, or of the weights that the file gives as forces; None if it gives neither."""
        return self.problem.gravity or weight(self.problem)

    @property
    def is_bare(self) -> bool:
        """Whether the file draws no bodies with lines of its own."""
        figure = self.problem.figure
        return not (figure.lines or figure.circles or figure.curves)

    @property
    def hidden(self) -> frozenset[str]:
        """The names of what is not drawn, coordinates with a mark of their own among them."""
        return self.problem.figure.hidden | {str(m.label) for m in self.marks}

    @cached_property
    def marked_points(self) -> tuple[MassPoint, ...]:
        """The particles, the mass centres, and the points of the figure: what coordinates may lead to."""
        zero, expressed = Vector.zero(), self.configuration.expressed
        more = (
            MassPoint(name, sp.S.Zero, v.fixed().map(lambda c: c.xreplace(expressed)), zero, zero, ())
            for name, v in self.problem.figure.points.items()
        )
        return (*self.configuration.points, *more, *([self.mass_centre] if self.mass_centre is not None else []))

    @property
    def rods(self) -> tuple[tuple[Reaction, Rod], ...]:
        """The reactions that keep a distance, with their rods."""
        return tuple((r, r.rod) for r in self.newton.reactions if r.rod is not None and self.is_rod(r))

    def is_rod(self, reaction: Reaction) -> bool:
        """Whether what keeps a distance is a rod or string, and not a bowl or a hoop, as far as is said."""
        if reaction.rod is None or reaction.rod.ends[1]:
            return reaction.rod is not None
        by = reaction.constraint.by
        if by in (Keeper.SURFACE, Keeper.WIRE) or by in (Keeper.ROD, Keeper.STRING):
            return by in (Keeper.ROD, Keeper.STRING)
        return not _HOOP.search(reaction.name)

    def is_surface_between(self, first: str, second: str) -> bool:
        """Whether two points keep their distance since one of them slides on a surface or wire of the other."""
        between = [r.constraint for r in self.newton.reactions if {*r.acts_on} == {first, second}]
        return any(c.by in (Keeper.SURFACE, Keeper.WIRE) or (c.side or 0) > 0 for c in between)

    def reactions_on(self, body: str) -> tuple[Reaction, ...]:
        """The reactions on a body whose directions are known."""
        known = (r for r in self.newton.reactions if r.directions is not None)
        return tuple(r for r in known if body in r.acts_on)

    def is_touched(self, body: str, place: FloatVector) -> bool:
        """Whether a plane body is kept at a place by ground or by the bearing of a beam, and not by a hinge."""
        rotation, is_beam = plane_rotation(self.configuration, body), bool(BEAM.search(self.text))
        touching = {r.name for r in self.newton.reactions if is_beam or r.constraint.side is not None}
        if rotation is None or not touching:
            return False
        position = next(p.position for p in self.configuration.points if p.name == body)
        here = coordinates_in_body(self.pose, rotation, position, place)
        return any(n in touching and math.dist(at, here) < SAME_PLACE for n, at in self.shapes[body].at.items())

    @cached_property
    def shapes(self) -> dict[str, Shape]:
        """The shapes of plane bodies, by name."""
        turning = [plane_rotation(self.configuration, p.name) for p in self.configuration.points]
        return {r.name: shape(self.pose, r, self.reactions_on(r.name)) for r in turning if r is not None}

    @cached_property
    def joints(self) -> dict[str, list[FloatVector]]:
        """The points at which plane bodies are joined to the ground or to one another, by body.

        A joint is the centre of the circle on which a mass centre moves when only the angle of its body changes, if
        that point is fixed in space or in another body.
        """
        joints: dict[str, list[FloatVector]] = {}
        for p in self.configuration.points:
            rotation = plane_rotation(self.configuration, p.name)
            for centre in circle_centres(self.pose, p, rotation) if rotation is not None else ():
                joint = centre(self.pose)
                if joint is None or not holds(self.pose, p, centre):
                    continue
                fixed = same_everywhere(self.pose, centre)
                others = [o for o in self.configuration.points if o.name != p.name and holds(self.pose, o, centre)]
                if fixed or others:
                    joints.setdefault(p.name, []).append(joint)
                for o in others:
                    joints.setdefault(o.name, []).append(joint)
        return joints

    @cached_property
    def swinging_joints(self) -> tuple[SwingingJoint, ...]:
        """The joints of plane bodies that themselves move on a circle about a fixed place by another coordinate."""
        return swinging_joints(self.configuration, self.pose) if self.is_bare and self.view.planar else ()

    def is_on_body(self, place: Vector) -> bool:
        """Whether a place is fixed in a plane body."""
        turning = (p for p in self.configuration.points if plane_rotation(self.configuration, p.name) is not None)
        return any(holds(self.pose, p, lambda pose: pose.at(place)) for p in turning)

    @cached_property
    def marked(self) -> dict[str, list[FloatVector]]:
        """The massless points that move with a plane body, its ends perhaps, by body."""
        massless = {o.name: self.pose.at(o.position) for o in self.configuration.points if o.mass == 0}
        return {name: [at for at in carried if at in massless.values()] for name, carried in self.carried.items()}

    @cached_property
    def carried(self) -> dict[str, list[FloatVector]]:
        """The particles and massless points that move with a plane body, by body."""
        points = self.configuration.points
        turning = {p.name for p in points if plane_rotation(self.configuration, p.name) is not None}
        places = [o.position for o in points if o.name not in turning]
        places += [v for n, v in self.problem.figure.points.items() if n in self.problem.abbreviations]
        return {
            p.name: [
                self.pose.at(v)
                for v in places
                if holds(self.pose, p, lambda pose, v=v: pose.at(v))  # type: ignore[misc]
            ]
            for p in points
            if p.name in turning
        }

    @cached_property
    def fastened(self) -> dict[str, list[FloatVector]]:
        """The ends of springs and dampers that move with a plane body, by body."""
        ends = {e for link in self.links for e in link.ends if isinstance(e, Vector)}
        return {
            p.name: [self.pose.at(e) for e in ends if holds(self.pose, p, lambda pose, e=e: pose.at(e))]  # type: ignore[misc]
            for p in self.configuration.points
            if ends and plane_rotation(self.configuration, p.name) is not None
        }

    @cached_property
    def pivots(self) -> tuple[FloatVector, ...]:
        """The joints of plane bodies that are fixed in space."""
        turning = [(p, plane_rotation(self.configuration, p.name)) for p in self.configuration.points]
        centres = [
            c for p, r in turning if r is not None for c in circle_centres(self.pose, p, r) if holds(self.pose, p, c)
        ]
        places = [c(self.pose) for c in centres if same_everywhere(self.pose, c)]
        return tuple(place for place in places if place is not None)

    @cached_property
    def text(self) -> str:
        """Title, description and names: words that tell a rod from a hoop."""
        return " ".join((self.problem.title, self.problem.description, *(p.name for p in self.problem.masses)))

    @property
    def is_round(self) -> bool:
        """Whether the text speaks of a hoop or the like, and of no rod."""
        return bool(_HOOP.search(self.text)) and not ROD.search(self.text)

    @property
    def is_bowl(self) -> bool:
        """Whether the text speaks of what is open above."""
        return bool(BOWL.search(self.text))

    @property
    def is_inside(self) -> bool:
        """Whether the text speaks of something round that has an inside."""
        return bool(_HOOP.search(self.text) or BOWL.search(self.text))

    def is_hoop(self, name: str) -> bool:
        """Whether a body is called a hoop or the like."""
        return bool(_HOOP.search(name))

    @cached_property
    def paths(self) -> dict[str, list[FloatVector]]:
        """The curves on which particles with one coordinate and no constraint move, by particle; circles of hoops only.

        From as far on the other side of 0 as it is on this, or for 3/4 of a turn to either side.
        """
        paths: dict[str, list[FloatVector]] = {}
        for p in self.configuration.points if self.is_bare and not self.configuration.rows else ():
            components = p.position.fixed().components
            moving = [q for q in self.pose.coordinates if any(c.has(q) for c in components)]
            if len(moving) > 1 and self.is_round:  # a hoop that turns itself
                moving = [q for q in moving if self._is_on_circle(q, p.position)]
            at_rest = self.is_round and all(o.mass == 0 for o in self.configuration.points)
            if (
                len(moving) != 1
                or (p.mass == 0 and not at_rest)
                or (any(c.has(t) for c in components) and not self.is_round)
            ):
                continue
            [q] = moving
            here = self.pose.values[q]
            turns = any(q in a.free_symbols for c in components for a in c.atoms(sp.sin, sp.cos))
            start, end = (here - 1.5 * math.pi, here + 1.5 * math.pi) if turns else (-1.3 * here, 1.3 * here)
            with suppress(NoValueError):
                if circle_of(self.pose, q, p.position) is not None:
                    start, end = here, here + 2 * math.pi
                    if not self.is_round:
                        continue
                steps = (start + (end - start) * n / 96 - here for n in range(97))
                places = [self.pose.moved(q, s).at(p.position) for s in steps]
                first, second = (minus(places[n], places[0]) for n in (30, 60))
                if at_rest and circle_of(self.pose, q, p.position) is None and not on_circle(places):
                    continue
                if abs(inner(first, second)) < math.hypot(*first) * math.hypot(*second) * (1 - 1e-9):  # no line
                    paths[p.name] = places
        return paths

    def _is_on_circle(self, q: sp.Symbol, position: Vector) -> bool:
        """Whether a coordinate alone moves a point on one circle, the same in every position of the others."""
        marks = []
        for pose in (self.pose, *self.pose.others):
            with suppress(NoValueError):
                marks.append(angle_mark(pose, q, position))
        circles = [(m.centre, math.dist(m.centre, m.point)) for m in marks if m is not None]
        return len(circles) == len(marks) > 1 and all(
            math.dist(c, circles[0][0]) < SAME_PLACE and abs(r - circles[0][1]) < SAME_PLACE for c, r in circles
        )

    @cached_property
    def kept_distances(self) -> tuple[tuple[str, str, bool], ...]:
        """Pairs of points with a constant distance that no single constraint keeps, and whether constraints keep it."""
        ends = {frozenset(rod.ends) for _, rod in self.rods}
        planar = {r.name for p in self.configuration.points if (r := plane_rotation(self.configuration, p.name))}
        points = [p for p in self.configuration.points if p.name not in planar]
        if len(self.pose.others) < 3:
            return ()
        pairs = []
        for a, b in combinations(points, 2):
            if {a.name, b.name} in ends:
                continue
            apart = [math.dist(p.at(a.position), p.at(b.position)) for p in (self.pose, *self.pose.others)]
            ways = [minus(p.at(b.position), p.at(a.position)) for p in (self.pose, *self.pose.others)]
            turns = any(math.dist(ways[0], w) > 1e-3 for w in ways)
            if turns and max(apart) - min(apart) < 1e-7 and apart[0] > 1e-3:
                # Moved off the constraints, the distance changes if the constraints keep it, not the coordinates.
                moved = (self.pose.moved(q, 0.37) for q in self.pose.coordinates)
                free = [math.dist(p.at(a.position), p.at(b.position)) for p in moved]
                pairs.append((a.name, b.name, any(abs(f - apart[0]) > 1e-7 for f in free)))
        return tuple(pairs)

    @cached_property
    def rod_ends(self) -> tuple[Vector, ...]:
        """The fixed ends of rods."""
        return tuple(dict.fromkeys(rod.centre for _, rod in self.rods if rod.centre is not None))

    @cached_property
    def page(self) -> PaperMap:
        """The page, with a scale at which all points and bodies fit."""
        places = [self.pose.at(v) for v in (*notable(self.configuration), *self.rod_ends)]
        flat = [self.view.flat(p) for p in (*places, *self.around, *self._figure_corners(), (0.0, 0.0, 0.0))]
        for p in self.configuration.points:
            known = self.shapes.get(p.name)
            if known is None:
                continue
            x, y = self.view.flat(self.pose.at(p.position))
            reach = max([known.radius, *(math.hypot(*held) for held in known.held)])
            reach = reach if known.radius or known.held else 0.0
            flat += [(x - reach, y - reach), (x + reach, y + reach)]
        bodies = {r.name for r in self.configuration.rotations}
        flat += [self.view.flat(place) for name, path in self.paths.items() if name not in bodies for place in path]
        for at, radius in self._circles():
            x, y = self.view.flat(at)
            flat += [(x - radius, y - radius), (x + radius, y + radius)]
        left, right = min(p[0] for p in flat), max(p[0] for p in flat)
        low, high = min(p[1] for p in flat), max(p[1] for p in flat)
        only = right - left < 1e-9 or high - low < 1e-9
        width = LONGEST_LINE if only else WIDTH
        scale = min(width / max(right - left, 1e-9), HEIGHT / max(high - low, 1e-9), LARGEST_SCALE)
        return PaperMap(self.view, scale)

    def _figure_corners(self) -> Iterator[FloatVector]:
        """Places of what the figure adds."""
        figure = self.problem.figure
        for line in figure.lines:
            places = line.places[:1] if line.kind in (Drawn.BLADES, Drawn.WHEELS) else line.places
            yield from (self.at(p) for p in places if not isinstance(p, str))
        yield from self.figure_places.values()
        yield from (self.pose.at(e) for spring in self.springs for e in spring.ends if isinstance(e, Vector))
        for mark in self.marks:
            yield from (self.at(v) for v in (mark.vectors[:1] if mark.kind is Drawn.ANGLES else mark.vectors))
        for curve in figure.curves:
            ends = [(self.number(a), self.number(b)) for a, b in curve.between]
            for parts in product((0, 0.25, 0.5, 0.75, 1), repeat=len(ends)):
                values = {s: a + (b - a) * p for s, (a, b), p in zip(curve.along, ends, parts, strict=True)}
                yield self.at(curve.point, values)
        for outline in figure.shapes.values():
            yield from (self.at(end) for end in outline.ends)

    def _circles(self) -> Iterator[tuple[FloatVector, float]]:
        """The places and radii of round and square things."""
        figure = self.problem.figure
        for circle in (*figure.circles, *figure.pulleys.values()):
            yield self.at(circle.centre), abs(self.number(circle.radius))
        for p in self.configuration.points:
            outline = figure.shapes.get(p.name)
            if outline is not None and outline.lengths:
                size = max(abs(self.number(x)) for x in outline.lengths)
                half = 0.5 if outline.kind is Outline.BOX else 0.75 if outline.kind is Outline.CONE else 1.0
                yield self.pose.at(p.position), half * size


def system_in_file(solution: Solution) -> SystemPicture | None:
    """The system in the coordinates of the file."""
    return _system(solution, solution.own.configuration, *_pose_in_file(solution))


def system_posed_in_choice(solution: Solution, chosen: Configuration) -> tuple[SystemPicture, Pose] | None:
    """The system in the coordinates of the file, in a position that is good in a choice, and that position there."""
    original, figure = solution.own.configuration, solution.problem.figure
    if is_undefined(chosen, figure) or chosen.finite_constraints:
        return None
    newton = _newton(solution)
    centres = [r.rod.centre for r in newton.reactions if r.rod is not None and r.rod.centre is not None]
    pose = general_pose(solution.problem, chosen, centres if not _moving(centres, original) else (), is_possible)
    placed = None if pose is None else _in_file(pose, original)
    system = None if placed is None else _system(solution, original, placed, newton)
    return None if system is None or pose is None else (system, pose)


def system_in_choice(solution: Solution, configuration: Configuration) -> SystemPicture | None:
    """The system in a choice of generalized coordinates."""
    pose = general_pose(solution.problem, configuration, (), is_possible)
    return None if pose is None else _system(solution, configuration, pose, _newton(solution))


def _system(
    solution: Solution, configuration: Configuration, pose: Pose | None, newton: Newton | None
) -> SystemPicture | None:
    figure = solution.problem.figure
    if pose is None or newton is None or len(configuration.points) > MOST_POINTS:
        return None
    if not (configuration.points or figure.points or figure.lines or figure.curves):
        return None
    strings = tuple(r for r in newton.reactions if is_string(r))
    falls = (
        solution.problem.gravity if ROPE.search(f"{solution.problem.title} {solution.problem.description}") else None
    )
    machine = nested_pulleys(configuration, strings)
    hung = beside(configuration, strings, falls) if machine is None else hung_side_by_side(configuration, machine)
    sprung = springs_of_potentials(solution.problem, hung)
    shown = machine.values(configuration, falls) if machine is not None and falls is not None else sprung.shown
    pose = replace(pose, values={**pose.values, **shown}) if not figure.at else pose
    own = beside(solution.own.configuration, strings, falls)
    problem, rods = with_letters(solution.problem, pose)
    problem = problem if rods else with_lettered_points(problem, pose)
    used = set()
    for v in (*notable(own), *_vectors(problem.figure)):
        used |= {n for n, c in enumerate(v.fixed().components) if c != 0}
    for r in solution.own.configuration.rotations:
        for axis in r.axes[:2]:
            used |= {n for n, c in enumerate(axis.fixed().components) if c != 0}
    seen = view(solution.problem.axes, frozenset(used))
    down = figure.down or solution.problem.gravity or weight(solution.problem)
    if down is not None:
        with suppress(NoValueError):
            seen = seen.upright(pose.at(down), solution.problem.axes)
    if figure.seen_from is not None and not seen.planar:
        with suppress(NoValueError):
            upright = pose.at(down) if down is not None else (0.0, 0.0, -1.0)
            seen = seen_from(pose.at(figure.seen_from), upright)
    contacts = _rough_contacts(solution)
    return SystemPicture(problem, sprung.configuration, newton, pose, seen, contacts, (), rods, sprung.springs)


def weight(problem: Problem) -> Vector | None:
    """The constant force that a file calls a weight."""
    coordinates = {q.symbol for q in problem.coordinates}
    for force in problem.forces:
        if isinstance(force, AppliedForce) and _WEIGHT.fullmatch(force.name):
            vector = force.vector.fixed()
            if not vector.is_zero and not vector.as_sum().free_symbols & coordinates:
                return vector
    return None


def without_weights(system: SystemPicture) -> SystemPicture:
    """The system with the forces that the file names only."""
    named = {f.name for f in system.problem.forces}
    loads = tuple(f for f in system.configuration.loads if f.name in named)
    return replace(system, configuration=replace(system.configuration, loads=loads))


def is_string(reaction: Reaction) -> bool:
    """Whether a string or rope keeps a constraint."""
    return reaction.constraint.by is Keeper.STRING or bool(ROPE.search(reaction.row.name))


def _rough_contacts(solution: Solution) -> tuple[RoughContact, ...]:
    """The contacts with friction at rest, or at its limit."""
    rest = next((v.at_rest for v in solution.views if v.at_rest is not None), None)
    impending = next((v.impending for v in solution.views if v.impending), None)
    return rest.contacts if rest is not None else impending[0].contacts if impending is not None else ()


def _vectors(figure: Figure) -> Iterator[Vector]:
    yield from figure.points.values()
    yield from (p for line in figure.lines for p in line.places if not isinstance(p, str))
    yield from (curve.point for curve in figure.curves)
    yield from (circle.centre for circle in (*figure.circles, *figure.pulleys.values()))


def is_undefined(configuration: Configuration, figure: Figure) -> bool:
    """Whether a function without a value occurs in a position or constraint, so that nothing can be drawn."""
    places = (c for v in notable(configuration) for c in v.fixed().components)
    expressions = (sp.sympify(e, strict=True) for e in (*places, *configuration.finite_constraints))
    return any(f.name not in figure.at for e in expressions for f in e.atoms(Unspecified))


def _newton(solution: Solution) -> Newton:
    if solution.law is not None:
        return solution.law.newton
    problem = solution.problem
    return newton_equations(solution.own.configuration, problem.constraints, 0, frozenset(problem.scope.names()))


def _pose_in_file(solution: Solution) -> tuple[Pose | None, Newton | None]:
    """A good position, from one of the choices of coordinates or else from those of the file; Newton's equations."""
    original = solution.own.configuration
    if is_undefined(original, solution.problem.figure):
        return None, None
    newton = _newton(solution)
    centres = [r.rod.centre for r in newton.reactions if r.rod is not None and r.rod.centre is not None]
    figure = solution.problem.figure
    named = {q.name for q in original.slots.coordinates} & {*figure.at}
    by_name = sorted(
        solution.choices, key=lambda c: not {q.name for q in c.configuration.slots.coordinates} & {*figure.at}
    )
    for choice in () if named else by_name:
        chosen = choice.coordinates.configuration
        if chosen.expressed and not chosen.finite_constraints and not is_undefined(chosen, figure):
            pose = general_pose(
                solution.problem, chosen, centres if not _moving(centres, original) else (), is_possible
            )
            in_file = None if pose is None else _in_file(pose, original)
            if in_file is not None:
                return in_file, newton
    return general_pose(solution.problem, original, centres, is_possible), newton


def _moving(centres: Sequence[Vector], configuration: Configuration) -> bool:
    moving = set(configuration.slots.coordinates)
    return any(c.free_symbols & moving for v in centres for c in v.fixed().components)


def _in_file(pose: Pose, original: Configuration) -> Pose | None:
    """The same position in the coordinates of the file; None if it violates the constraints there."""
    try:
        old = {q: pose.number(e) for q, e in pose.configuration.expressed.items()}
        in_file = Pose(original, {**pose.values, **old})
        if any(q not in in_file.values for q in original.slots.coordinates):
            return None
        if any(abs(in_file.number(sp.sympify(f, strict=True))) > 1e-9 for f in original.finite_constraints):
            return None
    except NoValueError:
        return None
    return in_file


def ends_of(
    link: StretchedSpring | DamperForce, configuration: Configuration, pose: Pose
) -> tuple[FloatVector, FloatVector]:
    """The two ends of a spring or damper. Raises NoValueError."""
    places = {p.name: p.position for p in configuration.points}
    first, second = (pose.at(places[e]) if isinstance(e, str) else pose.at(e) for e in link.ends)
    return first, second


def rod_ends(rod: Rod, configuration: Configuration, pose: Pose) -> tuple[FloatVector, FloatVector]:
    """The two ends of a rod. Raises NoValueError."""
    places = {p.name: p.position for p in configuration.points}
    first = pose.at(places[rod.ends[0]])
    if rod.ends[1]:
        return first, pose.at(places[rod.ends[1]])
    assert rod.centre is not None
    return first, pose.at(rod.centre)


def with_other_values(pose: Pose, expressions: Sequence[sp.Expr]) -> Pose:
    """The pose with a value near 1 for every further symbol: velocities and unknown forces."""
    symbols = set().union(*(e.free_symbols for e in expressions)) if expressions else set()
    others = {s: 1.0 + 0.1 * n for n, s in enumerate(sorted(symbols - set(pose.values), key=str))}
    return replace(pose, values={**pose.values, **others})
