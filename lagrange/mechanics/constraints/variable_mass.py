"""Particles whose mass varies: Meshchersky's equation.

Mass that leaves a particle, or joins it, carries momentum. In the time dt the particle with the mass m(q, t) gains
dm = m' dt, negative where it loses mass, with the velocity u just before it joins, or just after it leaves. Momentum
changes by the impulse of the forces only, (m + dm)(v + dv) − m v − dm u = F dt, so that

    m dv/dt = F + Φ ,      Φ = (dm/dt) (u − v) .

The reactive force Φ is an applied force to d'Alembert's principle, Σ (F + Φ − m r'')·δr = 0. In Lagrange's equations T
contains the mass, which d/dt and ∂/∂q_k differentiate too:

    d/dt ∂T/∂q_k' − ∂T/∂q_k = Σ (F + (dm/dt) u)·∂r/∂q_k − Σ (∂m/∂q_k) v²/2 ,

that is, Q_k = Σ (F + Φ)·∂r/∂q_k and beside it S_k = Σ (dm/dt) v·∂r/∂q_k − Σ (∂m/∂q_k) v²/2 (`mass_terms`).
All mass of the particle has the velocity v = r'. A reactive force has no potential, even where it is constant: the
energy that it gives comes from elsewhere.
References: Meshchersky 1897; Pesce, J. Appl. Mech. 70 (2003), 751; Sommerfeld, Mechanics, § 4.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Slots, partial, t
from lagrange.core.vectors import Vector
from lagrange.problem.model import Particle, Problem

REACTIVE = "reactive"
"""The name of Φ among the loads. A file may have a force of the same name."""


@record
class VariableMass:
    """A particle whose mass varies.

    name      of the particle
    mass      m(q, t)
    rate      dm/dt
    velocity  of the mass that leaves or joins, u, or u − v where it is `relative`
    leaves    whether mass leaves; otherwise it joins
    """

    name: str
    mass: sp.Expr
    rate: sp.Expr
    velocity: Vector
    relative: bool
    leaves: bool

    @property
    def exchanged(self) -> sp.Expr:
        """The mass that leaves or joins per unit time."""
        return textbook_form(-self.rate) if self.leaves else textbook_form(self.rate)

    @property
    def is_smooth(self) -> bool:
        """Whether mass leaves or joins with the particle's own velocity, and so exerts no force on it."""
        return self.relative and self.velocity.is_zero

    @property
    def has_one_sense(self) -> bool:
        """Whether the law holds only while mass leaves, or only while it joins, as decided by the velocities."""
        return not self.is_smooth and any(s.name.endswith("'") for s in self.rate.free_symbols)


def variable_masses(problem: Problem) -> tuple[VariableMass, ...]:
    """The particles of a file whose mass varies."""
    return tuple(
        VariableMass(
            p.name, p.mass, problem.slots.time_derivative(p.mass), p.exchange.velocity, p.exchange.relative,
            p.exchange.leaves,
        )
        for p in problem.particles
        if p.exchange is not None
    )  # fmt: skip


def reactive_force(particle: Particle, slots: Slots) -> Vector:
    """Φ = (dm/dt) (u − v)."""
    assert particle.exchange is not None
    velocity = particle.exchange.velocity
    if not particle.exchange.relative:
        velocity = velocity - particle.position.time_derivative(slots)
    force: Vector = velocity * slots.time_derivative(particle.mass)
    return force


def rewritten_mass(variable: VariableMass, rule: dict[sp.Basic, sp.Basic], slots: Slots) -> VariableMass:
    """The same in other coordinates."""
    mass = variable.mass.xreplace(rule)
    velocity = variable.velocity.xreplace(rule)
    return VariableMass(variable.name, mass, slots.time_derivative(mass), velocity, variable.relative, variable.leaves)


def mass_terms(variables: Sequence[VariableMass], positions: dict[str, Vector], slots: Slots) -> tuple[sp.Expr, ...]:
    """S_k = Σ (dm/dt) v·∂v/∂q_k' − Σ (∂m/∂q_k) v²/2, shape (n,), v from positions in i, j, k; or none."""
    if not variables:
        return ()
    terms = [sp.S.Zero] * len(slots.coordinates)
    for m in variables:
        v = positions[m.name].fixed().time_derivative(slots)
        for k, (q, rate) in enumerate(zip(slots.coordinates, slots.velocities, strict=True)):
            along = v.dot(v.map(lambda c, r=rate: partial(c, r)))  # type: ignore[misc]
            terms[k] += m.rate * along - partial(m.mass, q) * v.dot(v) / 2
    return tuple(terms)


@record
class PositiveMassRange:
    """Where a mass is positive: `symbol` < `bound`, or > where `above`; `symbol` is None if it is not solved for."""

    name: str
    mass: sp.Expr
    symbol: sp.Symbol | None = None
    bound: sp.Expr = sp.S.Zero
    above: bool = False


def validities(variables: Sequence[VariableMass], slots: Slots) -> tuple[PositiveMassRange, ...]:
    """Where the masses are positive, of those that may vanish."""
    return tuple(_validity(m, slots) for m in variables if not m.mass.is_positive)


def _validity(m: VariableMass, slots: Slots) -> PositiveMassRange:
    moving = sorted(m.mass.free_symbols & {*slots.coordinates, *slots.prescribed, t}, key=str)
    if len(moving) == 1:
        [s] = moving
        slope = sp.diff(m.mass, s)
        if s not in slope.free_symbols and (slope.is_positive or slope.is_negative):
            bound = sp.factor_terms(-m.mass.xreplace({s: sp.S.Zero}) / slope)
            return PositiveMassRange(m.name, m.mass, s, bound, bool(slope.is_positive))
    return PositiveMassRange(m.name, m.mass)
