"""Constraints on velocities with constant coefficients, integrated: s' + R θ' = 0 is s + R θ = const.

Where the coordinates that they determine appear nowhere else, neither does the constant, and the other coordinates are
free: the system then has a Lagrangian and Hamilton's function of these alone. That L may be formed with the velocities
substituted is so only because the constraints can be integrated.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from lagrange.mechanics.constraints.displacements import Elimination, eliminate
from lagrange.mechanics.constraints.kinematics import substituted_configuration
from lagrange.mechanics.dynamics.energies import energies
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.equilibrium.relative_equilibrium import is_time
from lagrange.mechanics.momenta.reduced_form import rates_of_dependent


def integrated(motion: EquationsOfMotion) -> tuple[EquationsOfMotion, Mapping[sp.Symbol, sp.Expr]] | None:
    """The motion in free coordinates, and the others in terms of them, up to constants; None where this is not so."""
    configuration = motion.configuration
    slots, rows = configuration.slots, configuration.rows
    if any(r.finite is not None or r.nonlinear is not None or r.drift != 0 for r in rows):
        return None
    in_rows = {s for r in rows for a in r.coefficients for s in a.free_symbols}
    if any(s in slots.coordinates or is_time(s, configuration) for s in in_rows):
        return None
    stated = energies(configuration)
    used = {s for e in (stated.kinetic, stated.potential, stated.moving, *stated.applied) for s in e.free_symbols}
    absent = [k for k, q in enumerate(slots.coordinates) if q not in used]
    solved = eliminate(rows, len(slots.coordinates), configuration.states, absent)
    if solved.unused or any(k not in absent for k in solved.dependent):
        return None
    dependent = [slots.coordinates[k] for k in solved.dependent]
    free = [slots.coordinates[k] for k in solved.independent]
    expressed = {
        q: sp.Add(*(b * x for b, x in zip(row, free, strict=True)))
        for q, row in zip(dependent, solved.solution, strict=True)
    }
    reduced = substituted_configuration(configuration, configuration.name, tuple(free), expressed, ())
    rates = rates_of_dependent(solved, slots)
    equations = tuple(replace(e, expression=e.expression.xreplace(rates)) for e in motion.final)
    elimination = Elimination(tuple(range(len(free))), (), (), (), (), ())
    return replace(motion, configuration=reduced, elimination=elimination, equations=equations, closed=None), expressed
