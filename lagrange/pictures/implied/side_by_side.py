"""Constants that mechanics does not need and a picture does: strings side by side, weights below their pulley.

A file may put the two ends of a string on one line, one above the other, since the distance between them does not
matter; on the page a pulley needs it. It may also count the descents of two weights, y₁ = R φ and y₂ = −R φ, from the
level of the pulley's axle; so one of them would be above it. Both are shifted by constants, weights with their loads.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.newton import Reaction

DROP = sp.Rational(13, 5)
"""How far weights hang below the axle where their coordinates are 0; the lengths of a picture are about 2."""


def beside(configuration: Configuration, strings: tuple[Reaction, ...], down: Vector | None = None) -> Configuration:
    """The ends of each string side by side, and weights on both sides of a pulley below it.

    down  the direction of gravity, where the text has strings
    """
    for reaction in strings:
        shifts = _apart(configuration, reaction)
        if shifts:
            return shifted(configuration, shifts)
    hung = [pair for reaction in strings if (pair := _on_pulley(configuration, reaction)) is not None]
    pulleys = [pulley for _, pulley, _ in hung]
    if not hung and down is not None:
        return shifted(configuration, {name: way * DROP for name, way in _off_rims(configuration, down)})
    return shifted(configuration, {name: way * DROP for name, pulley, way in hung if pulleys.count(pulley) > 1})


def shifted(configuration: Configuration, shifts: Mapping[str, Vector]) -> Configuration:
    """The configuration with its points and their loads moved by constants."""
    if not shifts:
        return configuration
    zero = Vector.zero()
    moved = tuple(replace(p, position=p.position.fixed() + shifts.get(p.name, zero)) for p in configuration.points)
    loads = tuple(replace(f, point=f.point.fixed() + shifts.get(f.on, zero)) for f in configuration.loads)
    return replace(configuration, points=moved, loads=loads)


def _used(configuration: Configuration, reaction: Reaction) -> list[sp.Symbol]:
    """The coordinates that a constraint binds, as far as it is written in those of the configuration."""
    coordinates = configuration.slots.coordinates
    if len(reaction.row.coefficients) != len(coordinates):
        return []
    return [q for q, a in zip(coordinates, reaction.row.coefficients, strict=True) if a != 0]


def _apart(configuration: Configuration, reaction: Reaction) -> dict[str, Vector]:
    """Opposite shifts of what hangs on the two parts of a string, if all points are on one line."""
    used, points = _used(configuration, reaction), configuration.points
    if len(used) != 2 or configuration.rotations:
        return {}
    lines = {n for p in points for n, c in enumerate(p.position.fixed().components) if c != 0}
    parts = [p.position.fixed().as_sum().free_symbols & {*used} for p in points]
    if len(lines) != 1 or any(len(part) != 1 for part in parts) or len({*(next(iter(p)) for p in parts)}) != 2:
        return {}
    [along] = lines
    way = Vector(tuple(sp.Integer(n == (1 if along == 0 else 0)) for n in range(3)))
    first = next(iter(parts[0]))
    return {p.name: way * sp.Rational(-1 if first in part else 1, 4) for p, part in zip(points, parts, strict=True)}


def _on_pulley(configuration: Configuration, reaction: Reaction) -> tuple[str, str, Vector] | None:
    """The weight and the pulley with a fixed centre that a string y = R φ joins, and the direction in which y grows."""
    used = _used(configuration, reaction)
    moving = {*configuration.slots.coordinates}
    if len(used) != 2:
        return None
    places = {p.name: p.position.fixed() for p in configuration.points}
    turning = {
        r.name: angle
        for r in configuration.rotations
        for angle in r.axes[0].fixed().as_sum().free_symbols & {*used}
        if r.name in places and not places[r.name].as_sum().free_symbols & moving
    }
    for name, place in places.items() if len(turning) == 1 else ():
        [(pulley, angle)] = turning.items()
        [other] = {*used} - {angle}
        way = place.partial(other)
        if name != pulley and not way.is_zero and not way.as_sum().free_symbols & moving and not _beside(place, way):
            return name, pulley, way
    return None


def _off_rims(configuration: Configuration, down: Vector) -> Iterator[tuple[str, Vector]]:
    """The weights that the angle of a pulley with a fixed centre moves up and down by R φ, at R from its axis."""
    coordinates, field = {*configuration.slots.coordinates}, down.fixed()
    places = {p.name: p.position.fixed() for p in configuration.points}
    size = sp.sqrt(field.dot(field))
    for r in configuration.rotations:
        angles = r.axes[0].fixed().as_sum().free_symbols & coordinates
        if len(angles) != 1 or places[r.name].as_sum().free_symbols & coordinates:
            continue
        [q] = angles
        for name in places.keys() - {r.name}:
            way, start = places[name].partial(q), at_zero(places[name] - places[r.name], q)
            along = way.dot(field) / size
            rim = sp.expand(start.dot(start) - way.dot(way))
            upright = sp.expand(along**2 - way.dot(way)) == 0
            if along != 0 and rim == 0 and upright and start.dot(field) == 0 and not way.as_sum().has(q):
                yield name, field * (1 / size)


def _beside(place: Vector, way: Vector) -> bool:
    """Whether a place would be on the line through the centre: then it is no weight at the rim."""
    return all(sum(1 for _ in _components(v)) <= 1 for v in (place, way)) and [*_components(place)] == [
        *_components(way)
    ]


def _components(vector: Vector) -> Iterator[int]:
    return (n for n, c in enumerate(vector.fixed().components) if c != 0)


def at_zero(v: Vector, q: sp.Symbol) -> Vector:
    """A vector where a coordinate is zero."""
    return v.map(lambda c: c.subs(q, 0))
