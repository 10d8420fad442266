"""A general position of a system, good to look at: numbers for parameters and coordinates.

Lengths are what their letters suggest (R above r, l about 2), angles neither small nor right, and the coordinates are
brought onto the constraints by Newton's iteration. Several such positions are tried; that one is taken in which points
are farthest apart and lines slant most. Where in none of them points that differ are apart, there is no picture.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import combinations
from random import Random

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.core.records import record
from lagrange.core.symbols import Sign, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.pictures.floats import NoValueError, Space, Values, minus, place, projected, value
from lagrange.problem.model import Problem

TRIALS = 48
APART = 0.13
"""Least distance of two points, as a part of the size of the whole."""
_SIZES = {"L": 4.0, "l": 2.0, "R": 2.0, "r": 0.8, "a": 1.1, "b": 0.9, "c": 0.7, "h": 1.2, "d": 0.6, "f": 0.8, "k": 0.4}
_PLACES = {"x": 1.5, "y": 1.1, "z": 1.2, "r": 1.8, "s": 1.4, "u": 1.6}
_ANGLES = (33, 58, 20, 72)


@record
class Pose:
    """Values of all symbols, and the relations that these satisfy."""

    configuration: Configuration
    values: Values

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """The coordinates."""
        return self.configuration.slots.coordinates

    def at(self, vector: Vector) -> Space:
        """Components along i, j, k. Raises NoValueError."""
        return place(vector, self.values)

    def number(self, expression: sp.Expr) -> float:
        """A value. Raises NoValueError."""
        return value(expression, self.values)

    def moved(self, coordinate: sp.Symbol, by: float) -> Pose:
        """With one coordinate changed, and the others as they are."""
        return replace(self, values={**self.values, coordinate: self.values[coordinate] + by})

    def with_zero(self, coordinates: Iterable[sp.Symbol]) -> Pose:
        """With some coordinates 0."""
        return replace(self, values={**self.values, **dict.fromkeys(coordinates, 0.0)})

    @cached_property
    def others(self) -> tuple[Pose, ...]:
        """A few other positions of the same system: what holds in all of them is no accident."""
        random = Random(1)
        slopes = _slopes(self.configuration)
        found = []
        for _ in range(12):
            start = dict(self.values) | {q: self.values[q] + random.uniform(-0.5, 0.5) for q in self.coordinates}
            try:
                values = projected(self.configuration.finite_constraints, slopes, self.coordinates, start)
            except NoValueError:
                continue
            found.append(replace(self, values=values))
        return tuple(found[:4])


def notable(configuration: Configuration) -> list[Vector]:
    """The particles, mass centres and ends of springs."""
    ends = (e for link in configuration.links for e in link.ends)
    points = [*(p.position for p in configuration.points), *(e for e in ends if isinstance(e, Vector))]
    return list(dict.fromkeys(points))


def general_pose(problem: Problem, configuration: Configuration, centres: Sequence[Vector] = ()) -> Pose | None:
    """A general position; None where none was found. `centres`: fixed ends of rods, points that count too."""
    points = [p.fixed() for p in dict.fromkeys((*notable(configuration), *centres))]
    slopes = _slopes(configuration)
    best: tuple[float, Pose] | None = None
    for trial in range(TRIALS):
        try:
            start = _guess(problem, configuration, points, trial)
            values = projected(configuration.finite_constraints, slopes, configuration.slots.coordinates, start)
            pose = Pose(configuration, values)
            score = _score(pose, points)
        except NoValueError:
            continue
        if score is not None and (best is None or score > best[0]):
            best = score, pose
    return best[1] if best else None


def _slopes(configuration: Configuration) -> list[list[sp.Expr]]:
    relations = configuration.finite_constraints
    return [[sp.sympify(f, strict=True).diff(q) for q in configuration.slots.coordinates] for f in relations]


def _guess(
    problem: Problem, configuration: Configuration, points: Sequence[Vector], trial: int
) -> dict[sp.Symbol, float]:
    angles = set(_angles([*_expressions(configuration, points)]))
    values: dict[sp.Symbol, float] = {t: 1.0}
    given = {p.symbol: float(p.value) for p in problem.parameters if p.value is not None}
    parameters = {p.symbol for p in problem.parameters}
    coordinates = configuration.slots.coordinates
    unknowns = set().union(*(e.free_symbols for e in _expressions(configuration, points))) if points else set()
    turns = iter(_ANGLES * (1 + len(coordinates)))
    random, spread = Random(trial), 0.3 if trial else 0.0
    for s in coordinates:
        wobble = 1 + random.uniform(-spread, spread)
        values[s] = (math.radians(next(turns)) if s in angles else _place(s.name, falling=trial % 4 == 3)) * wobble
    for s in configuration.slots.prescribed:
        values[s] = 0.6 if s in angles else 0.5
    for s in sorted(parameters | unknowns, key=str):
        wobble = 1 + random.uniform(-spread, spread)
        if s not in values:
            values[s] = given.get(s) or (0.55 * wobble if s in angles else _size(s) * wobble)
    return values


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
    """The symbols that stand by themselves in the argument of a sine or cosine."""
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
    """Whether springs on one line, of which the file does not say how they lie, lead away from what holds them."""
    configuration = pose.configuration
    on_line = [s for s in configuration.springs if s.distance.has(sp.Abs)]
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


def _negative(pose: Pose) -> int:
    """How many coordinates are negative: a drawing has them positive if it can."""
    values = [pose.values[q] for q in pose.coordinates]
    return sum(v < 0 for v in (*values, *(pose.number(e) for e in pose.configuration.expressed.values())))


def _score(pose: Pose, points: Sequence[Vector]) -> float | None:
    """How good it looks; None where points coincide that differ."""
    if any(pose.number(s.distance) < 0.2 for s in pose.configuration.springs):
        return None
    if not _in_order(pose):
        return None
    places = [pose.at(p) for p in points]
    seen = [*places, (0.0, 0.0, 0.0)]
    spans = [max(p[n] for p in seen) - min(p[n] for p in seen) for n in range(3)]
    whole = math.hypot(*spans)
    if whole < 1e-6:
        return 0.0
    nearest, slant = 0.35, 0.3
    for a, b in combinations(seen, 2):
        way = minus(a, b)
        distance = math.hypot(*way)
        if distance < 1e-9 and (0.0, 0.0, 0.0) in (a, b):
            continue  # at the origin, as any point may be
        nearest = min(nearest, distance / whole)
        parts = [abs(c) / distance for c in way if c != 0]
        slant = min(slant, *parts) if len(parts) > 1 else slant
    if nearest < APART:
        return None
    used = sorted(s for s in spans if s > 1e-9)
    shape = used[0] / used[-1] if len(used) > 1 else 1.0
    return nearest + slant + 0.3 * min(shape, 0.7) - _negative(pose)
