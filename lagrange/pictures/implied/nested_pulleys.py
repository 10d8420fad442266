"""A pulley that hangs on a string, and carries another: Atwood's double machine.

    x + z = L ,     y₁ + y₂ − 2z = l

say that one string runs from the weight at x over a fixed pulley to the axle of a second one at z, and that the string
over this one carries the weights at y₁ and y₂. The file may give all of them one line; here they hang side by side.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.pictures.implied.side_by_side import shifted

_DEPTHS = (2.6, 1.5, 2.5, 3.2)
"""How deep the weight, the moving pulley and its two weights hang below the level from which they are counted."""
_PLACES = (sp.Rational(-4, 5), sp.Rational(2, 5), sp.Rational(6, 5))
"""How far beside each other the weights hang."""


@record
class NestedPulleys:
    """The coordinates of the weight on the first string, of the moving pulley, and of the weights on the second."""

    weight: sp.Symbol
    pulley: sp.Symbol
    first: sp.Symbol
    second: sp.Symbol

    @property
    def held(self) -> tuple[sp.Symbol, ...]:
        """The coordinates of weights."""
        return self.weight, self.first, self.second

    def values(self, configuration: Configuration, down: Vector) -> dict[sp.Symbol, float]:
        """The coordinates where everything hangs as in a drawing of the machine; nothing if they grow upwards."""
        field = down.fixed()
        points = [_held(configuration, q) for q in self.held]
        ways = [p.position.fixed().partial(q).dot(field) for p, q in zip(points, self.held, strict=True) if p]
        signs = (
            {sp.sign(w) for w in ways} if all(w.is_number or w.is_positive or w.is_negative for w in ways) else set()
        )
        names = (self.weight, self.pulley, self.first, self.second)
        return dict(zip(names, _DEPTHS, strict=True)) if signs == {sp.S.One} else {}


def nested_pulleys(configuration: Configuration, strings: Sequence[Reaction]) -> NestedPulleys | None:
    """The machine, if two strings make one of three weights and a pulley without mass."""
    coordinates = configuration.slots.coordinates
    rows = [r.row.coefficients for r in strings if len(r.row.coefficients) == len(coordinates)]
    used = [{q: a for q, a in zip(coordinates, row, strict=True) if a != 0} for row in rows]
    outer = next((u for u in used if len(u) == 2 and len({*u.values()}) == 1), None)
    inner = next((u for u in used if len(u) == 3), None)
    if outer is None or inner is None or len(used) != 2 or configuration.rotations or len(configuration.points) != 3:
        return None
    ends, twice = [q for q in inner if q not in outer], [q for q in inner if q in outer]
    if len(ends) != 2 or any(2 * inner[q] + inner[twice[0]] != 0 for q in ends) or _points(configuration, twice[0]):
        return None
    [weight] = {*outer} - {*twice}
    machine = NestedPulleys(weight, twice[0], *ends)
    return machine if all(_held(configuration, q) is not None for q in machine.held) else None


def hung_side_by_side(configuration: Configuration, machine: NestedPulleys) -> Configuration:
    """The configuration with its weights beside each other, if they are on one line."""
    lines = {n for p in configuration.points for n, c in enumerate(p.position.fixed().components) if c != 0}
    if len(lines) != 1:
        return configuration
    [along] = lines
    way = Vector(tuple(sp.Integer(n == (1 if along == 0 else 0)) for n in range(3)))
    held = zip((_held(configuration, q) for q in machine.held), _PLACES, strict=True)
    return shifted(configuration, {p.name: way * x for p, x in held if p is not None})


def _points(configuration: Configuration, q: sp.Symbol) -> list[MassPoint]:
    return [p for p in configuration.points if not p.position.fixed().partial(q).is_zero]


def _held(configuration: Configuration, q: sp.Symbol) -> MassPoint | None:
    """The only point that a coordinate moves, straight and by itself."""
    points = _points(configuration, q)
    if len(points) != 1:
        return None
    place = points[0].position.fixed()
    return points[0] if place.as_sum().free_symbols & {*configuration.slots.coordinates} == {q} else None
