"""A system in a general position on a page: which points are joined, and what keeps its distance from what."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import combinations

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Unspecified
from lagrange.core.vectors import Vector
from lagrange.document.scene import Point
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.constraints.springs_dampers import Damped, Stretched
from lagrange.mechanics.dynamics.newton import Newton, Reaction, newton_equations
from lagrange.mechanics.dynamics.rods import Rod
from lagrange.mechanics.solution import Solution
from lagrange.pictures.floats import NoValueError, Space, minus
from lagrange.pictures.marks import angle_mark
from lagrange.pictures.poses import Pose, general_pose, notable
from lagrange.pictures.shapes import Shape, is_planar, own_coordinates, shape
from lagrange.pictures.views import View, view
from lagrange.problem.model import Problem

WIDTH, HEIGHT = 6.2, 4.6
MOST_POINTS = 12
LONGEST_LINE = 7.0


@record
class System:
    """A system in a position, on a page.

    newton  its free bodies and reactions
    """

    problem: Problem
    configuration: Configuration
    newton: Newton
    pose: Pose
    view: View

    @property
    def rods(self) -> tuple[tuple[Reaction, Rod], ...]:
        """The distances that are kept."""
        return tuple((r, r.rod) for r in self.newton.reactions if r.rod is not None)

    def reactions_on(self, body: str) -> tuple[Reaction, ...]:
        """The reactions on a body, where they are known."""
        known = (r for r in self.newton.reactions if r.directions is not None)
        return tuple(r for r in known if body in r.acts_on)

    @cached_property
    def shapes(self) -> dict[str, Shape]:
        """What is known of the shapes of plane bodies."""
        turning = [is_planar(self.configuration, p.name) for p in self.configuration.points]
        return {r.name: shape(self.pose, r, self.reactions_on(r.name)) for r in turning if r is not None}

    @cached_property
    def joints(self) -> dict[str, list[Space]]:
        """Where plane bodies are joined to what does not move, or to one another.

        It is the centre of the circle on which a mass centre moves with the angle of its body alone, if that point
        stays where it is in space, or in another body.
        """
        found: dict[str, list[Space]] = {}
        for p in self.configuration.points:
            rotation = is_planar(self.configuration, p.name)
            for centre in _circle_centres(self.pose, p, rotation) if rotation is not None else ():
                here = centre(self.pose)
                if here is None:
                    continue
                still = _same_everywhere(self.pose, centre)
                others = [o for o in self.configuration.points if o.name != p.name and _holds(self, o, centre)]
                if still or others:
                    found.setdefault(p.name, []).append(here)
                for o in others:
                    found.setdefault(o.name, []).append(here)
        return found

    @cached_property
    def kept_distances(self) -> tuple[tuple[str, str, bool], ...]:
        """Pairs of points that keep their distance where no single constraint does it, and whether constraints do."""
        ends = {frozenset(rod.ends) for _, rod in self.rods}
        planar = {r.name for p in self.configuration.points if (r := is_planar(self.configuration, p.name))}
        points = [p for p in self.configuration.points if p.name not in planar]
        if len(self.pose.others) < 3:
            return ()
        found = []
        for a, b in combinations(points, 2):
            if {a.name, b.name} in ends:
                continue
            apart = [math.dist(p.at(a.position), p.at(b.position)) for p in (self.pose, *self.pose.others)]
            ways = [minus(p.at(b.position), p.at(a.position)) for p in (self.pose, *self.pose.others)]
            turns = any(math.dist(ways[0], w) > 1e-3 for w in ways)
            if turns and max(apart) - min(apart) < 1e-7 and apart[0] > 1e-3:
                moved = (self.pose.moved(q, 0.37) for q in self.pose.coordinates)
                free = [math.dist(p.at(a.position), p.at(b.position)) for p in moved]
                found.append((a.name, b.name, any(abs(f - apart[0]) > 1e-7 for f in free)))
        return tuple(found)

    @cached_property
    def rod_ends(self) -> tuple[Vector, ...]:
        """Where rods are hinged to what is no particle."""
        return tuple(dict.fromkeys(rod.centre for _, rod in self.rods if rod.centre is not None))

    @cached_property
    def page(self) -> Page:
        """The page, with room for what is drawn."""
        places = [self.pose.at(v) for v in (*notable(self.configuration), *self.rod_ends)]
        flat = [self.view.flat(p) for p in (*places, (0.0, 0.0, 0.0))]
        for p in self.configuration.points:
            known = self.shapes.get(p.name)
            if known is None:
                continue
            x, y = self.view.flat(self.pose.at(p.position))
            reach = max([known.radius, *(math.hypot(*held) for held in known.held)])
            reach = reach if known.radius or known.held else 0.0
            flat += [(x - reach, y - reach), (x + reach, y + reach)]
        left, right = min(p[0] for p in flat), max(p[0] for p in flat)
        low, high = min(p[1] for p in flat), max(p[1] for p in flat)
        only = right - left < 1e-9 or high - low < 1e-9
        scale = min((LONGEST_LINE if only else WIDTH) / max(right - left, 1e-9), HEIGHT / max(high - low, 1e-9), 4.0)
        return Page(self.view, scale)


def _circle_centres(pose: Pose, p: MassPoint, rotation: Rotation) -> list[Callable[[Pose], Space | None]]:
    """For each coordinate that turns a body, where the centre of the circle of its mass centre is."""
    turning = set().union(*(c.free_symbols for c in rotation.axes[0].fixed().components)) & set(pose.coordinates)

    def centre(pose: Pose, q: sp.Symbol) -> Space | None:
        mark = angle_mark(pose, q, p.position)
        return None if mark is None else mark.centre

    return [lambda pose, q=q: centre(pose, q) for q in sorted(turning, key=str)]  # type: ignore[misc]


def _same_everywhere(pose: Pose, place: Callable[[Pose], Space | None]) -> bool:
    places = [place(p) for p in (pose, *pose.others)]
    known = [p for p in places if p is not None]
    return len(known) > 2 and all(math.dist(known[0], p) < 1e-7 for p in known)


def _holds(system: System, body: MassPoint, point: Callable[[Pose], Space | None]) -> bool:
    """Whether a point stays where it is in a body."""
    rotation = is_planar(system.configuration, body.name)
    if rotation is None:
        return False

    def inside(pose: Pose) -> Space | None:
        place = point(pose)
        if place is None:
            return None
        return (*own_coordinates(pose, rotation, body.position, place), 0.0)

    return _same_everywhere(system.pose, inside)


@record
class Page:
    """From space to centimetres; the origin is at (0, 0)."""

    view: View
    scale: float

    def __call__(self, place: Space) -> Point:
        """Where a point of space is on the page."""
        x, y = self.view.flat(place)
        return x * self.scale, y * self.scale

    def way(self, vector: Space) -> Point:
        """A vector on the page, in the units of the problem."""
        return self.view.flat(vector)


def system_in_file(solution: Solution) -> System | None:
    """The system in the coordinates of the file."""
    return _system(solution, solution.configuration, *_pose_in_file(solution))


def system_in_choice(solution: Solution, configuration: Configuration) -> System | None:
    """The system in a choice of generalized coordinates."""
    pose = general_pose(solution.problem, configuration)
    return None if pose is None else _system(solution, configuration, pose, _newton(solution))


def _system(
    solution: Solution, configuration: Configuration, pose: Pose | None, newton: Newton | None
) -> System | None:
    if pose is None or newton is None or not configuration.points or len(configuration.points) > MOST_POINTS:
        return None
    used = set()
    for v in notable(solution.configuration):
        used |= {n for n, c in enumerate(v.fixed().components) if c != 0}
    for r in solution.configuration.rotations:
        for axis in r.axes[:2]:
            used |= {n for n, c in enumerate(axis.fixed().components) if c != 0}
    return System(solution.problem, configuration, newton, pose, view(solution.problem.axes, frozenset(used)))


def is_undefined(configuration: Configuration) -> bool:
    """Whether an undefined function stands where a place is needed."""
    places = (c for v in notable(configuration) for c in v.fixed().components)
    return any(sp.sympify(e, strict=True).has(Unspecified) for e in (*places, *configuration.finite_constraints))


def _newton(solution: Solution) -> Newton:
    if solution.law is not None:
        return solution.law.newton
    problem = solution.problem
    return newton_equations(solution.configuration, problem.constraints, 0, frozenset(problem.scope.names()))


def _pose_in_file(solution: Solution) -> tuple[Pose | None, Newton | None]:
    """A position that looks good in one of the choices of coordinates, otherwise in those of the file."""
    original = solution.configuration
    if is_undefined(original):
        return None, None
    newton = _newton(solution)
    centres = [r.rod.centre for r in newton.reactions if r.rod is not None and r.rod.centre is not None]
    for choice in solution.choices:
        chosen = choice.coordinates.configuration
        if chosen.expressed and not chosen.finite_constraints and not is_undefined(chosen):
            pose = general_pose(solution.problem, chosen, centres if not _moving(centres, original) else ())
            found = None if pose is None else _in_file(pose, original)
            if found is not None:
                return found, newton
    return general_pose(solution.problem, original, centres), newton


def _moving(centres: Sequence[Vector], configuration: Configuration) -> bool:
    moving = set(configuration.slots.coordinates)
    return any(c.free_symbols & moving for v in centres for c in v.fixed().components)


def _in_file(pose: Pose, original: Configuration) -> Pose | None:
    """The same position in the coordinates of the file, if it satisfies the constraints there."""
    try:
        old = {q: pose.number(e) for q, e in pose.configuration.expressed.items()}
        found = Pose(original, {**pose.values, **old})
        if any(q not in found.values for q in original.slots.coordinates):
            return None
        if any(abs(found.number(sp.sympify(f, strict=True))) > 1e-9 for f in original.finite_constraints):
            return None
    except NoValueError:
        return None
    return found


def ends_of(link: Stretched | Damped, configuration: Configuration, pose: Pose) -> tuple[Space, Space]:
    """The two ends of a spring or damper. Raises NoValueError."""
    places = {p.name: p.position for p in configuration.points}
    first, second = (pose.at(places[e]) if isinstance(e, str) else pose.at(e) for e in link.ends)
    return first, second


def rod_ends(rod: Rod, configuration: Configuration, pose: Pose) -> tuple[Space, Space]:
    """The two ends of a rod. Raises NoValueError."""
    places = {p.name: p.position for p in configuration.points}
    first = pose.at(places[rod.ends[0]])
    if rod.ends[1]:
        return first, pose.at(places[rod.ends[1]])
    assert rod.centre is not None
    return first, pose.at(rod.centre)


def with_other_values(pose: Pose, expressions: Sequence[sp.Expr]) -> Pose:
    """The pose with a value for every symbol: velocities are 1, and so are unknown forces."""
    symbols = set().union(*(e.free_symbols for e in expressions)) if expressions else set()
    others = {s: 1.0 + 0.1 * n for n, s in enumerate(sorted(symbols - set(pose.values), key=str))}
    return replace(pose, values={**pose.values, **others})
