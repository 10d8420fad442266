"""Equations of motion without the coordinates that constraints on velocities make dependent (Chaplygin).

With constraints q_D' = B q_I' + b the equations of the independent displacements, D_I + Bᵀ D_D = 0, become

    M q_I'' = f ,        q_D' = B q_I' + b ,        q_D'' = B q_I'' + B' q_I' + b'

substituted. If M and f contain no q_D, the q_I form a system of their own: a disc that rolls on a table tilts, turns
and rolls in the same way wherever it is, a ball on a turntable (b = Ω r) however it is oriented. They are then treated
like free coordinates, except that their energy differs.

Reference: Neimark and Fufaev, Dynamics of Nonholonomic Systems, ch. III.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, islice

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.symbols import Slots, partial
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem
from lagrange.mechanics.constraints.displacements import Elimination, eliminate
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import EquationsOfMotion, of_independent
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.dynamics.matrix_form import MatrixForm
from lagrange.mechanics.limits import MOST_CHOICES_OF_DEPENDENT

ZERO = sp.S.Zero


def reduced_form(motion: EquationsOfMotion) -> MatrixForm:
    """M and f of the independent coordinates, which are those of the configuration of the result.

    Raises NotCoveredError if the constraints are not linear constraints on velocities, or if the independent
    coordinates do not move by themselves.
    """
    configuration = motion.configuration
    names = ", ".join(f"`{r.name}`" for r in configuration.rows)
    if any(r.finite is not None for r in configuration.rows):
        raise NotCoveredError(
            f"steady motions in coordinates that are not free: {names} still acts on them, so they",
            cure="give independent coordinates under `generalized_coordinates`, which satisfy these constraints",
        )
    if any(r.nonlinear is not None for r in configuration.rows):
        raise NotCoveredError(f"steady motions under constraints that are not linear in the velocities ({names})")
    slots, solved = configuration.slots, independent_first(motion)
    ring, form = motion.principle.ring, motion.principle.textbook.form
    rates = rates_of_dependent(solved, slots)
    free = [slots.coordinates[k] for k in solved.independent]
    accelerations = [slots.accelerations[k] for k in solved.independent]
    mass, force = [], []
    for element in of_independent(motion.principle.coefficients, ring, solved):
        substituted = ring.from_sympy(form(element).xreplace(rates))
        coefficients, rest = ring.linear(substituted, accelerations)
        mass.append(tuple(map(form, coefficients)))
        force.append(form(-rest))
    remaining = {s for e in (*force, *(e for row in mass for e in row)) for s in e.free_symbols}
    left = [q for k, q in enumerate(slots.coordinates) if k in solved.dependent and q in remaining]
    if left:
        where = ", ".join(f"`{q}`" for q in left)
        raise NotCoveredError(
            f"steady motions where the motion depends on {where}, of which only the velocity is known,",
            cure="choose other coordinates: the azimuth of a point, for example, and its distance from the axis",
        )
    return MatrixForm(only(configuration, free), tuple(mass), tuple(force), (), ())


def only(configuration: Configuration, coordinates: Sequence[sp.Symbol]) -> Configuration:
    """The configuration in some of its coordinates, which are free."""
    slots = Slots(tuple(coordinates), configuration.slots.prescribed)
    return replace(configuration, constrained=ConstrainedSystem(slots, ()))


def independent_first(motion: EquationsOfMotion) -> Elimination:
    """The displacements of coordinates that occur through their velocities only in terms of the others.

    Which of them depend on the others is open where they are many: of a disc that rolls, x' and y' follow from the
    heading and the spin, which both may be constant, where x' and the heading would give nothing but rolling straight
    on. Those are taken with which T contains fewest coordinates.
    """
    configuration = motion.configuration
    written = [motion.principle.textbook.form(d) for d in motion.principle.coefficients]
    used = {s for e in (*written, *(a for r in configuration.rows for a in r.form)) for s in e.free_symbols}
    coordinates = configuration.slots.coordinates
    absent = [k for k, q in enumerate(coordinates) if q not in used]
    rows, states = configuration.rows, configuration.states
    usual = eliminate(rows, len(coordinates), states, absent)
    if len(absent) <= len(usual.dependent):
        return usual
    kinetic = kinetic_energy(configuration)

    def occurring(solved: Elimination) -> int:
        energy = kinetic.xreplace(rates_of_dependent(solved, configuration.slots))
        return sum(states.is_zero(partial(energy, coordinates[k])) is not True for k in solved.independent)

    fewest, best = occurring(usual), usual
    for first in islice(combinations(absent, len(usual.dependent)), MOST_CHOICES_OF_DEPENDENT):
        if {*first} != {*usual.dependent}:
            other = eliminate(rows, len(coordinates), states, first)
            if (number := occurring(other)) < fewest:
                fewest, best = number, other
    return best


def rates_of_dependent(solved: Elimination, slots: Slots) -> dict[sp.Symbol, sp.Expr]:
    """q_D' and q_D'' in terms of the independent velocities and accelerations."""
    velocities = {
        slots.velocities[d]: sp.Add(
            drift, *(b * slots.velocities[k] for b, k in zip(row, solved.independent, strict=True))
        )
        for d, row, drift in zip(solved.dependent, solved.solution, solved.drift, strict=True)
    }
    accelerations = {
        slots.accelerations[d]: slots.time_derivative(velocities[slots.velocities[d]]).xreplace(velocities)
        for d in solved.dependent
    }
    return velocities | accelerations
