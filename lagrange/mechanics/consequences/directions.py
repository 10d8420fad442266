"""A direction that stays, and motions whose velocity changes in a way that the position does not enter.

*A ratio of velocities.* d/dt (y'/x') = (x' y'' − y' x'')/x'². If that vanishes, the velocity keeps its direction in the
plane of x and y, although neither velocity need be constant.

*The hodograph.* Where x'' and y'' depend on the velocities only, x' = v cos ψ and y' = v sin ψ give
v ψ' = y'' cos ψ − x'' sin ψ, and with u = x' an equation between u and ψ alone, du/dψ = x''/ψ'. For a drag D(v)
against the velocity and a constant gravity it is m g du = v D(v) dψ (Johann Bernoulli 1719).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import differential, prime, t
from lagrange.mechanics.consequences.along import is_short, vanish_along
from lagrange.mechanics.consequences.limits import LONGEST_CONSEQUENCE
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.results import InCoordinates


def kept_directions(view: InCoordinates) -> Iterator[tuple[sp.Symbol, sp.Symbol]]:
    """Pairs of coordinates x, y of one point along fixed unit vectors, with y'/x' = const although x'' ≠ 0.

    None where the constraints are finite relations: a straight guide keeps the direction of what runs along it.
    """
    motion = view.motion
    if motion is None or not is_short(motion) or any(r.finite is not None for r in view.configuration.rows):
        return
    slots = view.configuration.slots
    rates = dict(zip(slots.coordinates, zip(slots.velocities, slots.accelerations, strict=True), strict=True))
    for point in view.configuration.points:
        own = [q for q in point.position.fixed().components if q in rates]
        for x, y in combinations(own, 2):
            (v, a), (w, b) = rates[x], rates[y]
            # Uniform motion is a straight line, and no result.
            if (
                vanish_along(motion, [v * b - w * a])
                and not vanish_along(motion, [a])
                and not vanish_along(motion, [b])
            ):
                yield x, y


@record
class Hodograph:
    """du/dψ for the velocity u = x' of a point that moves in the plane of x and y.

    speed, angle, ahead  v, ψ and u
    turning  v ψ'
    sides    the two sides of the equation between du and dψ, without denominators
    """

    first: sp.Symbol
    second: sp.Symbol
    speed: sp.Symbol
    angle: sp.Symbol
    ahead: sp.Symbol
    turning: sp.Expr
    sides: tuple[sp.Expr, sp.Expr]


def hodograph(view: InCoordinates, letters: tuple[str, str, str]) -> Hodograph | None:
    """The equation between u and ψ, where it is short and the equations of motion are not linear in the velocities.

    letters  the names for v, ψ and u
    """
    motion, slots = view.motion, view.configuration.slots
    if motion is None or view.configuration.rows or len(slots.coordinates) != 2 or len(view.configuration.points) != 1:
        return None
    pair = _in_a_plane(view.configuration.points[0], slots.coordinates)
    accelerations = None if pair is None else _accelerations(view)
    if pair is None or accelerations is None:
        return None
    rates = [slots.velocities[slots.coordinates.index(q)] for q in pair]
    if all(is_zero(a.diff(v, w)) is True for a in accelerations.values() for v in rates for w in rates):
        return None
    v, u = sp.Symbol(letters[0], positive=True), sp.Symbol(letters[2], real=True)
    psi = sp.Symbol(letters[1], real=True)
    size = sp.sqrt(rates[0] ** 2 + rates[1] ** 2)
    components = dict(zip(rates, (v * sp.cos(psi), v * sp.sin(psi)), strict=True))
    a, b = (accelerations[prime(q, 2)].xreplace({size: v, 1 / size: 1 / v}).xreplace(components) for q in pair)
    turning = textbook_form(sp.expand(b * sp.cos(psi) - a * sp.sin(psi)))
    if is_zero(a) is not False or is_zero(turning) is not False:
        return None
    numerator, denominator = sp.fraction(sp.cancel(sp.together(v * a / turning)))
    sides = (denominator * differential(u), numerator * differential(psi))
    if any(isinstance(s, sp.Add) or count_operations(s) > LONGEST_CONSEQUENCE for s in (numerator, denominator)):
        return None
    return Hodograph(*pair, v, psi, u, turning, sides)


def _in_a_plane(point: MassPoint, coordinates: tuple[sp.Symbol, ...]) -> tuple[sp.Symbol, sp.Symbol] | None:
    """The coordinates of a point along two fixed unit vectors, in the order of these."""
    components = [c for c in point.position.fixed().components if c != 0]
    if {*components} != {*coordinates} or len(components) != 2:
        return None
    first, second = components
    assert isinstance(first, sp.Symbol)
    assert isinstance(second, sp.Symbol)
    return first, second


def _accelerations(view: InCoordinates) -> dict[sp.Symbol, sp.Expr] | None:
    """The accelerations, where each stands alone in an equation, and neither position nor time occurs."""
    assert view.motion is not None
    slots = view.configuration.slots
    solved = {}
    for e in view.motion.final:
        own = [a for a in slots.accelerations if e.expression.has(a)]
        if len(own) != 1 or e.expression.free_symbols & {*slots.coordinates, t}:
            return None
        factor = e.expression.diff(own[0])
        if factor.free_symbols & {*slots.velocities, *slots.accelerations}:
            return None
        solved[own[0]] = sp.expand(-e.expression.xreplace({own[0]: sp.S.Zero}) / factor)
    return solved if len(solved) == 2 else None
