"""The reactions at an equilibrium that was found numerically.

There the equations of balance, Q_k + Σ_j λ_j a_jk = 0 in the n coordinates of the file, are linear in the m multipliers
with numbers for coefficients. They are solved by least squares to the digits to which the position is known, and count
only if the residual vanishes to half of them; where constraints are dependent, nothing is said. A position at which a
contact would have to pull, or a string to push, is no equilibrium.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import mpmath
import sympy as sp

from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.motion import NewtonLaw
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.in_numbers import EquilibriaInNumbers, Position
from lagrange.mechanics.equilibrium.static_reactions import is_one_sided
from lagrange.values.limits import WORKING_DIGITS
from lagrange.values.quantities import Quantity, Values

SMALL_FORCE = sp.Float(10) ** (-WORKING_DIGITS // 2)
"""A force that counts as zero."""


def with_reactions(
    found: EquilibriaInNumbers | None,
    configuration: Configuration,
    resting: Equilibrium | None,
    law: NewtonLaw | None,
    values: Values,
) -> EquilibriaInNumbers | None:
    """The positions that were found numerically with their reactions, those apart at which one would act backwards.

    configuration  the coordinates of the positions
    resting        the equilibrium in the file's coordinates
    """
    if found is None or resting is None or law is None:
        return found
    positions: list[Position] = []
    slack: list[Position] = []
    for p in found.positions:
        if p.branch is not None:
            positions.append(p)
            continue
        forces = reactions_found(p.coordinates, configuration, resting, law.newton, values)
        pressing = [forces[r.force].formula for r in law.newton.reactions if r.force in forces and is_one_sided(r)]
        backwards = any(force < -SMALL_FORCE for force in pressing)
        (slack if backwards else positions).append(replace(p, forces=forces))
    return replace(found, positions=tuple(positions), slack=tuple(slack))


def reactions_found(
    position: Mapping[sp.Symbol, Quantity],
    configuration: Configuration,
    e: Equilibrium,
    newton: Newton,
    values: Values,
) -> dict[sp.Symbol, Quantity]:
    """The named single forces at a position, in newtons where the file has units; empty if they are not determined.

    configuration  the coordinates of the position
    e              the equilibrium in the file's coordinates
    """
    there = {q: x.formula for q, x in position.items()}

    def at(x: sp.Expr) -> mpmath.mpf:
        number = values.put_in(configuration.rewritten(x)).xreplace(there).evalf(WORKING_DIGITS)
        if not (number.is_Float or number.is_Rational):
            raise ValueError(x)
        return mpmath.mpf(str(number))

    with mpmath.workdps(WORKING_DIGITS):
        try:
            columns = [[at(r.row.coefficients[k]) for r in newton.reactions] for k in range(len(e.work.forces))]
            loads = [-at(force) for force in e.work.forces]
            per_force = {r.force: at(r.per_force) for r in newton.reactions if r.named and r.single is not None}
            if not per_force:
                return {}
            a, b = mpmath.matrix(columns), mpmath.matrix(loads)
            multipliers = mpmath.lu_solve(a, b)
            residual = mpmath.norm(a * multipliers - b, mpmath.inf)
        except (ValueError, ZeroDivisionError):
            return {}
        if residual > mpmath.mpf(10) ** (-WORKING_DIGITS // 2) * (1 + mpmath.norm(b, mpmath.inf)):
            return {}
        return dict(_forces(newton, multipliers, per_force, "N" if values.units else ""))


def _forces(
    newton: Newton, multipliers: mpmath.matrix, per_force: Mapping[sp.Symbol, mpmath.mpf], unit: str
) -> Iterator[tuple[sp.Symbol, Quantity]]:
    for r, multiplier in zip(newton.reactions, multipliers, strict=True):
        if r.force in per_force:
            yield r.force, Quantity(sp.Float(str(multiplier / per_force[r.force]), WORKING_DIGITS), unit)
