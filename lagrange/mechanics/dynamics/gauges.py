"""Symmetries but for a rate: what a displacement changes in L, with the work of the forces, is dG/dt (R of `noether`).

    m x'' = q B y'                 δx:  R = q B y' = d/dt (q B y) ,       m x' − q B y = const
    the same, and y               a rotation:  R = −q B (x x' + y y') ,  m (x y' − y x') + q B (x² + y²)/2 = const
    a lift with acceleration a    δt:  R = −∂L/∂t = dG/dt with G of q and t ,     h − G = const

R must be linear in the velocities, ρ·q' + ρ_t, with an exact form ρ dq + ρ_t dt. Each of that is a linear condition on
the coefficients of a combination, so that combinations of translations and rotations are found as those with R = 0 are.
Of a displacement, G contains no time.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.forms.potentials import primitive
from lagrange.algebra.fourier.trigonometry import Element
from lagrange.core.records import record
from lagrange.core.symbols import t
from lagrange.mechanics.dynamics.energy_functions import EnergyFunctions
from lagrange.mechanics.dynamics.noether import Candidate, Kind, Symmetry, symmetries

MOST_COORDINATES = 12
"""More have too many pairs of partial derivatives."""


@record
class _Rate:
    """A candidate with R = ρ·q' + ρ_t: `form` is (ρ, ρ_t), shape (n + 1,), and `candidate` has its conditions."""

    candidate: Candidate
    form: tuple[Element, ...]


def gauged(found: Sequence[Candidate], energies: EnergyFunctions) -> list[Symmetry]:
    """The symmetries but for a rate among candidates and their combinations, each as one candidate that has G."""
    if energies.are_quasi or len(energies.slots.coordinates) > MOST_COORDINATES:
        return []
    displaced = [_Affine(energies, Kind.GAUGE).of(c) for c in _displacements(found)]
    delayed = [_Affine(energies, Kind.TIME).of(c) for c in found if c.kind is Kind.TIME and _is_driven(energies)]
    return _with_rates(displaced, energies) + _with_rates(delayed, energies)


def _is_driven(energies: EnergyFunctions) -> bool:
    """Whether all of dh/dt comes from time in L: constant friction takes energy, although its work is a function."""
    velocities = [energies.ring.from_sympy(v) for v in energies.slots.velocities]
    return bool(energies.ring.is_zero(energies.ring.dot(energies.forces, velocities)))


def _displacements(found: Sequence[Candidate]) -> list[Candidate]:
    """Translations, and rotations as wholes: their halves have quadratic R."""
    turns = [c for c in found if c.kind is Kind.ROTATION]
    whole = [
        Candidate(
            Kind.ROTATION,
            tuple(y - x for x, y in zip(a.multipliers, b.multipliers, strict=True)),
            tuple(y - x for x, y in zip(a.conditions, b.conditions, strict=True)),
        )
        for a, b in zip(turns[::2], turns[1::2], strict=True)
    ]
    return [c for c in found if c.kind is Kind.TRANSLATION] + whole


class _Affine:
    """Makes candidates whose last condition R is replaced by the conditions that R is a rate."""

    def __init__(self, energies: EnergyFunctions, kind: Kind) -> None:
        self.ring, self.slots, self.kind = energies.ring, energies.slots, kind

    def of(self, candidate: Candidate) -> _Rate | None:
        """The candidate with its form; None where R is not linear in the velocities."""
        ring, slots = self.ring, self.slots
        try:
            rho, rest = ring.linear(ring.from_sympy(candidate.conditions[-1]), slots.velocities)
        except ValueError:
            return None
        partials = [ring.partial(q) for q in slots.coordinates]
        frozen = ring.frozen_derivative(slots)
        curl = [partials[a](rho[b]) - partials[b](rho[a]) for a, b in combinations(range(len(rho)), 2)]
        if self.kind is Kind.TIME:
            curl += [frozen(r) - d(rest) for r, d in zip(rho, partials, strict=True)]
        else:
            curl += [rest, *map(frozen, rho)]
        conditions = (*candidate.conditions[:-1], *(c.to_sympy() for c in curl))
        return _Rate(Candidate(self.kind, candidate.multipliers, conditions), (*rho, rest))


def _with_rates(tried: Sequence[_Rate | None], energies: EnergyFunctions) -> list[Symmetry]:
    """The combinations that satisfy the conditions, if their G is found, without those that have R = 0."""
    ring = energies.ring
    rates = [r for r in tried if r is not None and any(not ring.is_zero(e) for e in r.form)]
    if all(ring.is_zero(e) for r in rates for e in r.form[:-1]) and all(r.candidate.kind is Kind.GAUGE for r in rates):
        return []
    candidates = [r.candidate for r in rates]
    result = []
    for symmetry in symmetries(candidates, energies.configuration):
        used = [(next(r for r in rates if r.candidate is k), c) for k, c in symmetry.terms]
        form = [ring.total(ring.from_sympy(c) * r.form[n] for r, c in used) for n in range(len(rates[0].form))]
        if all(ring.is_zero(e) for e in form):
            continue
        g = primitive([e.to_sympy() for e in form], (*energies.slots.coordinates, t), energies.slots)
        if g is not None:
            whole = Candidate(symmetry.kind, symmetry.multipliers, (), g)
            result.append(Symmetry(symmetry.kind, ((whole, sp.S.One),)))
    return result
