"""D'Alembert's principle, and the balance Σ D_k δq_k = 0 that every derivation starts from.

The reactions do no virtual work, so that

    Σ (m r'' − F)·δr = 0        for every virtual displacement.

With δr = Σ (∂r/∂q_k) δq_k this is Σ D_k δq_k = 0, where D_k is the inertia Σ m r''·∂r/∂q_k minus the generalized force
Q_k = Σ F·∂r/∂q_k − ∂V/∂q_k. A rigid body, with its mass centre as r, adds (dH/dt − M)·δπ to the sum and (dH/dt − M)·ω_k
to D_k; a damper adds c d' ∂d/∂q_k. The δq_k are free only if the coordinates are independent; otherwise A δq = 0 binds
them, and with multipliers D_k = Σ_j λ_j a_jk.

Lagrange's equations give the same D_k as d/dt ∂T/∂q_k' − ∂T/∂q_k − Q_k (`energies.py`). Both are a `Balance`, and the
later stages use only that. Everything is built in the ring of Fourier sums, where it comes out reduced.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property

import sympy as sp

from lagrange.algebra.fourier.ring import Element, FourierRing
from lagrange.algebra.fourier.textbook_form import Textbook, textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import partial, prime, t, variation
from lagrange.core.vectors import Triad, Vector
from lagrange.mechanics.constraints.kinematics import Configuration


@record
class Balance:
    """The balance of inertia and applied forces in the coordinates of a configuration.

    coefficients  shape (n,): D_k, as ring elements
    forces        shape (n,): Q_k of all applied forces, in textbook form
    textbook      turns ring elements into textbook form
    """

    configuration: Configuration
    coefficients: tuple[Element, ...]
    forces: tuple[sp.Expr, ...]
    textbook: Textbook

    @property
    def ring(self) -> FourierRing:
        """The ring of the coefficients."""
        return self.textbook.ring


@record
class Principle(Balance):
    """D'Alembert's principle in the coordinates of a configuration; parts that are only shown are made on demand."""

    @cached_property
    def statement(self) -> sp.Expr:
        """Σ D_k δq_k, in textbook form."""
        return self.written([variation(q) for q in self.configuration.slots.coordinates], self.coefficients)

    @cached_property
    def accelerations(self) -> Mapping[str, Vector]:
        """The accelerations of particles and mass centres, by name, in textbook form."""
        moving = (p for p in self.configuration.points if p.mass != 0 and not self.configuration.is_pinned(p))
        return {p.name: p.acceleration.map(self.textbook.form) for p in moving}

    @cached_property
    def momentum_rates(self) -> Mapping[str, Vector]:
        """dH/dt of each body, by name, in textbook form."""
        turning = (r for r in self.configuration.rotations if r.has_inertia)
        return {r.name: r.momentum_rate.map(self.textbook.form) for r in turning}

    def written(self, displacements: Iterable[sp.Symbol], coefficients: Iterable[Element]) -> sp.Expr:
        """Σ coefficient · δq, in textbook form."""
        return self.textbook.work(dict(zip(displacements, coefficients, strict=True)))


def dalembert(configuration: Configuration) -> Principle:
    """D'Alembert's principle, written out."""
    ring = FourierRing()
    textbook = Textbook(ring)
    forces = generalized_forces(configuration, ring)
    inertia = _inertia(configuration, ring)
    return Principle(
        configuration=configuration,
        coefficients=tuple(i - q for i, q in zip(inertia, forces, strict=True)),
        forces=tuple(textbook.form(q) for q in forces),
        textbook=textbook,
    )


def generalized_forces(configuration: Configuration, ring: FourierRing) -> tuple[Element, ...]:
    """Q_k = Σ F·∂r/∂q_k + Σ M·ω_k − ∂V/∂q_k − Σ c d' ∂d/∂q_k, shape (n,)."""
    centres = {p.name: p for p in configuration.points}
    turning = {r.name: r for r in configuration.rotations}
    moments = {name: configuration.moment_on(name) for name in turning}
    forces = []
    for k, q in enumerate(configuration.slots.coordinates):
        work = []
        for load in configuration.loads:
            moved = centres[load.on].partials[k] if load.on in turning else load.point.partial(q)
            work.append(dot(load.vector, moved, ring))
        work += [dot(moments[name], r.partials[k], ring) for name, r in turning.items()]
        resistance = [ring.from_sympy(d.pull) * ring.from_sympy(partial(d.distance, q)) for d in configuration.dampers]
        forces.append(ring.total(work) - ring.total(resistance) - ring.from_sympy(partial(configuration.potential, q)))
    others = given_forces(configuration)
    return tuple(q + ring.from_sympy(e) for q, e in zip(forces, others, strict=True)) if others else tuple(forces)


def given_forces(configuration: Configuration) -> tuple[sp.Expr, ...]:
    """Q_k that the file gives, and ∂X/∂q_k − d/dt ∂X/∂q_k' of the part X of the Lagrangian with velocities; or none.

    Differentiated along a curve: with q_k(s) = q_k + q_k' s + q_k'' s²/2, the rate of ∂X/∂q_k' is its derivative with
    respect to s at s = 0. Lagrange's equations (`energies`) use the chain rule in the ring of Fourier sums instead.
    """
    slots, X = configuration.slots, configuration.velocity_part
    size = len(slots.coordinates)
    given = configuration.generalized or (sp.S.Zero,) * size
    if X == 0:
        return configuration.generalized
    s = sp.Dummy("s", real=True)
    curve: dict[sp.Basic, sp.Expr] = {t: t + s}
    for q in (*slots.coordinates, *slots.prescribed):
        v, a, j = prime(q), prime(q, 2), prime(q, 3)
        curve |= {q: q + v * s + a * s**2 / 2, v: v + a * s, a: a + j * s}
    rates = [sp.diff(sp.diff(X, v).xreplace(curve), s).xreplace({s: sp.S.Zero}) for v in slots.velocities]
    slopes = [sp.diff(X, q) for q in slots.coordinates]
    return tuple(f + slope - rate for f, slope, rate in zip(given, slopes, rates, strict=True))


def written_forces(configuration: Configuration) -> tuple[sp.Expr, ...]:
    """The given forces in textbook form."""
    return tuple(map(textbook_form, given_forces(configuration)))


def _inertia(configuration: Configuration, ring: FourierRing) -> tuple[Element, ...]:
    """Σ m r''·∂r/∂q_k + Σ dH/dt·ω_k, shape (n,)."""
    summands: list[list[Element]] = [[] for _ in configuration.slots.coordinates]
    changes = [(p.acceleration, p.mass, p.partials) for p in configuration.points if p.mass != 0]
    changes += [(r.momentum_rate, sp.S.One, r.partials) for r in configuration.rotations]
    for rate, mass, partials in changes:
        forces: dict[Triad, list[Element]] = {}  # in each triad, for all coordinates
        for k, moved in enumerate(partials):
            if moved.is_zero:
                continue
            force = forces.get(moved.triad)
            if force is None:
                along = rate.along(moved.triad).components
                force = forces[moved.triad] = [ring.from_sympy(mass) * ring.from_sympy(c) for c in along]
            summands[k].append(ring.dot(force, list(map(ring.from_sympy, moved.components))))
    return tuple(map(ring.total, summands))


def dot(a: Vector, b: Vector, ring: FourierRing) -> Element:
    """a·b in the ring, in the triad of b."""
    a = a.along(b.triad)
    return ring.dot([ring.from_sympy(c) for c in a.components], [ring.from_sympy(c) for c in b.components])
