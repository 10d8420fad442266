"""The links of plane mechanisms whose file gives no shapes: cranks, couplers, rockers, connecting rods.

A chain that closes, a e₁ + b e₂ = d i + c e₃, contains each link as the vector which its angle turns: its derivative
by that angle is k × link. A link begins where the mass centre would be without the part that turns with it, and ends
where another one begins or ends; if it meets none, nothing is drawn.

A rod from a particle P to a point Q of a body keeps |P − Q| = l. In the axes of the body P − r_B = p and Q − r_B = q
are numbers, and p·p − 2 p·q + (q·q − l²) = 0 is linear in q and the bracket: three positions give them, others confirm
them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import product

import sympy as sp

from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.pictures.floats import FloatVector, NoValueError, minus, plus, solved
from lagrange.pictures.limits import SAME_ON_PAGE, SAME_PLACE
from lagrange.pictures.poses import Pose
from lagrange.pictures.shapes import coordinates_in_body, in_space, plane_rotation
from lagrange.pictures.systems import ROD, SystemPicture
from lagrange.problem.keys import Keeper


@record
class Links:
    """What joins the parts of a mechanism.

    held  by body: the places at which links make it reach further than its mass centre
    rods  from particle to body
    """

    held: Mapping[str, tuple[FloatVector, ...]]
    rods: tuple[tuple[FloatVector, FloatVector], ...]


def links(system: SystemPicture) -> Links:
    """The links of a plane mechanism."""
    if not (system.is_bare and system.view.planar and system.view.shown == (0, 1)):
        return Links({}, ())
    held: dict[str, tuple[FloatVector, ...]] = {}
    for name, place in (*_chain(system), *((n, q) for n, q, _ in _rods(system))):
        held[name] = (*held.get(name, ()), place)
    return Links(held, tuple((q, p) for _, q, p in _rods(system)))


def parameter_of(system: SystemPicture, size: float) -> sp.Symbol | None:
    """The only parameter with this value."""
    values = {s.symbol: system.pose.values.get(s.symbol) for s in system.problem.parameters}
    equal = [s for s, v in values.items() if v is not None and abs(v - size) < SAME_PLACE]
    return equal[0] if len(equal) == 1 else None


def _turning(system: SystemPicture) -> Iterator[tuple[MassPoint, Rotation, sp.Symbol]]:
    """The plane bodies with one angle, which nothing else has."""
    for p in system.configuration.points:
        rotation = plane_rotation(system.configuration, p.name)
        if rotation is not None:
            angles = rotation.axes[0].fixed().as_sum().free_symbols & {*system.pose.coordinates}
            if len(angles) == 1:
                yield p, rotation, next(iter(angles))


# Chains


def _chain(system: SystemPicture) -> Iterator[tuple[str, FloatVector]]:
    """The ends of the links of closed chains, by body."""
    coordinates = system.configuration.slots.coordinates
    rows = [r for r in system.configuration.rows if r.finite is not None and len(r.coefficients) == len(coordinates)]
    by_name = {r.name: r for r in rows}
    for first in (r for r in rows if r.name.endswith(".1")):
        second = by_name.get(f"{first.name[:-2]}.2")
        if second is None:
            continue
        found: dict[str, tuple[FloatVector, FloatVector]] = {}
        for p, rotation, q in _turning(system):
            n = coordinates.index(q)
            try:
                rate = system.pose.number(first.coefficients[n]), system.pose.number(second.coefficients[n])
                own = system.pose.at(p.position.fixed().partial(q))
                turn = _sense(system.pose, rotation, q)
            except NoValueError:
                continue
            if math.hypot(*rate) > SAME_PLACE and abs(turn) > SAME_PLACE:
                start = minus(system.pose.at(p.position), (own[1] / turn, -own[0] / turn, 0.0))
                found[p.name] = start, (rate[1] / turn, -rate[0] / turn, 0.0)
        yield from _joined(found)


def _sense(pose: Pose, rotation: Rotation, q: sp.Symbol) -> float:
    """How fast a body turns with its angle: 1, or −1 where that counts clockwise."""
    e1, rate = pose.at(rotation.axes[0]), pose.at(rotation.axes[0].fixed().partial(q))
    return e1[0] * rate[1] - e1[1] * rate[0]


def _joined(found: Mapping[str, tuple[FloatVector, FloatVector]]) -> Iterator[tuple[str, FloatVector]]:
    """Start and end of each link whose end is that of another one, or the start of it."""
    ends = {name: [plus(start, link, sign) for sign in (1.0, -1.0)] for name, (start, link) in found.items()}
    for name, (start, _) in found.items():
        others = [o for o in found if o != name]
        met = [place for o in others for place in (found[o][0], *ends[o])]
        fitting = [e for e in ends[name] if any(math.dist(e, m) < SAME_PLACE for m in met)]
        if len(fitting) == 1:
            yield name, start
            yield name, fitting[0]


# Rods


def _rods(system: SystemPicture) -> list[tuple[str, FloatVector, FloatVector]]:
    """The rods between bodies and particles: the body, the place on it, and that of the particle."""
    turning = [*_turning(system)]
    names = {p.name for p, _, _ in turning}
    free = [p for p in system.configuration.points if p.name not in names]
    found = []
    for reaction, (body, rotation, q), p in product(system.newton.reactions, turning, free):
        finite = reaction.row.finite
        if finite is None or reaction.rod is not None or not _may_be_rod(system, reaction):
            continue
        used = sp.sympify(finite, strict=True).free_symbols
        own = p.position.fixed().as_sum().free_symbols & {*system.pose.coordinates}
        if q not in used or not own or not own <= used:
            continue
        try:
            place = _end_on_body(system.pose, p, body, rotation)
        except NoValueError:
            continue
        at = system.pose.at(p.position)
        # A constant distance may be a coincidence, as r/2 in x = r cos φ, unless the file speaks of it.
        said = reaction.constraint.by is Keeper.ROD
        if place is not None and (said or parameter_of(system, math.dist(place, at)) is not None):
            found.append((body.name, place, at))
    return found


def _may_be_rod(system: SystemPicture, reaction: Reaction) -> bool:
    if reaction.constraint.by is not None:
        return reaction.constraint.by is Keeper.ROD
    return bool(ROD.search(system.text))


def _end_on_body(pose: Pose, p: MassPoint, body: MassPoint, rotation: Rotation) -> FloatVector | None:
    """The point of a body from which a particle has a constant distance, on the constraints and not off them."""

    def relative(x: Pose) -> tuple[float, float]:
        return coordinates_in_body(x, rotation, body.position, x.at(p.position))

    seen = [relative(x) for x in (pose, *pose.others)]
    if len(seen) < 5:
        return None
    rows = [(-2 * a, -2 * b, 1.0) for a, b in seen]
    sums = [-(a * a + b * b) for a, b in seen]
    u, v, rest = solved(rows[:3], sums[:3])

    def kept(at: tuple[float, float]) -> float:
        return (at[0] - u) ** 2 + (at[1] - v) ** 2 - (u * u + v * v - rest)

    if u * u + v * v - rest < SAME_ON_PAGE or any(abs(kept(at)) > SAME_ON_PAGE for at in seen):
        return None
    off = [relative(pose.moved(q, 0.37)) for q in pose.coordinates]
    if all(abs(kept(at)) < SAME_ON_PAGE for at in off):
        return None  # no constraint keeps it
    return plus(pose.at(body.position), in_space(pose, rotation, (u, v)))
