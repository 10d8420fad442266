"""A general position of a system that makes a good picture, and the geometric meaning of coordinates in it.

Lengths have the values that their letters suggest (R greater than r, l about 2), angles are neither small nor right,
and the coordinates are brought onto the constraints by Newton's iteration. Of several such positions, the best has
its points far apart and its lines slanted. If different points are too close together in all of them, there is no
picture.

A coordinate is an angle or a distance if, when it changes by δ and the others do not, a point moves on a circle by the
angle δ, or on a straight line by the length δ:

    r(q + δ) = c + A cos δ + B sin δ ,  |A| = |B|, A·B = 0 :  an angle at c, counted from the point with q = 0
    r(q + δ) = r(q) + δ e ,  |e| = 1 :                         a distance along e, counted from the point with q = 0

Other coordinates are not marked.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from itertools import combinations
from random import Random

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.core.records import record
from lagrange.core.symbols import Bounded, Sign, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.constraints.springs_dampers import StretchedSpring
from lagrange.pictures.floats import (
    FloatValues,
    FloatVector,
    NoValueError,
    inner,
    minus,
    outer,
    place,
    plus,
    projected,
    value,
)
from lagrange.pictures.implied.senses import before_a_kerb, below, heights_of_hanging, views
from lagrange.pictures.limits import LEAST_GAP, MOST_UNEQUAL, SAME_PLACE, TRIALS
from lagrange.problem.model import Problem

# What the letters suggest to a reader: a rod l is longer than a radius r, and R is greater than r.
_SIZES = {
    "L": 4.0,
    "H": 3.0,
    "l": 2.0,
    "R": 2.0,
    "r": 0.8,
    "a": 1.1,
    "b": 0.9,
    "c": 0.7,
    "h": 1.2,
    "d": 0.6,
    "f": 0.8,
    "k": 0.4,
}
_PLACES = {"x": 1.5, "y": 1.1, "z": 1.2, "r": 1.8, "s": 1.4, "u": 1.6}
_ANGLES = (33, 58, 20, 72)


@record
class Pose:
    """A position: values of all symbols, which satisfy the constraints of a configuration."""

    configuration: Configuration
    values: FloatValues

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """The coordinates."""
        return self.configuration.slots.coordinates

    def at(self, vector: Vector) -> FloatVector:
        """The components of a vector along i, j, k. Raises NoValueError."""
        return place(vector, self.values)

    def number(self, expression: sp.Expr) -> float:
        """The value of an expression. Raises NoValueError."""
        return value(expression, self.values)

    def moved(self, coordinate: sp.Symbol, by: float) -> Pose:
        """The pose with one coordinate changed; the constraints may be violated."""
        return replace(self, values={**self.values, coordinate: self.values[coordinate] + by})

    def with_zero(self, coordinates: Iterable[sp.Symbol]) -> Pose:
        """The pose with some coordinates 0."""
        return replace(self, values={**self.values, **dict.fromkeys(coordinates, 0.0)})

    @cached_property
    def others(self) -> tuple[Pose, ...]:
        """Up to four other positions of the same system: what holds in all of them is no coincidence."""
        random = Random(1)
        slopes = _slopes(self.configuration)
        poses = []
        for _ in range(12):
            start = dict(self.values) | {q: self.values[q] + random.uniform(-0.5, 0.5) for q in self.coordinates}
            try:
                values = projected(self.configuration.finite_constraints, slopes, self.coordinates, start)
            except NoValueError:
                continue
            poses.append(replace(self, values=values))
        kept = (abs(p.values[q] - self.values[q]) < SAME_PLACE for p in poses[:4] for q in self.coordinates)
        if len(self.coordinates) == 1 and all(kept):
            # A strut or string that is taken away in thought keeps the only coordinate: without it, the rods move.
            [q] = self.coordinates
            return tuple(self.moved(q, by) for by in (0.11, -0.13, 0.19, -0.17))
        return tuple(poses[:4])


def notable(configuration: Configuration) -> list[Vector]:
    """The particles, mass centres and ends of springs."""
    ends = (e for link in configuration.links for e in link.ends)
    points = [*(p.position for p in configuration.points), *(e for e in ends if isinstance(e, Vector))]
    return list(dict.fromkeys(points))


def general_pose(
    problem: Problem,
    configuration: Configuration,
    centres: Sequence[Vector] = (),
    is_possible: Callable[[Problem, Pose], bool] | None = None,
) -> Pose | None:
    """The best of several positions; None if none is good.

    centres      fixed ends of rods, which count as points
    is_possible  what else has to hold in a good position
    """
    points = [p.fixed() for p in dict.fromkeys((*notable(configuration), *centres))]
    slopes = _slopes(configuration)
    hanging = frozenset(heights_of_hanging(problem, configuration))
    best: tuple[float, Pose] | None = None
    for trial in range(2 * TRIALS):
        if trial == TRIALS and best is not None and best[0] > 0:
            break  # the second half has smaller coordinates and other proportions
        try:
            start = _guess(problem, configuration, points, trial)
            values = _onto_constraints(problem, configuration, slopes, start)
            pose = Pose(configuration, values)
            score = _score(pose, points, hanging)
            if score is not None and not (
                _has_room(pose, problem) and (is_possible is None or is_possible(problem, pose))
            ):
                score -= 2  # a picture all the same, where no position is better
        except NoValueError:
            continue
        if chosen_values(problem):
            return pose
        if score is not None and (best is None or score > best[0]):
            best = score, pose
    return best[1] if best else None


def chosen_values(problem: Problem) -> dict[str, float]:
    """Numbers by name: those of `figure: at`, and the position in which something is struck."""
    before = problem.impact.before if problem.impact is not None and not problem.figure.at else ()
    coordinates = {q.symbol for q in problem.coordinates}
    struck = {v.symbol.name: float(v.value) for v in before if v.symbol in coordinates and v.value.is_number}
    return struck | {name: float(number) for name, number in problem.figure.at.items()}


def _onto_constraints(
    problem: Problem, configuration: Configuration, slopes: list[list[sp.Expr]], start: dict[sp.Symbol, float]
) -> dict[sp.Symbol, float]:
    """A position on the constraints, if possible with the coordinates in which something is struck."""
    coordinates, finite = configuration.slots.coordinates, configuration.finite_constraints
    drawn_by_file = bool(problem.figure.at)
    if problem.impact is not None and not drawn_by_file and coordinates == tuple(q.symbol for q in problem.coordinates):
        touching = [sp.sympify(c.lhs - c.rhs, strict=True) for c in problem.impact.constraints if not c.kinematic]
        finite = (*finite, *touching)
        slopes = [*slopes, *([f.diff(q) for q in coordinates] for f in touching)]
    struck = chosen_values(problem) if problem.impact is not None else {}
    free = [n for n, q in enumerate(coordinates) if q.name not in struck]
    if len(free) < len(coordinates):
        with suppress(NoValueError):
            return projected(finite, [[row[n] for n in free] for row in slopes], [coordinates[n] for n in free], start)
    return projected(finite, slopes, coordinates, start)


def _slopes(configuration: Configuration) -> list[list[sp.Expr]]:
    relations = configuration.finite_constraints
    return [[sp.sympify(f, strict=True).diff(q) for q in configuration.slots.coordinates] for f in relations]


def _guess(
    problem: Problem, configuration: Configuration, points: Sequence[Vector], trial: int
) -> dict[sp.Symbol, float]:
    angles = set(_angles([*_expressions(configuration, points)]))
    values: dict[sp.Symbol, float] = {t: 1.0}
    chosen = chosen_values(problem)
    given = _given(problem, [*_expressions(configuration, points)], configuration)
    parameters = {p.symbol for p in problem.parameters}
    coordinates = configuration.slots.coordinates
    unknowns = set().union(*(e.free_symbols for e in _expressions(configuration, points))) if points else set()
    turns = iter(_ANGLES * (1 + len(coordinates)))
    random, spread, near = Random(trial), 0.3 if trial else 0.0, 1.0
    radii = 1.0
    if trial >= TRIALS:
        spread, near, radii = 0.7, 0.5, 0.5
    for s in coordinates:
        wobble = near * (1 + random.uniform(-spread, spread))
        values[s] = (math.radians(next(turns)) if s in angles else _place(s.name, falling=trial % 4 == 3)) * wobble
    for s in configuration.slots.prescribed:
        values[s] = 0.6 if s in angles else 0.5
    for s in sorted(parameters | unknowns, key=str):
        wobble = 1 + random.uniform(-spread, spread)
        if s not in values:
            size = _size(s) * (radii if s.name[0] in "Rr" else 1.0)
            values[s] = given.get(s) or _in_range(s, 0.55 * wobble if s in angles else size * wobble)
    for s in (*below(problem, configuration, points), *heights_of_hanging(problem, configuration)):
        values[s] = -abs(values[s])
    for s, value_ in before_a_kerb(problem, points, values):
        values[s] = value_
    for s, factor in views(configuration, points, angles, parameters):
        values[s] = factor(values)
    undefined = {sp.Symbol(f.name, real=True): chosen[f.name] for f in problem.functions if f.name in chosen}
    return {s: chosen.get(s.name, v) for s, v in values.items()} | undefined


def _given(problem: Problem, expressions: Sequence[sp.Expr], configuration: Configuration) -> dict[sp.Symbol, float]:
    """The values of the file, with lengths in a unit in which they have the size that their letters suggest.

    A disc of 150 mm is drawn as large as one of 3 m. Lengths of very different sizes are brought nearer to each other,
    in their order: an axle of 5 mm under a string of 2 m would not be seen.
    """
    values = {p.symbol: float(p.value) for p in problem.parameters if p.value is not None}
    moments = [moment for r in configuration.rotations for moment in r.inertia.moments]
    used = set().union(*(e.free_symbols for e in (*expressions, *moments))) if expressions else set()
    places = [sp.sympify(f, strict=True) for f in configuration.finite_constraints]
    places += [c for p in configuration.points for c in p.position.fixed().components]
    loads = [c for f in configuration.loads for c in f.vector.fixed().components]
    sizes = {s for c in loads for s in c.free_symbols} - {s for c in places for s in c.free_symbols}
    for s in values.keys() & sizes:  # a force of 1e20 N has a direction; its size is not drawn
        if values[s] and not 1e-3 < abs(values[s]) < 1e3:
            values[s] = math.copysign(1.0, values[s])
    lengths = {p.symbol: abs(values[p.symbol]) for p in problem.parameters if p.symbol in values and p.unit == "m"}
    lengths = {s: v for s, v in lengths.items() if s in used and v > 0}
    bare = any(a.is_Number and a != 0 for e in expressions for a in sp.Add.make_args(e) if e.is_Add)
    if not lengths or problem.figure.at or bare:
        return values
    greatest, least = max(lengths.values()), min(lengths.values())
    power = math.log(MOST_UNEQUAL) / math.log(greatest / least) if greatest > MOST_UNEQUAL * least else 1.0
    size = max(_size(s) for s in lengths)
    drawn = {s: math.copysign(size * (v / greatest) ** power, values[s]) for s, v in lengths.items()}
    curvatures = [p.symbol for p in problem.parameters if p.symbol in values and p.unit == "1/m"]
    return values | drawn | {s: values[s] * greatest / size for s in curvatures}


def _in_range(symbol: sp.Symbol, value: float) -> float:
    """The value, or the middle of the range that the symbol has."""
    if isinstance(symbol, Bounded) and not symbol.low <= value <= symbol.high:
        return float((symbol.low + symbol.high) / 2)
    return value


def _letter(name: str) -> tuple[str, int]:
    letter = name.rstrip("'").split("_")[0].rstrip("0123456789")
    digits = "".join(c for c in name if c.isdigit())
    return letter, int(digits) if digits and len(digits) < 3 else 1


def _place(name: str, *, falling: bool) -> float:
    letter, number = _letter(name)
    number = max(4 - number, 1) if falling else number
    return _PLACES.get(letter, 1.3) * (1 + 0.7 * (number - 1))


def _size(symbol: sp.Symbol) -> float:
    if isinstance(symbol, Sign):
        return 1.0
    letter, number = _letter(symbol.name)
    return _SIZES.get(letter, 1.0) * (1 - 0.12 * (number - 1) if number < 6 else 1)


def _angles(expressions: Iterable[sp.Expr]) -> Iterator[sp.Symbol]:
    """The symbols that are a term of the argument of a sine or cosine, up to a factor."""
    for e in expressions:
        for f in e.atoms(TrigonometricFunction):
            for term in sp.Add.make_args(f.args[0]):
                _, symbol = term.as_coeff_Mul()
                if symbol.is_Symbol:
                    yield symbol


def _expressions(configuration: Configuration, points: Sequence[Vector]) -> Iterator[sp.Expr]:
    for p in points:
        yield from p.components
    for r in configuration.rotations:
        for axis in r.axes:
            yield from axis.fixed().components
    for f in configuration.finite_constraints:
        yield sp.sympify(f, strict=True)
    for f in configuration.loads:
        yield from f.vector.fixed().components
        yield from f.point.fixed().components
    yield from (s.distance for s in configuration.springs)


def _in_order(pose: Pose) -> bool:
    """Whether springs on one line lead away from their supports, if the file leaves open in which sense they lie.

    From a support beyond the point at which the coordinate of its body begins, they lead back to that point.
    """
    configuration = pose.configuration
    on_line = [s for s in configuration.springs if s.distance.has(sp.Abs) and _is_on_line(pose, s)]
    for s in list(on_line):
        way = _from_beyond(pose, s)
        if way is not None:
            on_line.remove(s)
            if way < 0:
                return False
    held = [e for s in on_line for e in s.ends if isinstance(e, Vector)]
    depth: dict[str | Vector, int] = dict.fromkeys(held, 0)
    for _ in on_line:
        for s in on_line:
            for a, b in (s.ends, s.ends[::-1]):
                if a in depth:
                    depth.setdefault(b, depth[a] + 1)
    for s in on_line:
        first, second = s.ends
        if first in depth and second in depth and depth[first] != depth[second]:
            ahead = sum(pose.at(s.apart))
            if ahead * (depth[first] - depth[second]) < 0:
                return False
    return True


def _is_on_line(pose: Pose, spring: StretchedSpring) -> bool:
    """Whether a spring stays on one line: not one that turns, whose length |r| is a coordinate."""
    [length] = list(spring.distance.atoms(sp.Abs))[:1]
    ways = (sp.cancel(c / length.args[0]) for c in spring.apart.fixed().components)
    return not any(way.free_symbols & {*pose.coordinates, t} for way in ways)


def _from_beyond(pose: Pose, spring: StretchedSpring) -> float | None:
    """How far the support of a spring is ahead of its body; None if the coordinate of that begins at or after it."""
    places = {p.name: p.position for p in pose.configuration.points}
    for end, name in (spring.ends, spring.ends[::-1]):
        if isinstance(end, Vector) and isinstance(name, str) and _stays(pose, end):
            undriven = pose.with_zero((*pose.coordinates, *pose.configuration.slots.prescribed))
            if sum(minus(undriven.at(end), undriven.at(places[name]))) > SAME_PLACE:
                return float(sum(minus(pose.at(end), pose.at(places[name]))))
    return None


def stands_still(pose: Pose, place: Vector) -> bool:
    """Whether the constraints keep a place where it is: it is the same in all positions that are known."""
    places = [x.at(place) for x in (pose, *pose.others)]
    return all(math.dist(places[0], other) < SAME_PLACE for other in places)


def _stays(pose: Pose, place: Vector) -> bool:
    return not place.fixed().as_sum().free_symbols & {*pose.coordinates}


def _is_clear(pose: Pose) -> bool:
    """Whether a ball of radius r in a bowl of radius R is small: a difference R − r is seen as well as r."""
    lengths = {*pose.values} - {*pose.coordinates}
    for p in pose.configuration.points:
        for c in p.position.fixed().components:
            for difference in c.atoms(sp.Add):
                match difference.args:
                    case (a, b) if (less := -b if (-b).is_Symbol else -a) in lengths and difference + less in lengths:
                        if pose.number(difference) < 1.2 * pose.values[less]:
                            return False
    return True


def _is_between(pose: Pose) -> bool:
    """Whether what springs hold from several fixed places is in the middle of these."""
    places = {p.name: p.position for p in pose.configuration.points}
    ways: dict[str | Vector, list[FloatVector]] = {}
    for s in pose.configuration.springs:
        for held, other in (s.ends, s.ends[::-1]):
            if isinstance(held, Vector) and _stays(pose, held):
                at = pose.at(places[other] if isinstance(other, str) else other)
                ways.setdefault(other, []).append(minus(pose.at(held), at))
    return all(len(w) < 2 or any(inner(a, b) < 0 for a, b in combinations(w, 2)) for w in ways.values())


def _has_room(pose: Pose, problem: Problem) -> bool:
    """Whether springs end outside the wheels that they hold, and what hangs on a spring is below its other end."""
    if not _is_clear(pose):
        return False
    inertia = {r.name: r.inertia.moments[2] for r in pose.configuration.rotations}
    masses = {p.name: p.mass for p in pose.configuration.points}
    places = {p.name: p.position for p in pose.configuration.points}
    down = problem.gravity if re.search(r"\bhang", problem.description) else None
    if not _is_between(pose):
        return False
    for s in pose.configuration.links:
        first, second = (pose.at(places[e] if isinstance(e, str) else e) for e in s.ends)
        for e in s.ends:
            if isinstance(e, str) and inertia.get(e, 0) != 0 and masses[e] != 0:
                gyration = math.sqrt(abs(pose.number(inertia[e]) / pose.number(masses[e])))
                if math.dist(first, second) < 2.2 * gyration and not isinstance(s.ends[s.ends.index(e) - 1], str):
                    return False
        if down is not None and all(isinstance(e, str) for e in s.ends):
            way, along = minus(second, first), pose.at(down)
            if inner(way, along) < -0.99 * math.hypot(*way) * math.hypot(*along):
                return False
    return True


def _negative(pose: Pose, hanging: frozenset[sp.Symbol] = frozenset()) -> int:
    """The number of negative coordinates, or heights above O of what hangs: there are none if possible."""
    values = [-pose.values[q] if q in hanging else pose.values[q] for q in pose.coordinates]
    expressed = pose.configuration.expressed.items()
    return sum(v < 0 for v in (*values, *(pose.number(e) * (-1 if q in hanging else 1) for q, e in expressed)))


def _score(pose: Pose, points: Sequence[Vector], hanging: frozenset[sp.Symbol] = frozenset()) -> float | None:
    """A measure of legibility; None if different points coincide.

    Added up: the least distance of two points and the least slant, as parts of the size of the system (crowded points
    leave no room for labels, and a line that happens to be horizontal looks as if it had to be); a bonus for
    pictures that are not flat; and a penalty of 1 for each negative coordinate, which outweighs all the rest.
    """
    if any(pose.number(s.distance) < 0.2 for s in pose.configuration.springs):
        return None
    if not _in_order(pose):
        return None
    places = [pose.at(p) for p in points]
    shown = [*places, (0.0, 0.0, 0.0)]
    spans = [max(p[n] for p in shown) - min(p[n] for p in shown) for n in range(3)]
    size = math.hypot(*spans)
    if size < 1e-6:
        return 0.0
    nearest, slant = 0.35, 0.3
    for a, b in combinations(shown, 2):
        way = minus(a, b)
        distance = math.hypot(*way)
        if distance < 1e-9 and (0.0, 0.0, 0.0) in (a, b):
            continue  # a point may be at the origin
        nearest = min(nearest, distance / size)
        parts = [abs(c) / distance for c in way if c != 0]
        slant = min(slant, *parts) if len(parts) > 1 else slant
    if nearest < LEAST_GAP:
        return None
    used = sorted(s for s in spans if s > 1e-9)
    shape = used[0] / used[-1] if len(used) > 1 else 1.0
    return nearest + slant + 0.3 * min(shape, 0.7) - _negative(pose, hanging)


_STEPS = (0.7, -1.1, 2.3)  # changes at which a motion is compared with a circle or a line: no simple ratios


@record
class AngleMark:
    """An angle at `centre` from the direction `reference`, in which q = 0, to the point.

    arc  vectors from the centre, turning from the reference to the point
    """

    coordinate: sp.Symbol
    centre: FloatVector
    point: FloatVector
    arc: tuple[FloatVector, ...]

    @property
    def reference(self) -> FloatVector:
        """The direction from which the angle is counted."""
        return self.arc[0]


@record
class DistanceMark:
    """A distance from `start` to `end`."""

    coordinate: sp.Symbol
    start: FloatVector
    end: FloatVector


def angle_mark(pose: Pose, coordinate: sp.Symbol, position: Vector) -> AngleMark | None:
    """The angle that a coordinate is for a point; None if it is not an angle. Raises NoValueError."""
    point, opposite = pose.at(position), pose.moved(coordinate, math.pi).at(position)
    centre = plus(point, minus(opposite, point), 0.5)
    a = minus(point, centre)
    b = minus(pose.moved(coordinate, math.pi / 2).at(position), centre)
    if math.hypot(*a) < 1e-3 or abs(inner(a, a) - inner(b, b)) > SAME_PLACE or abs(inner(a, b)) > SAME_PLACE:
        return None

    def expected(step: float) -> FloatVector:
        return plus(plus(centre, a, math.cos(step)), b, math.sin(step))

    for step in _STEPS:
        if math.hypot(*minus(pose.moved(coordinate, step).at(position), expected(step))) > SAME_PLACE:
            return None
    q = pose.values[coordinate]
    if not 0.05 < abs(q) < math.pi:
        return None
    arc = tuple(minus(expected(-q + q * k / 20), centre) for k in range(21))
    return AngleMark(coordinate, centre, point, arc)


def circle_of(pose: Pose, coordinate: sp.Symbol, position: Vector) -> AngleMark | None:
    """The same where the angle is 0 as well, as that of a pendulum that strikes at its lowest point."""
    if abs(pose.values[coordinate]) > 0.05:
        return angle_mark(pose, coordinate, position)
    turned = angle_mark(pose.moved(coordinate, 0.3), coordinate, position)
    return None if turned is None else replace(turned, point=pose.at(position))


def relative_angle_mark(pose: Pose, coordinate: sp.Symbol, position: Vector, origin: Vector) -> AngleMark | None:
    """The angle that a coordinate is for the line from one moving point to another. Raises NoValueError."""
    mark = angle_mark(pose, coordinate, position.fixed() - origin.fixed())
    if mark is None or math.hypot(*mark.centre) > SAME_PLACE:
        return None
    centre = pose.at(origin)
    return AngleMark(coordinate, centre, plus(centre, mark.point), mark.arc)


def direction_mark(pose: Pose, coordinate: sp.Symbol, position: Vector, origin: Vector) -> AngleMark | None:
    """The angle that a coordinate is for a line whose length changes with it, as 2R cos θ. Raises NoValueError."""
    ways = [x.at(position.fixed() - origin.fixed()) for x in (pose, *(pose.moved(coordinate, s) for s in (0.2, -0.3)))]
    size, q = math.hypot(*ways[0]), pose.values[coordinate]
    if size < 1e-3 or any(w[2] != 0 for w in ways) or not 0.05 < abs(q) < math.pi:
        return None
    for sign in (1.0, -1.0):
        expected = [turned(ways[0], sign * s) for s in (0.2, -0.3)]
        if all(math.hypot(*outer(e, w)) < SAME_PLACE for e, w in zip(expected, ways[1:], strict=True)):
            arc = tuple(turned(ways[0], sign * q * (k / 20 - 1)) for k in range(21))
            centre = pose.at(origin)
            return AngleMark(coordinate, centre, plus(centre, ways[0]), arc)
    return None


def turned(way: FloatVector, by: float) -> FloatVector:
    """A vector in the plane, turned counterclockwise."""
    c, s = math.cos(by), math.sin(by)
    return c * way[0] - s * way[1], s * way[0] + c * way[1], 0.0


def is_distance(pose: Pose, coordinate: sp.Symbol, position: Vector) -> bool:
    """Whether a point moves on a straight line, by the change of a coordinate. Raises NoValueError."""
    start = pose.at(position)
    way = minus(pose.moved(coordinate, 1.0).at(position), start)
    if abs(math.hypot(*way) - 1) > SAME_PLACE:
        return False
    errors = (minus(pose.moved(coordinate, s).at(position), plus(start, way, s)) for s in _STEPS)
    return all(math.hypot(*e) < SAME_PLACE for e in errors)


def crosswise(marks: Sequence[DistanceMark]) -> list[DistanceMark]:
    """The first two steps of a way, each drawn from the axis of the other: so those of two points do not coincide."""
    if len(marks) < 2:
        return list(marks)
    first, second, *others = marks
    way = minus(second.end, second.start)
    moved = DistanceMark(first.coordinate, plus(first.start, way), plus(first.end, way))
    return [moved, second, *others]


def distance_marks(
    pose: Pose, coordinates: Sequence[sp.Symbol], position: Vector, known: Iterable[FloatVector] | None
) -> list[DistanceMark]:
    """The way to a point in steps, one for each of its distances; none if it does not begin at a `known` place.

    known  None for a way that begins wherever these coordinates are zero
    """
    distances = []
    for q in coordinates:
        try:
            if is_distance(pose, q, position) and abs(pose.values[q]) > 1e-3:
                distances.append(q)
        except NoValueError:
            continue
    if not distances:
        return []
    start = pose.with_zero(distances).at(position)
    on_axis = sum(abs(c) > SAME_PLACE for c in start) <= 1
    if known is not None and not on_axis and all(math.hypot(*minus(start, k)) > 1e-6 for k in known):
        return []
    marks = []
    for n, q in enumerate(distances):
        end = pose.with_zero(distances[n + 1 :]).at(position)
        marks.append(DistanceMark(q, start, end))
        start = end
    return marks
