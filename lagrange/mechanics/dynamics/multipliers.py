"""Equations of motion from Lagrange's equations with multipliers.

    L_k = Σ_j λ_j a_jk ,      L_k = d/dt ∂T/∂q_k' − ∂T/∂q_k − Q_k .

Where coordinates are independent there are no multipliers, and L_k = 0. Otherwise the equations of as many coordinates
q_d as there are independent constraints are solved for the multipliers, Σ_j a_jd λ_j = L_d, and those put into the
others. The coordinates q_d are those whose δq were solved for, because the same minor of A must not vanish. Where
that minor is too large to be inverted, or friction holds an |λ| that is not known yet, the equations are combined with
the solved displacements instead, Σ_k L_k δq_k = 0, from which the reactions drop out by A δq = 0. Of constraints that
follow from others the multipliers are left out: they are not determined, and bring no new direction.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

import sympy as sp

from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.trigonometry import Element
from lagrange.core.records import record
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.dynamics.energies import Energies
from lagrange.mechanics.dynamics.equations import EquationOfMotion, EquationsOfMotion, divided, of_independent
from lagrange.mechanics.dynamics.reactions import over_one_denominator


@record
class LagrangeMotion(EquationsOfMotion):
    """The equations of motion of a configuration from its Lagrange equations.

    principle    T, V and the equations with multipliers
    used         indices of the rows that have a multiplier
    multipliers  of these, in textbook form, with accelerations in them; None where they are not written down
    """

    principle: Energies
    used: tuple[int, ...]
    multipliers: tuple[sp.Expr, ...] | None


def lagrange_motion(found: Energies, elimination: Elimination, unknown: Collection[sp.Symbol] = ()) -> LagrangeMotion:
    """Lagrange's equations of a configuration without multipliers; `unknown` are those that friction may have in it."""
    configuration = found.configuration
    used = tuple(n for n in range(len(configuration.rows)) if n not in elimination.unused)
    forces = None if _has(found.applied, unknown) else _multipliers(found, elimination, used)
    if forces is None:
        equations = _combined(found, elimination)
    else:
        free = (_without(found, k, used, forces) for k in elimination.independent)
        equations = _equations(found, elimination, free)
        if any(_is_split(e.expression) for e in equations):
            equations = tuple(map(_tidier, equations, _combined(found, elimination)))
    return LagrangeMotion(
        configuration=configuration,
        principle=found,
        elimination=elimination,
        equations=equations,
        used=used,
        multipliers=None if forces is None else tuple(over_one_denominator(found.textbook.form(f)) for f in forces),
    )


def _equations(found: Energies, elimination: Elimination, free: Iterable[Element]) -> tuple[EquationOfMotion, ...]:
    """The equations of the independent coordinates, divided by what their terms have in common."""
    coordinates = found.configuration.slots.coordinates
    return tuple(divided(found.textbook, coordinates[k], e) for k, e in zip(elimination.independent, free, strict=True))


def _combined(found: Energies, elimination: Elimination) -> tuple[EquationOfMotion, ...]:
    """The same from Σ_k L_k δq_k = 0."""
    return _equations(found, elimination, of_independent(found.coefficients, found.ring, elimination))


def _is_split(expression: sp.Expr) -> bool:
    """Whether sums are left in denominators."""
    return any(p.base.is_Add and p.exp.could_extract_minus_sign() for p in expression.atoms(sp.Pow))


def _tidier(first: EquationOfMotion, second: EquationOfMotion) -> EquationOfMotion:
    """One equation in two forms: with the multipliers put in, or combined; the latter may share a denominator."""
    forms = (first.expression, second.expression)
    split, other = (_is_split(e) for e in forms)
    if split != other:
        return second if split else first
    return second if forms[1].count_ops() < forms[0].count_ops() else first


def _has(forces: Iterable[sp.Expr], unknown: Collection[sp.Symbol]) -> bool:
    """Whether the forces have an |λ| in them."""
    return any(not f.free_symbols.isdisjoint(unknown) for f in forces)


def _without(found: Energies, k: int, used: Sequence[int], forces: Sequence[Element]) -> Element:
    """L_k − Σ_j λ_j a_jk, the λ_j put in."""
    ring, rows = found.ring, found.configuration.rows
    shares = (
        f * ring.from_sympy(rows[n].coefficients[k])
        for n, f in zip(used, forces, strict=True)
        if rows[n].coefficients[k] != 0
    )
    return found.coefficients[k] - ring.total(shares)


def _multipliers(found: Energies, elimination: Elimination, used: Sequence[int]) -> list[Element] | None:
    """The λ_j from Σ_j a_jd λ_j = L_d; None where they are too large."""
    if not used:
        return []
    rows, ring = found.configuration.rows, found.ring
    matrix = [[rows[n].coefficients[d] for n in used] for d in elimination.dependent]
    placeholders = [sp.Dummy(f"L_{d}", real=True) for d in elimination.dependent]
    solved = solved_linear(matrix, placeholders, found.configuration.states)
    if solved is None:
        return None
    values: Mapping[sp.Symbol, Element] = {
        p: found.coefficients[d] for p, d in zip(placeholders, elimination.dependent, strict=True)
    }
    forces = []
    for value in solved:
        if value is None:
            return None
        shares = ((ring.from_sympy(sp.diff(value, p)), left) for p, left in values.items() if value.has(p))
        forces.append(ring.total(share * left for share, left in shares))
    return forces
