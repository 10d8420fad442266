"""Lagrange's equations, the second route to the equations of motion.

    d/dt ∂T/∂q_k' − ∂T/∂q_k = Q_k + Σ_j λ_j a_jk ,      T = Σ m v·v / 2

Nothing here is taken from d'Alembert's principle: velocities come from positions in i, j, k, constant forces enter by
their potential −F·r, and the others by Q_k = Σ F·∂v/∂q_k'. A constraint on velocities is never put into T before
differentiating: T must know every velocity that the constraint excludes, or ∂T/∂q' loses the terms that its reaction
balances.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from lagrange.kinematics import Configuration, Load
from lagrange.notation import Slots, base, derivative, t


@dataclass(frozen=True)
class Lagrangian:
    """Lagrange's equations of a configuration.

    kinetic    T
    potential  V of the constant forces and of the given potentials
    left       shape (n,): d/dt ∂T/∂q_k' − ∂T/∂q_k − Q_k, which equals Σ_j λ_j a_jk
    """

    kinetic: sp.Expr
    potential: sp.Expr
    left: tuple[sp.Expr, ...]


def lagrange_equations(configuration: Configuration) -> Lagrangian:
    """T, V and the left sides of Lagrange's equations."""
    slots = configuration.slots
    kinetic = kinetic_energy(configuration)
    constant = [f for f in configuration.loads if _is_constant(f, slots)]
    varying = [f for f in configuration.loads if not _is_constant(f, slots)]
    potential = configuration.potential - sp.Add(*(f.vector.fixed().dot(f.point.fixed()) for f in constant))
    left = []
    for q, v in zip(slots.coordinates, slots.velocities, strict=True):
        force = sp.Add(*(_generalized(f, v, slots) for f in varying)) - _partial(potential, q)
        left.append(slots.time_derivative(_partial(kinetic, v)) - _partial(kinetic, q) - force)
    return Lagrangian(kinetic, potential, tuple(left))


def kinetic_energy(configuration: Configuration) -> sp.Expr:
    """T = Σ m v·v / 2, with v from the position in i, j, k."""
    slots = configuration.slots
    terms = []
    for p in configuration.points:
        velocity = p.position.fixed().time_derivative(slots)
        terms.append(p.mass * velocity.dot(velocity) / 2)
    return sp.Add(*terms)


def _partial(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    return derivative(expression, lambda s: sp.S.One if s == symbol else sp.S.Zero)


def _is_constant(load: Load, slots: Slots) -> bool:
    moving = {*slots.coordinates, *slots.prescribed, t}
    vector = load.vector.fixed()
    return not any(base(s) in moving for c in vector.components for s in c.free_symbols)


def _generalized(load: Load, velocity: sp.Symbol, slots: Slots) -> sp.Expr:
    """F·∂v/∂q_k', the force's share of Q_k."""
    rate = load.point.fixed().time_derivative(slots)
    return load.vector.fixed().dot(rate.map(lambda c: c.diff(velocity)))
