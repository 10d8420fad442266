"""Which of the applied forces have a potential.

A constant force has −F·r. Of the others, the part that does not depend on velocities or time has a potential where
∂Q_i/∂q_k = ∂Q_k/∂q_i, and where the table of integrals has it: a magnetic force is left over from an electric one.
Friction has none, even where it is constant; a constant moment has none with one value at each position.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from lagrange.algebra.forms.potentials import primitive
from lagrange.algebra.fourier.trigonometry import Element, Ring
from lagrange.core.symbols import base, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, Load


def are_true_coordinates(configuration: Configuration) -> bool:
    """Whether H·(ω_k' − ∂ω/∂q_k) = 0 of bodies of which the file gives ω, components along the axes differentiated.

    Otherwise coordinates are quasi-coordinates, for which Lagrange's equations do not hold.
    """
    slots = configuration.slots
    for r in configuration.rotations:
        if not r.given:
            continue
        spin = r.angular_velocity.fixed()
        along = [spin.dot(e) for e in r.axes]
        for q, v in zip(slots.coordinates, slots.velocities, strict=True):
            part = spin.map(lambda c, v=v: c.diff(v)).time_derivative(slots)  # type: ignore[misc]
            bending = (a * w * (part.dot(e) - w.diff(q)) for a, w, e in zip(r.inertia, along, r.axes, strict=True))
            if configuration.states.is_zero(sp.Add(*bending)) is not True:
                return False
    return True


def is_constant_force(load: Load, configuration: Configuration) -> bool:
    """Whether a force is constant, and acts at a point whose displacement is that of a position."""
    moving = {*configuration.slots.coordinates, *configuration.slots.prescribed, t}
    if any(base(s) in moving for c in load.vector.fixed().components for s in c.free_symbols):
        return False
    turning = next((r for r in configuration.rotations if r.name == load.on), None)
    if turning is None or not turning.given:
        return True
    [centre] = (p.position for p in configuration.points if p.name == load.on)
    return (load.point - centre).is_zero


def of_the_rest(
    configuration: Configuration, loads: Sequence[Load], frictions: Collection[str], ring: Ring
) -> tuple[sp.Expr, tuple[Element, ...], bool]:
    """The potential of the loads that have one because they depend on the position only, and Q'_k of the rest.

    Last, whether something of the rest has a potential that was not found. A constant moment has none that has one
    value at each position.
    """
    coordinates = configuration.slots.coordinates
    n = len(coordinates)
    each = [_generalized(load, configuration, ring) for load in loads if load.name not in frictions]
    left = [_generalized(load, configuration, ring) for load in loads if load.name in frictions]
    for moment in configuration.torques:
        [turning] = (r for r in configuration.rotations if r.name == moment.on)
        q = tuple(dot(moment.vector, partial, ring) for partial in turning.partials)
        steady = all(ring.free_symbols(f).isdisjoint(coordinates) for f in q)
        (left if steady else each).append(q)
    found, hidden = sp.S.Zero, False
    waiting: list[tuple[Element, ...]] = []
    for q in each:
        static, rest = _apart(q, configuration, ring)
        left.append(rest)
        v = _potential(static, configuration, ring)
        if v is None:
            waiting.append(static)
        else:
            found += v
    together = _sum(waiting, n, ring)
    if waiting and _is_closed(together, configuration, ring):
        v = _potential(together, configuration, ring)
        found, hidden = (found, True) if v is None else (found + v, False)
        left += [together] if v is None else []
    else:
        left.append(together)
    left += [
        tuple(-(ring.from_sympy(d.pull) * ring.from_sympy(d.distance.diff(q))) for q in coordinates)
        for d in configuration.dampers
    ]
    return found, _sum(left, n, ring), hidden


def _apart(
    forces: tuple[Element, ...], configuration: Configuration, ring: Ring
) -> tuple[tuple[Element, ...], tuple[Element, ...]]:
    """What does not depend on velocities or time, and the rest."""
    slots = configuration.slots
    static = []
    for f in forces:
        kept = ring.zero
        for part in f.by_monomial().values():
            symbols = ring.free_symbols(part)
            if all(s != t and base(s) == s and s not in slots.prescribed for s in symbols):
                kept = kept + part
        static.append(kept)
    return tuple(static), tuple(f - k for f, k in zip(forces, static, strict=True))


def _sum(parts: list[tuple[Element, ...]], size: int, ring: Ring) -> tuple[Element, ...]:
    return tuple(ring.total(p[k] for p in parts) for k in range(size))


def _generalized(load: Load, configuration: Configuration, ring: Ring) -> tuple[Element, ...]:
    """F·∂r/∂q_k, and on a body F·∂r_G/∂q_k + (arm × F)·ω_k, shape (n,)."""
    coordinates = configuration.slots.coordinates
    turning = next((r for r in configuration.rotations if r.name == load.on), None)
    if turning is None:
        return tuple(dot(load.vector, load.point.partial(q), ring) for q in coordinates)
    [centre] = (p for p in configuration.points if p.name == load.on)
    moment = (load.point - centre.position).cross(load.vector)
    return tuple(
        dot(load.vector, centre.partials[k], ring) + dot(moment, turning.partials[k], ring)
        for k in range(len(coordinates))
    )


def _is_closed(forces: tuple[Element, ...], configuration: Configuration, ring: Ring) -> bool:
    """Whether ∂Q_i/∂q_k = ∂Q_k/∂q_i, Q being functions of the position that can be differentiated."""
    if any(f.to_sympy().has(sp.sign, sp.Abs) for f in forces):
        return False
    if any(forces) and not are_true_coordinates(configuration):
        return False
    coordinates = configuration.slots.coordinates
    return all(
        ring.is_zero(ring.partial(b)(forces[k]) - ring.partial(a)(forces[n]))
        for k, a in enumerate(coordinates)
        for n, b in enumerate(coordinates[:k])
    )


def _potential(forces: tuple[Element, ...], configuration: Configuration, ring: Ring) -> sp.Expr | None:
    """V with −∂V/∂q_k = Q_k; None where the Q_k are no gradient, or none that is found."""
    if not any(forces):
        return sp.S.Zero
    if not _is_closed(forces, configuration, ring):
        return None
    slots = configuration.slots
    return primitive([-f.to_sympy() for f in forces], slots.coordinates, slots)


def dot(a: Vector, b: Vector, ring: Ring) -> Element:
    """a·b in the ring, in the triad of b."""
    a = a.along(b.triad)
    return ring.dot([ring.from_sympy(c) for c in a.components], [ring.from_sympy(c) for c in b.components])
