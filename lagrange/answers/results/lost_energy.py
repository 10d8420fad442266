"""Wrong answers to questions about a motion that loses energy: is it taken to be conserved?

A ball that slips until it rolls, and links of a chain that are jerked up from rest, lose energy. Where each force other
than friction and the like depends on the coordinate alone whose equation it is in, Q_k(q_k), an answer that satisfies

    T + V = T_0 + V_0 ,      V = −Σ_k ∫ Q_k dq_k ,

at the event that is asked about, where the right answer does not, comes from this equation.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.algebra.forms.antiderivatives import antiderivative
from lagrange.answers.models.forces import name_of
from lagrange.answers.models.mechanics import AppliedForceKind, Mechanics
from lagrange.answers.references import ReferenceCandidate
from lagrange.core.symbols import base, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.questions.results import Asked

_LOSING = (AppliedForceKind.FRICTION, AppliedForceKind.DAMPER, AppliedForceKind.REACTIVE)


def explained_by_lost_energy(claim: sp.Expr, asked: Asked, candidates: Sequence[ReferenceCandidate]) -> str:
    """Whether a wrong value follows if the energy is taken to be conserved, in a sentence; empty if not."""
    for candidate in candidates:
        m = candidate.parts() if candidate.choice == asked.choice and candidate.mechanics is not None else None
        losing = m.of_kind(*_LOSING) if m is not None else ()
        if m is None or not losing or any(mass.leaves for mass in m.configuration.variable_masses):
            continue
        try:
            energy = _energy(m)
            if energy is None:
                return ""
            start = _at((s.symbol - s.value for s in asked.initial), energy, m.configuration)
            right = [v for b in asked.branches for v in b.values]
            ends = [_at_event(v, asked, energy, m.configuration) for v in (claim, *right)]
            kept = [is_zero(sp.expand(end - start).xreplace(dict(candidate.values))) is True for end in ends]
            if kept[0] and not any(kept[1:]):
                by = ", ".join(dict.fromkeys(map(name_of, losing)))
                lost = "in the jerks of the mass that joins" if by.startswith("the reactive") else f"by {by}"
                return f"the energy is taken to be conserved, and some of it is lost {lost}"
        except (DivisionByZeroError, NoPointError, UnsupportedError):
            continue
    return ""


def _energy(m: Mechanics) -> sp.Expr | None:
    """T + V without the forces that lose energy; None if another one depends on more than its own coordinate."""
    potential = sp.S.Zero
    for f in m.forces:
        for q, share in zip(m.slots.coordinates, f.shares, strict=True):
            if f.kind in _LOSING or share == 0:
                continue
            if any(s == t or (s != q and base(s) in m.slots.coordinates) for s in share.free_symbols):
                return None
            work = antiderivative(sp.expand(f.factor * share), q)
            if work is None:
                return None
            potential -= work
    return kinetic_energy(m.configuration) + potential


def _at_event(value: sp.Expr, asked: Asked, energy: sp.Expr, configuration: Configuration) -> sp.Expr:
    """The energy at the event of a question if what is asked for has a value."""
    quantity = asked.question.quantity
    if quantity.is_Pow and quantity.exp == 2:
        quantity, value = quantity.base, sp.sqrt(value)
    return _at((quantity - value, *(c.lhs - c.rhs for c in asked.question.when)), energy, configuration)


def _at(zeros: Iterable[sp.Expr], energy: sp.Expr, configuration: Configuration) -> sp.Expr:
    """The energy where some expressions vanish, which are solved for velocities or coordinates one after the other."""
    slots = configuration.slots
    rows = (row.velocity_form(slots) for row in configuration.rows if row.nonlinear is None)
    rule: dict[sp.Expr, sp.Expr] = {}
    for zero in (*zeros, *rows):
        residual = sp.expand(zero.xreplace(rule))
        for s in (*slots.velocities, *slots.coordinates):
            slope = residual.coeff(s)
            if slope != 0 and not sp.expand(residual - slope * s).has(s):
                solved = {s: -(residual - slope * s) / slope}
                rule = {k: v.xreplace(solved) for k, v in rule.items()} | solved
                break
    return energy.xreplace(rule)
