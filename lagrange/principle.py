"""D'Alembert's principle: the reactions do no virtual work, so that

    Σ (m r'' − F)·δr = 0        for every virtual displacement,

which, with δr = Σ (∂r/∂q_k) δq_k, is Σ D_k δq_k = 0. D_k is the inertia Σ m r''·∂r/∂q_k less the generalized force
Q_k = Σ F·∂r/∂q_k − ∂V/∂q_k. A rigid body, whose r is that of its mass centre, adds (dH/dt − M)·δπ to the sum, and to
D_k (dH/dt − M)·ω_k; a damper adds c d' ∂d/∂q_k. The δq_k are free only where the coordinates are independent;
otherwise A δq = 0 binds them. Everything is built in the ring of Fourier sums, where it comes out reduced.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from lagrange.balance import Balance
from lagrange.kinematics import Configuration
from lagrange.notation import partial, variation
from lagrange.textbook import Textbook
from lagrange.trigonometry import Element, Ring
from lagrange.vectors import Vector


@dataclass(frozen=True)
class Principle(Balance):
    """D'Alembert's principle in the coordinates of a configuration.

    statement     Σ D_k δq_k, in textbook form
    accelerations of the particles and mass centres, by name, in textbook form
    momentum_rates dH/dt of the bodies, by name, in textbook form
    """

    statement: sp.Expr
    accelerations: Mapping[str, Vector]
    momentum_rates: Mapping[str, Vector]


def dalembert(configuration: Configuration) -> Principle:
    """D'Alembert's principle, written out."""
    ring = Ring()
    textbook = Textbook(ring)
    forces = generalized_forces(configuration, ring)
    inertia = _inertia(configuration, ring)
    coefficients = tuple(i - q for i, q in zip(inertia, forces, strict=True))
    displacements = [ring.from_sympy(variation(q)) for q in configuration.slots.coordinates]
    statement = ring.total(d * v for d, v in zip(coefficients, displacements, strict=True))
    return Principle(
        configuration=configuration,
        coefficients=coefficients,
        forces=tuple(textbook.form(q) for q in forces),
        statement=textbook.form(statement),
        accelerations={
            p.name: p.acceleration.map(textbook.form)
            for p in configuration.points
            if p.mass != 0 and not configuration.is_pinned(p)
        },
        momentum_rates={r.name: r.momentum_rate.map(textbook.form) for r in configuration.rotations if r.has_inertia},
        textbook=textbook,
    )


def generalized_forces(configuration: Configuration, ring: Ring) -> tuple[Element, ...]:
    """Q_k = Σ F·∂r/∂q_k + Σ M·ω_k − ∂V/∂q_k − Σ c d' ∂d/∂q_k, shape (n,)."""
    centres = {p.name: p for p in configuration.points}
    turning = {r.name: r for r in configuration.rotations}
    moments = {name: configuration.moment_on(name) for name in turning}
    found = []
    for k, q in enumerate(configuration.slots.coordinates):
        work = []
        for load in configuration.loads:
            moved = centres[load.on].partials[k] if load.on in turning else load.point.partial(q)
            work.append(_dot(load.vector, moved, ring))
        work += [_dot(moments[name], r.partials[k], ring) for name, r in turning.items()]
        resistance = [ring.from_sympy(d.pull) * ring.from_sympy(partial(d.distance, q)) for d in configuration.dampers]
        found.append(ring.total(work) - ring.total(resistance) - ring.from_sympy(partial(configuration.potential, q)))
    return tuple(found)


def _inertia(configuration: Configuration, ring: Ring) -> tuple[Element, ...]:
    """Σ m r''·∂r/∂q_k + Σ dH/dt·ω_k, shape (n,)."""
    total = [ring.zero] * len(configuration.slots.coordinates)
    for p in configuration.points:
        if p.mass == 0:
            continue
        mass = ring.from_sympy(p.mass)
        for k, partial in enumerate(p.partials):
            if not partial.is_zero:
                total[k] = total[k] + mass * _dot(p.acceleration, partial, ring)
    for r in configuration.rotations:
        for k, partial in enumerate(r.partials):
            if not partial.is_zero:
                total[k] = total[k] + _dot(r.momentum_rate, partial, ring)
    return tuple(total)


def _dot(a: Vector, b: Vector, ring: Ring) -> Element:
    """a·b in the ring, in the triad of b."""
    a = a.along(b.triad)
    return ring.dot([ring.from_sympy(c) for c in a.components], [ring.from_sympy(c) for c in b.components])
