"""Mistakes with a mass that varies: the momentum of what leaves or joins, and a mass taken as constant.

m a = F + u dm/dt, with the velocity u of the exchanged mass relative to the body: the last term is a reactive force,
and T is formed with the mass of the instant, as if it were constant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.models.mechanics import (
    AppliedForceKind,
    ForceShare,
    Inertia,
    Mechanics,
    Variation,
    called,
    written,
)
from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Load
from lagrange.mechanics.constraints.variable_mass import REACTIVE
from lagrange.mechanics.dynamics.lagrangian import share_of_load


def exchanged_momentum(m: Mechanics) -> Iterator[Variation]:
    """Another velocity of the mass that leaves or joins, or a variable mass in T whose exchange carries no momentum."""
    configuration = m.configuration
    places = {p.name: p for p in configuration.points}
    for mass in configuration.variable_masses:
        point = places[mass.name]
        loads = [f for f in configuration.loads if f.on == mass.name and f.name == REACTIVE]
        load = loads[0] if loads else Load(REACTIVE, mass.name, Vector.zero(), point.position)
        place = f"the momentum of the mass that {'leaves' if mass.leaves else 'joins'} {called(mass.name)}"
        carried, given = point.velocity * -mass.rate, mass.velocity * mass.rate
        taken, instead = ("in the fixed axes", "relative to the particle")[:: 1 if mass.relative else -1]
        other = f"for a velocity of the exchanged mass taken {taken} instead of {instead}"
        confused = given + carried if mass.relative else given
        for clause, vector in (
            ("for d(m v)/dt = F, as if the exchanged mass had no velocity", carried),
            (other, confused),
        ):
            if vector.is_zero:
                continue  # without the reactive force, which is a model of its own
            shares = [share_of_load(replace(load, vector=vector), v, configuration) for v in m.slots.velocities]
            yield Variation(clause, place, _with_reactive(m, mass.name, shares))
        clause = "with the derivatives of the varying mass in T, and without the momentum of the exchanged mass"
        yield Variation(clause, place, _with_reactive(m, mass.name, [-s for s in configuration.mass_terms]))


def _with_reactive(m: Mechanics, name: str, shares: Sequence[sp.Expr]) -> Mechanics:
    others = tuple(f for f in m.forces if not (f.kind is AppliedForceKind.REACTIVE and f.on == (name,)))
    return replace(m, forces=(*others, ForceShare(AppliedForceKind.REACTIVE, REACTIVE, tuple(shares), False, (name,))))


def mass_as_at_the_start(m: Mechanics) -> Iterator[Variation]:
    """A mass that changes in time is that at t = 0, with the reactive force as it is."""
    for mass in m.configuration.variable_masses:
        if t not in mass.mass.free_symbols:
            continue
        start = {t: sp.S.Zero}

        def held(i: Inertia, name: str = mass.name) -> Inertia:
            a, b, c = (w.xreplace({t: sp.S.Zero}) for w in i.weights)
            return replace(i, weights=(a, b, c)) if i.name == name and not i.turning else i

        def weight(f: ForceShare, name: str = mass.name) -> ForceShare:
            own = f.kind is AppliedForceKind.WEIGHT and f.on == (name,)
            return replace(f, shares=tuple(s.xreplace({t: sp.S.Zero}) for s in f.shares)) if own else f

        first = written(mass.mass.xreplace(start), m.slots)
        clause = f"for a constant mass {first} of {called(mass.name)}, that at the start"
        yield Variation(clause, f"the mass of {called(mass.name)}, which changes", m.inertia(held).force(weight))
