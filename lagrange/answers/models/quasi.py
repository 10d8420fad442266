"""Quasi-velocities mistaken for velocities of coordinates.

In quasi-velocities u_s, with q_k' = Σ B_ks u_s + b_k, the equations of motion are not Lagrange's in the u_s but

    d/dt ∂T*/∂u_s − Σ_k B_ks ∂T*/∂q_k + (terms with products of the u)  =  Σ_k B_ks Q_k ,

with T* = T in terms of the u (Boltzmann, Hamel). What is usually lost are the terms with products, Euler's
(C − B) q r among them and the centripetal a ω² of a sleigh: they are what Σ_k B_ks (d/dt ∂T/∂q_k' − ∂T/∂q_k) has beyond
the first two terms, and are never written out here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.answers.models.mechanics import AppliedForceKind, Inertia, Mechanics
from lagrange.answers.models.variation import Variation, VariedQuasiEquations
from lagrange.core.diagnostics import ProblemError
from lagrange.core.symbols import partial, prime
from lagrange.mechanics.dynamics.quasi_velocities import QuasiVelocities, quasi_velocities


def products_left_out(m: Mechanics) -> Iterator[Variation]:
    """The terms with products of quasi-velocities are omitted, or have the wrong sign or factor."""
    if not m.speeds or m.of_kind(AppliedForceKind.QUASI):
        return
    try:
        speeds = quasi_velocities(m.speeds, m.configuration)
    except ProblemError:
        return
    names = ", ".join(u.name for u in speeds.definitions)
    place = f"the terms with products of {names}, which are no velocities of coordinates"
    groups = [(m.inertias, "")]
    if m.particles and m.rotations:
        groups += [
            (m.rotations, " in the equations of the rotation"),
            (m.particles, " in the equations of the mass centres"),
        ]
    equations = [(parts, where, _kinetic(m, parts, speeds)) for parts, where in groups]
    for factor, how in _FACTORS:
        for parts, where, kinetic in equations:
            clause = f"{how} the terms with products of {names}{where}"
            if factor == 0:
                clause += ": Lagrange's equations do not hold in quasi-velocities as they do in velocities"
            yield Variation(clause, place, m, quasi=VariedQuasiEquations(parts, kinetic, speeds.partials, factor))


_FACTORS = (
    (sp.S.Zero, "without"),
    (sp.S.NegativeOne, "with the wrong sign of"),
    (sp.Rational(1, 2), "with one half of"),
    (sp.Integer(2), "with twice"),
)


def _kinetic(m: Mechanics, parts: Sequence[Inertia], speeds: QuasiVelocities) -> tuple[sp.Expr, ...]:
    """d/dt ∂T*/∂u_s − Σ_k B_ks ∂T*/∂q_k in the velocities and accelerations of the coordinates."""
    slots, own = m.slots, speeds.slots.velocities
    rates = [speeds.rates[v] for v in slots.velocities] + [sp.S.One]
    energy = sp.S.Zero
    for part in parts:
        for a, weight in enumerate(part.weights):
            along = sp.Add(*(c[a] * rate for c, rate in zip(part.columns, rates, strict=True)))
            energy += part.factor * weight * along**2 / 2
    meant = {prime(u): e for u, e in speeds.definitions.items()}
    slopes = [partial(energy, q).xreplace(meant) for q in slots.coordinates]
    equations = []
    for s, u in enumerate(own):
        momentum = sp.diff(energy, u).xreplace(meant)
        gradient = sp.Add(*(row[s] * slope for row, slope in zip(speeds.partials, slopes, strict=True)))
        equations.append(slots.time_derivative(momentum) - gradient)
    return tuple(equations)
