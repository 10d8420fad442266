"""Lagrange's equations, the second route to the equations of motion.

    d/dt ∂T/∂q_k' − ∂T/∂q_k = Q_k + Σ_j λ_j a_jk ,      T = Σ m v·v / 2 + Σ ω·J ω / 2

Nothing here is taken from d'Alembert's principle: velocities come from positions in i, j, k, angular velocities from
the axes of the body, ω_1 = e_2'·e_3, and dH/dt is not needed. Constant forces enter by their potential −F·r, the others
by Q_k = Σ F·∂v/∂q_k' + M·∂ω/∂q_k', springs by the vector between their ends, dampers by −∂/∂q_k' of c d'²/2.

If the file gives ω, it may be in quasi-coordinates. Then T is not a function of coordinates alone, and

    dH/dt·ω_k = d/dt (H·ω_k) − H·ω_k'

replaces Lagrange's expression: the two differ by H·(ω_k' − ∂ω/∂q_k), components differentiated (Boltzmann, Hamel).

A constraint on velocities is never substituted into T before differentiating: T must contain every velocity that the
constraint excludes, or ∂T/∂q' loses the terms that its reaction balances.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.effort import kept_result
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, partial, t
from lagrange.core.vectors import Components, Vector
from lagrange.mechanics.constraints.kinematics import Configuration, Load, MassPoint, Torque
from lagrange.mechanics.constraints.springs_dampers import DamperForce, StretchedSpring

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.rigid_bodies import Rotation


@record
class Lagrangian:
    """Lagrange's equations of a configuration.

    kinetic    T
    potential  V of the constant forces and of the given potentials
    left       shape (n,): d/dt ∂T/∂q_k' − ∂T/∂q_k − Q_k, which equals Σ_j λ_j a_jk
    """

    kinetic: sp.Expr
    potential: sp.Expr
    left: tuple[sp.Expr, ...]


@kept_result
def lagrange_equations(configuration: Configuration) -> Lagrangian:
    """T, V and the left sides of Lagrange's equations."""
    slots = configuration.slots
    kinetic = kinetic_energy(configuration)
    constant = [f for f in configuration.loads if is_constant(f, configuration)]
    varying = [f for f in configuration.loads if f not in constant]
    fields = configuration.potential - sp.Add(*(s.energy for s in configuration.springs))
    potential = fields - sp.Add(*(f.vector.fixed().dot(f.point.fixed()) for f in constant))
    X = configuration.velocity_part
    rate = slots.time_derivation()
    left = []
    for k, (q, v) in enumerate(zip(slots.coordinates, slots.velocities, strict=True)):
        force = sp.Add(*(share_of_load(f, v, configuration) for f in varying)) - partial(potential, q)
        force += share_of_moments(configuration, v)
        force += sp.Add(*(share_of_spring(s, q) for s in configuration.springs))
        force += sp.Add(*(share_of_damper(d, v, slots) for d in configuration.dampers))
        force += configuration.generalized[k] if configuration.generalized else 0
        force += configuration.mass_terms[k] if configuration.mass_terms else 0
        force += partial(X, q) - rate(partial(X, v))
        quasi = sp.Add(*(quasi_term(r, q, v, slots) for r in configuration.rotations if r.given))
        left.append(rate(partial(kinetic, v)) - partial(kinetic, q) - force - quasi)
    return Lagrangian(kinetic, potential, tuple(left))


@kept_result
def kinetic_energy(configuration: Configuration) -> sp.Expr:
    """T, with v from the position in i, j, k, and ω from the axes of the body."""
    slots = configuration.slots
    terms = []
    for p in configuration.points:
        velocity = velocity_of(p, slots)
        terms.append(p.mass * velocity.dot(velocity) / 2)
    for r in configuration.rotations:
        terms.append(r.inertia.energy(spin_along_axes(r, slots)))
    return sp.Add(*terms)


def velocity_of(point: MassPoint, slots: Slots) -> Vector:
    """v of a particle or mass centre, from its position in i, j, k."""
    return point.position.fixed().time_derivative(slots)


def spin_along_axes(rotation: Rotation, slots: Slots) -> Components:
    """The components of ω along the axes of the body."""
    e1, e2, e3 = rotation.axes
    if rotation.given:
        spin = rotation.angular_velocity.fixed()
        return spin.dot(e1), spin.dot(e2), spin.dot(e3)
    d1, d2, d3 = (e.time_derivative(slots) for e in rotation.axes)
    return d2.dot(e3), d3.dot(e1), d1.dot(e2)


def angular_velocity(rotation: Rotation, slots: Slots) -> Vector:
    """ω in i, j, k, from the axes of the body."""
    return sum((e * w for e, w in zip(rotation.axes, spin_along_axes(rotation, slots), strict=True)), Vector.zero())


def quasi_term(rotation: Rotation, coordinate: sp.Symbol, velocity: sp.Symbol, slots: Slots) -> sp.Expr:
    """H·(ω_k' − ∂ω/∂q_k), the term of quasi-coordinates in Lagrange's expression. Zero for true coordinates."""
    e1, e2, e3 = rotation.axes
    components = spin_along_axes(rotation, slots)
    spin = rotation.angular_velocity.fixed()
    part = spin.map(lambda c: partial(c, velocity)).time_derivative(slots)
    bending = zip(rotation.inertia.times(components), components, (e1, e2, e3), strict=True)
    return sp.Add(*(h * (part.dot(e) - partial(w, coordinate)) for h, w, e in bending))


def is_constant(load: Load, configuration: Configuration) -> bool:
    """Whether a force has the potential −F·r: it is constant, and acts at a particle or mass centre."""
    slots = configuration.slots
    moving = {*slots.coordinates, *slots.prescribed, t}
    vector = load.vector.fixed()
    if any(base(s) in moving for c in vector.components for s in c.free_symbols):
        return False
    return all(load.on != r.name for r in configuration.rotations) or _arm(load, configuration).is_zero


def _arm(load: Load, configuration: Configuration) -> Vector:
    """The vector from the mass centre to the point of application of a force on a body."""
    [centre] = (p.position for p in configuration.points if p.name == load.on)
    return (load.point - centre).fixed()


def share_of_load(load: Load, velocity: sp.Symbol, configuration: Configuration) -> sp.Expr:
    """F·∂v/∂q_k', the force's share of Q_k."""
    return load.vector.fixed().dot(_rate_at(load, configuration).map(lambda c: partial(c, velocity)))


def _rate_at(load: Load, configuration: Configuration) -> Vector:
    """The velocity of the point of application: v = v_G + ω × arm on a body."""
    slots = configuration.slots
    turning = next((r for r in configuration.rotations if r.name == load.on), None)
    if turning is None:
        return load.point.fixed().time_derivative(slots)
    [centre] = (p.position for p in configuration.points if p.name == load.on)
    arm = _arm(load, configuration)
    rate = centre.fixed().time_derivative(slots)
    return rate if arm.is_zero else rate + angular_velocity(turning, slots).cross(arm)


def share_of_moments(configuration: Configuration, velocity: sp.Symbol) -> sp.Expr:
    """Σ M·∂ω/∂q_k'."""
    return sp.Add(*(share_of_torque(m, velocity, configuration) for m in configuration.torques))


def share_of_torque(torque: Torque, velocity: sp.Symbol, configuration: Configuration) -> sp.Expr:
    """M·∂ω/∂q_k' of one moment."""
    [turning] = (r for r in configuration.rotations if r.name == torque.on)
    spin = angular_velocity(turning, configuration.slots)
    return torque.vector.fixed().dot(spin.map(lambda c: partial(c, velocity)))


def share_of_spring(spring: StretchedSpring, coordinate: sp.Symbol) -> sp.Expr:
    """−k (d − l) (r/d)·∂r/∂q_k, r being the vector between the ends."""
    apart = spring.apart.fixed()
    pulled = apart.dot(apart.map(lambda c: partial(c, coordinate)))
    stretched = sp.S.One if spring.length == 0 else 1 - spring.length / spring.distance
    return -spring.stiffness * pulled * stretched


def share_of_damper(damper: DamperForce, velocity: sp.Symbol, slots: Slots) -> sp.Expr:
    """−∂/∂q_k' of Rayleigh's function c d'²/2, d' = r·r'/d; along a line d' = ±s', also where the ends meet."""
    apart = damper.apart.fixed()
    along = _along_a_line(apart, slots)
    if along is not None:
        rate = slots.time_derivative(along)
        return -damper.coefficient * rate * partial(rate, velocity)
    closing = apart.dot(apart.time_derivative(slots))
    return -damper.coefficient * closing * partial(closing, velocity) / apart.dot(apart)


def _along_a_line(apart: Vector, slots: Slots) -> sp.Expr | None:
    """The length s of a vector s n with a constant unit vector n, with either sign; None if its direction changes."""
    parts = [c for c in apart.components if c != 0]
    if not all(c.is_polynomial(*slots.coordinates) for c in parts):
        return None if len(parts) > 1 else parts[0]
    ratios = [sp.cancel(c / parts[0]) for c in parts]
    moving = {*slots.coordinates, *slots.prescribed, t}
    if any(base(s) in moving for e in ratios for s in e.free_symbols):
        return None
    return parts[0] * sp.sqrt(sp.Add(*(e**2 for e in ratios)))


def applied_power(configuration: Configuration) -> sp.Expr:
    """Σ F·v + Σ M·ω − Σ c d'², the power of forces without a potential; d' without the prescribed motion of ends.

    A mass that varies adds (dm/dt) v²/2: dT/dt is the power of all forces, the reactive ones included, and that.
    """
    slots = configuration.slots
    terms = [f.vector.fixed().dot(_rate_at(f, configuration)) for f in configuration.loads]
    spins = {r.name: angular_velocity(r, slots) for r in configuration.rotations}
    terms += [m.vector.fixed().dot(spins[m.on]) for m in configuration.torques]
    for d in configuration.dampers:
        apart = d.apart.fixed()
        rate = apart.time_derivative(slots)
        own = rate - apart.frozen_derivative(slots)
        terms.append(-d.coefficient * apart.dot(rate) * apart.dot(own) / apart.dot(apart))
    positions = {p.name: p for p in configuration.points}
    for m in configuration.variable_masses:
        velocity = velocity_of(positions[m.name], slots)
        terms.append(m.rate * velocity.dot(velocity) / 2)
    return sp.Add(*terms)
