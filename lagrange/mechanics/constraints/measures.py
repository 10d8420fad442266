"""What the coordinates of a choice measure: angles of lines between points, the position of the mass centre.

For two points with the difference d = r_B − r_A in the coordinates of the choice, q is an angle of d if

    d = |d| (cos q e_0 + sin q e_1)

with constant perpendicular unit vectors: e_0 is where d points at q = 0, e_1 where it points at q = π/2. In space the
angle from e_0 has an e_1 that depends on one more angle p, that of e_1 in the plane normal to e_0. Each equation is
decided as an identity.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import vanishes
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.vectors import FIXED, Vector
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.constraints.limits import MOST_MEASURED_POINTS


@record
class Angle:
    """The angle q of the line from `start` (empty: the fixed point O) to `end`.

    zero       the axis along which the line, or its projection, points at q = 0
    towards    where it turns as q grows; None for an angle from an axis in space
    projected  the axis on whose normal plane the line is projected; None if it lies in the plane itself
    """

    symbol: sp.Symbol
    start: str
    end: str
    zero: Vector
    towards: Vector | None
    projected: Vector | None = None


def angles(configuration: Configuration, symbols: Sequence[sp.Symbol]) -> tuple[Angle, ...]:
    """What the given coordinates measure, as far as they are angles of lines between points; each once."""
    written = [c for p in configuration.points[:MOST_MEASURED_POINTS] for c in p.position.fixed().components]
    waves = [w for c in written for w in c.atoms(sp.sin, sp.cos)]
    sought = [q for q in symbols if any(w.args[0] == q for w in waves)]
    measured: dict[sp.Symbol, Angle] = {}
    for start, end, d in _lines(configuration) if sought else ():
        for angle in _angles_of(d, start, end, sought):
            measured.setdefault(angle.symbol, angle)
        if len(measured) == len(sought):
            break
    return tuple(measured[q] for q in symbols if q in measured)


def of_mass_centre(configuration: Configuration, symbols: Sequence[sp.Symbol]) -> tuple[sp.Symbol, ...]:
    """The coordinates that are components of the mass centre of several particles."""
    points = [p for p in configuration.points if p.mass != 0]
    if len(points) < 2 or configuration.rotations:
        return ()
    total = sp.Add(*(p.mass for p in points))
    moment = sum((p.position.fixed() * p.mass for p in points), Vector.zero(FIXED))
    at = [(c, q) for c in moment.components for q in symbols if c.has(q)]
    return tuple(q for c, q in at if vanishes(c - total * q))


def _lines(configuration: Configuration) -> Iterator[tuple[str, str, Vector]]:
    """The lines between points: those along rods first."""
    points = configuration.points[:MOST_MEASURED_POINTS]
    slots = {*configuration.slots.coordinates}
    moving = [p for p in points if _depends(p.position, slots)]
    rigid: list[tuple[str, str, Vector]] = []
    others: list[tuple[str, str, Vector]] = []
    for n, p in enumerate(moving):
        for start in (None, *moving[:n]):
            d = _difference(p, start)
            line = ("" if start is None else start.name, p.name, d)
            (others if _depends(_square(d), slots) else rigid).append(line)
    yield from (*rigid, *others)


def _depends(value: Vector | sp.Expr, symbols: set[sp.Symbol]) -> bool:
    components = value.fixed().components if isinstance(value, Vector) else (value,)
    return any(not c.free_symbols.isdisjoint(symbols) for c in components)


def _difference(end: MassPoint, start: MassPoint | None) -> Vector:
    at = end.position.fixed()
    return (at if start is None else at - start.position.fixed()).map(textbook_form)


def _square(d: Vector) -> sp.Expr:
    return textbook_form(d.dot(d))


def _angles_of(d: Vector, start: str, end: str, symbols: Sequence[sp.Symbol]) -> Iterator[Angle]:
    for q in symbols:
        if not any(c.has(sp.sin(q), sp.cos(q)) for c in d.components):
            continue
        first, second = (_turned_to(d, q, at) for at in (sp.S.Zero, sp.pi / 2))
        turned = first * sp.cos(q) + second * sp.sin(q)
        if not all(vanishes(c) for c in (d - turned).components):
            continue
        zero, towards = _axis(first), _axis(second)
        if zero is not None and towards is not None:
            yield Angle(q, start, end, zero, towards)
        elif zero is not None and vanishes(_square(first) - _square(second)):
            yield Angle(q, start, end, zero, None)
            yield from (
                Angle(a.symbol, start, end, a.zero, a.towards, zero)
                for a in _angles_of(second, start, end, [p for p in symbols if p != q])
                if a.towards is not None and a.projected is None
            )


def _turned_to(d: Vector, q: sp.Symbol, value: sp.Expr) -> Vector:
    return d.map(lambda c: textbook_form(c.xreplace({q: value})))


def _axis(v: Vector) -> Vector | None:
    """i, j, k or one of them reversed, if a vector is along it by a factor of a known sign."""
    along = [(n, c) for n, c in enumerate(v.components) if c != 0]
    if len(along) != 1:
        return None
    [(n, c)] = along
    sign = 1 if c.is_positive else -1 if c.is_negative else 0
    units = tuple(sp.Integer(sign) if m == n else sp.S.Zero for m in range(3))
    return Vector(units, FIXED) if sign else None
