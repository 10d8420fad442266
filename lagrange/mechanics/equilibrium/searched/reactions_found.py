"""The reactions at an equilibrium that was found numerically.

There the equations of balance, Q_k + Σ_j λ_j a_jk = 0 in the n coordinates of the file, are linear in the m multipliers
with numbers for coefficients. They are solved by least squares to the digits to which the position is known, and count
only if the residual vanishes to half of them; where constraints are dependent, nothing is said. A position at which a
contact would have to pull, or a string to push, is no equilibrium.

With constraints f_j = 0 the second variation of V at an equilibrium is that of V − Σ_j λ_j f_j in the displacements
that the constraints admit, −Σ_kl ∂(Q_k + Σ_j λ_j a_jk)/∂q_l δq_k δq_l. Stability is read off its eigenvalues where
minors in free displacements, which are not free at every position, have decided nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import mpmath
import sympy as sp

from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.motion import NewtonLaw
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.in_numbers import EquilibriaInNumbers, Position
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
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
        stability = p.stability
        if stability is StabilityVerdict.UNDECIDED and configuration.name == resting.configuration.name:
            stability = _verdict_there(p.coordinates, resting, law.newton, values)
        (slack if backwards else positions).append(replace(p, forces=forces, stability=stability))
    return replace(found, positions=tuple(positions), slack=tuple(slack))


def reactions_found(
    position: Mapping[sp.Symbol, Quantity],
    configuration: Configuration,
    e: Equilibrium,
    newton: Newton,
    values: Values,
) -> dict[sp.Symbol, Quantity]:
    """The named reactions at a position, in newtons where the file has units; empty if they are not determined.

    Of one that is no single force the multiplier, in the unit that the generalized forces give it.

    configuration  the coordinates of the position
    e              the equilibrium in the file's coordinates
    """
    at = _at(position, configuration, values)
    with mpmath.workdps(WORKING_DIGITS):
        try:
            per_force = {r.force: at(r.per_force) for r in newton.reactions if r.given is not None}
        except ValueError:
            return {}
        multipliers = _multipliers(at, e, newton) if per_force else None
        if multipliers is None:
            return {}
        units = {r.force: _unit(r, e, values) for r in newton.reactions}
        return dict(_forces(newton, multipliers, per_force, units))


def _unit(r: Reaction, e: Equilibrium, values: Values) -> str:
    """The unit of a force, or of a multiplier λ with Q_k + λ a_k = 0."""
    if r.single is not None or not values.units:
        return "N" if values.units else ""
    pairs = zip(e.work.forces, r.row.coefficients, strict=True)
    return next((unit for q, a in pairs if q != 0 and a != 0 and (unit := values.unit_of(q / a))), "")


Evaluated = Callable[[sp.Expr], mpmath.mpf]
"""An expression as a number. Raises ValueError where it has none."""


def _at(position: Mapping[sp.Symbol, Quantity], configuration: Configuration, values: Values) -> Evaluated:
    there = {q: x.formula for q, x in position.items()}

    def at(x: sp.Expr) -> mpmath.mpf:
        number = values.put_in(configuration.rewritten(x)).xreplace(there).evalf(WORKING_DIGITS)
        if not (number.is_Float or number.is_Rational):
            raise ValueError(x)
        return mpmath.mpf(str(number))

    return at


def _multipliers(at: Evaluated, e: Equilibrium, newton: Newton) -> mpmath.matrix | None:
    """The multipliers that balance the forces; None if they are not determined."""
    try:
        columns = [[at(r.row.coefficients[k]) for r in newton.reactions] for k in range(len(e.work.forces))]
        a, b = mpmath.matrix(columns), mpmath.matrix([-at(force) for force in e.work.forces])
        multipliers = mpmath.lu_solve(a, b)
        residual = mpmath.norm(a * multipliers - b, mpmath.inf)
    except (ValueError, ZeroDivisionError):
        return None
    is_small = residual <= mpmath.mpf(10) ** (-WORKING_DIGITS // 2) * (1 + mpmath.norm(b, mpmath.inf))
    return multipliers if is_small else None


def _verdict_there(
    position: Mapping[sp.Symbol, Quantity], e: Equilibrium, newton: Newton, values: Values
) -> StabilityVerdict:
    """From the second variation of V in the displacements that the constraints admit at a position."""
    coordinates = e.configuration.slots.coordinates
    rows = [r.row for r in newton.reactions]
    if not rows or len(rows) >= len(coordinates) or any(row.finite is None for row in rows):
        return StabilityVerdict.UNDECIDED
    at = _at(position, e.configuration, values)
    with mpmath.workdps(WORKING_DIGITS):
        multipliers = _multipliers(at, e, newton)
        if multipliers is None:
            return StabilityVerdict.UNDECIDED
        letters = [sp.Dummy() for _ in rows]
        rule = {letter: sp.Float(str(m), WORKING_DIGITS) for letter, m in zip(letters, multipliers, strict=True)}
        sums = [
            sp.Add(q, *(letter * row.coefficients[k] for letter, row in zip(letters, rows, strict=True)))
            for k, q in enumerate(e.work.forces)
        ]
        try:
            second = mpmath.matrix([[-at(f.diff(q).xreplace(rule)) for q in coordinates] for f in sums])
            normals = mpmath.matrix([[at(row.coefficients[k]) for row in rows] for k in range(len(coordinates))])
        except ValueError:
            return StabilityVerdict.UNDECIDED
        admitted = mpmath.qr(normals, mode="full")[0][:, len(rows) :]
        curvatures = mpmath.eigsy(admitted.T * second * admitted, eigvals_only=True)
        small = mpmath.mpf(10) ** (-WORKING_DIGITS // 4) * mpmath.mnorm(second, mpmath.inf)
        if min(curvatures) < -small:
            return StabilityVerdict.UNSTABLE
        return StabilityVerdict.STABLE if min(curvatures) > small else StabilityVerdict.UNDECIDED


def _forces(
    newton: Newton,
    multipliers: mpmath.matrix,
    per_force: Mapping[sp.Symbol, mpmath.mpf],
    units: Mapping[sp.Symbol, str],
) -> Iterator[tuple[sp.Symbol, Quantity]]:
    for r, multiplier in zip(newton.reactions, multipliers, strict=True):
        if r.force in per_force:
            yield r.force, Quantity(sp.Float(str(multiplier / per_force[r.force]), WORKING_DIGITS), units[r.force])
