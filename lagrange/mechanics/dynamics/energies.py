"""Lagrange's equations as they are printed: T, V, the generalized forces, the generalized momenta.

    p_k = ∂T/∂q_k' ,      d/dt p_k − ∂L/∂q_k = Q_k + Σ_j λ_j a_jk ,      L = T − V .

V is the potential energy of weights, springs and given potentials; all other forces enter Q_k by their virtual work,
δW = Σ Q_k δq_k. A damper adds −∂F/∂q_k' of Rayleigh's function F = c d'²/2. Velocities and angular velocities are those
of `lagrangian.py`, which shares no step with d'Alembert's principle; here they are read into the ring, where T comes
out tidy. A body whose ω is given may move in quasi-coordinates; N_k = H·(ω_k' − ∂ω/∂q_k) is then the excess of
Lagrange's expression (Boltzmann, Hamel), which becomes d/dt p_k − ∂L/∂q_k − N_k.

Every velocity of the configuration is free in T: no constraint on velocities is substituted. With y' = x' tan θ in the
T of a sleigh before differentiating, ∂T/∂x' would contain terms that the reaction balances, and the equations would be
wrong unless the constraint is equivalent to a finite relation.
Reference: Whittaker, Analytical Dynamics, §§ 26, 30, 87.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.fourier.ring import Element, FourierRing
from lagrange.algebra.fourier.textbook_form import Textbook, common_factor
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import partial
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, Load, MassPoint
from lagrange.mechanics.dynamics.lagrangian import (
    is_constant,
    kinetic_energy,
    quasi_term,
    share_of_load,
    share_of_moments,
    velocity_of,
)
from lagrange.mechanics.dynamics.principle import Balance

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.rigid_bodies import Rotation

WEIGHT = "weight"


@record
class Energies(Balance):
    """T, V and Lagrange's equations in the coordinates of a configuration, all in textbook form.

    velocities  of the particles and mass centres that have mass, by name
    squares     v² of each
    kinetic     T
    potential   V
    moving      what L has beside T − V: terms of a given Lagrangian, or of potentials, with velocities
    momenta     shape (n,): p_k
    rates       shape (n,): d/dt p_k
    partials    shape (n,): ∂L/∂q_k
    applied     shape (n,): Q_k of the forces that are not in V
    of_masses   shape (n,): S_k, what masses that vary add on the right (`variable_mass`); 0 where none does
    quasi       shape (n,): N_k; 0 in true coordinates
    left        shape (n,): d/dt p_k − ∂L/∂q_k − N_k
    """

    velocities: Mapping[str, Vector]
    squares: Mapping[str, sp.Expr]
    kinetic: sp.Expr
    potential: sp.Expr
    moving: sp.Expr
    momenta: tuple[sp.Expr, ...]
    rates: tuple[sp.Expr, ...]
    partials: tuple[sp.Expr, ...]
    applied: tuple[sp.Expr, ...]
    of_masses: tuple[sp.Expr, ...]
    quasi: tuple[sp.Expr, ...]
    left: tuple[sp.Expr, ...]

    @property
    def has_lagrangian(self) -> bool:
        """Whether L is more than T."""
        return bool(self.potential != 0 or self.moving != 0)

    @property
    def lagrangian(self) -> sp.Expr:
        """L."""
        return self.kinetic + self.moving - self.potential

    @property
    def moving_energy(self) -> sp.Expr:
        """Σ q_k' ∂X/∂q_k' − X of the terms X with velocities: their share of the energy."""
        velocities = self.configuration.slots.velocities
        return sp.Add(*(v * partial(self.moving, v) for v in velocities), -self.moving)

    @property
    def has_quasi_coordinates(self) -> bool:
        """Whether some N_k is not zero."""
        return any(n != 0 for n in self.quasi)


def energies(configuration: Configuration) -> Energies:
    """T, V and Lagrange's equations of a configuration, written out."""
    ring = FourierRing()
    textbook = Textbook(ring)
    slots = configuration.slots
    kinetic = ring.from_sympy(kinetic_energy(configuration))
    moving = ring.from_sympy(configuration.velocity_part)
    potential = ring.from_sympy(potential_energy(configuration))
    rate_of = ring.time_derivative(slots)
    momenta = [ring.partial(v)(kinetic + moving) for v in slots.velocities]
    rates = [rate_of(p) for p in momenta]
    slopes = [ring.partial(q)(potential) for q in slots.coordinates]
    partials = [ring.partial(q)(kinetic + moving) - s for q, s in zip(slots.coordinates, slopes, strict=True)]
    applied = [_applied(configuration, v, ring) for v in slots.velocities]
    if configuration.generalized:
        applied = [q + ring.from_sympy(e) for q, e in zip(applied, configuration.generalized, strict=True)]
    quasi = [_quasi(configuration, k, ring) for k in range(len(slots.coordinates))]
    left = [r - p - n for r, p, n in zip(rates, partials, quasi, strict=True)]
    of_masses = [ring.from_sympy(e) for e in configuration.mass_terms] or [ring.zero] * len(left)
    massive = [p for p in configuration.points if p.mass != 0 and not configuration.is_pinned(p)]

    def forms(elements: list[Element]) -> tuple[sp.Expr, ...]:
        return tuple(textbook.form(e) for e in elements)

    return Energies(
        configuration=configuration,
        coefficients=tuple(a - q - s for a, q, s in zip(left, applied, of_masses, strict=True)),
        forces=forms([q - s for q, s in zip(applied, slopes, strict=True)]),
        textbook=textbook,
        velocities={p.name: p.velocity.map(textbook.form) for p in massive},
        squares={p.name: textbook.form(_square(p, configuration)) for p in massive},
        kinetic=_written_kinetic(configuration, kinetic, ring),
        potential=_written_potential(configuration, textbook),
        moving=configuration.velocity_part,
        momenta=forms(momenta),
        rates=forms(rates),
        partials=forms(partials),
        applied=tuple(Textbook(ring, merge=True).form(q) for q in applied),
        of_masses=forms(of_masses),
        quasi=forms(quasi),
        left=forms(left),
    )


def potential_energy(configuration: Configuration) -> sp.Expr:
    """V of the weights, the springs and the given potentials."""
    weights = (f.vector.fixed().dot(f.point.fixed()) for f in configuration.loads if is_weight(f, configuration))
    return configuration.potential - sp.Add(*weights)


def is_weight(load: Load, configuration: Configuration) -> bool:
    """Whether a force is a weight, with the potential −m g·r. Other constant forces remain among the Q_k."""
    return load.name == WEIGHT and is_constant(load, configuration)


def _square(point: MassPoint, configuration: Configuration) -> sp.Expr:
    velocity = velocity_of(point, configuration.slots)
    return velocity.dot(velocity)


def _applied(configuration: Configuration, velocity: sp.Symbol, ring: FourierRing) -> Element:
    """Q_k = Σ F·∂v/∂q_k' + Σ M·∂ω/∂q_k' − Σ c d' ∂d'/∂q_k'."""
    loads = (f for f in configuration.loads if not is_weight(f, configuration))
    terms = [ring.from_sympy(share_of_load(f, velocity, configuration)) for f in loads]
    terms.append(ring.from_sympy(share_of_moments(configuration, velocity)))
    for d in configuration.dampers:
        terms.append(-(ring.from_sympy(d.pull) * ring.from_sympy(partial(d.rate, velocity))))
    return ring.total(terms)


def _quasi(configuration: Configuration, k: int, ring: FourierRing) -> Element:
    """N_k, for bodies whose ω is given."""
    slots = configuration.slots
    q, v = slots.coordinates[k], slots.velocities[k]
    total = ring.total(ring.from_sympy(quasi_term(r, q, v, slots)) for r in configuration.rotations if r.given)
    return ring.zero if ring.is_zero(total) else total


def _written_kinetic(configuration: Configuration, kinetic: Element, ring: FourierRing) -> sp.Expr:
    """T in textbook form, with the common factors of all terms in front: m (r'² + r² φ'²)/2.

    Squares of components ω_1, ... of a body that are sums are kept if that is shorter, C (φ' cos θ + ψ')²/2, with ω in
    the triad in which it is shortest.
    """
    textbook = Textbook(ring, merge=True)
    expanded = _in_front(textbook.form(kinetic))
    squares = sp.Add(*(s for r in configuration.rotations for s in _squares_of_sums(r, textbook)))
    if squares == 0:
        return expanded
    parts = _in_front(textbook.form(kinetic - ring.from_sympy(squares))) + squares
    return parts if count_operations(parts) < count_operations(expanded) else expanded


def _in_front(total: sp.Expr) -> sp.Expr:
    """A sum with the common factor of its terms before a bracket: m/2 or m, but not m/10."""
    factor = common_factor(total)
    if not total.is_Add or not factor.powers or any(e < 0 for _, e in factor.powers):
        return total
    rest = factor.divide(total)
    numbers = (abs(term.as_coeff_Mul()[0]) for term in sp.Add.make_args(rest))
    return factor.expression * rest if sp.Rational(factor.number).q <= 2 and max(numbers) <= 2 else total


def _squares_of_sums(rotation: Rotation, textbook: Textbook) -> list[sp.Expr]:
    """A ω_1²/2, ..., of components that are sums."""
    spins = [textbook.form(w) for w in rotation.angular_velocity.components]
    return [moment * w**2 / 2 for moment, w in zip(rotation.inertia.moments, spins, strict=True) if w.is_Add]


def _written_potential(configuration: Configuration, textbook: Textbook) -> sp.Expr:
    """V as the sum of its contributions; that of a spring as k (d − l)²/2 if that is shorter."""
    springs = [s.energy for s in configuration.springs]
    fields = configuration.potential - sp.Add(*springs)
    written = (min(textbook.form(e), e, key=lambda form: count_operations(form)) for e in springs)
    weights = potential_energy(configuration) - configuration.potential
    return sp.Add(textbook.form(weights), textbook.form(fields), *written)
