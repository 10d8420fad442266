"""The equations of motion for JSON: with multipliers, by Lagrange, in quasi-velocities; what they conserve."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.mechanics.dynamics.multipliers import LagrangeMotion

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.conservation import Conserved
    from lagrange.mechanics.dynamics.equations import EquationsOfMotion
    from lagrange.mechanics.dynamics.motion import Motion
    from lagrange.mechanics.dynamics.quasi_verification import InSpeeds

Write = Callable[[Any], str]


def motion(dynamics: Motion, write: Write) -> dict[str, Any]:
    """The equations, what must not vanish, and the equations with multipliers where constraints are left."""
    found: dict[str, Any] = {
        "equations": _equations(dynamics.written, write),
        "conditions": _nonzero(dynamics.written.conditions, write),
    }
    if dynamics.written.closed is not None:
        velocities = dynamics.written.closed.velocities
        found["through_velocities"] = {v.name: write(e) for v, e in velocities.items()}
    if dynamics.with_multipliers is not None:
        found["equations_with_multipliers"] = [
            f"{write(a)} = {write(b)}" for a, b in dynamics.with_multipliers.equations
        ]
    return found


def _nonzero(excluded: Sequence[sp.Expr], write: Write) -> list[str]:
    return [f"{write(e)} ≠ 0" for e in excluded]


def _equations(motion: EquationsOfMotion, write: Write) -> list[str]:
    """The equations of motion and the constraints that complete them."""
    slots = motion.configuration.slots
    rows = (r.velocity_form(slots) if r.finite is None else r.finite for r in motion.completing)
    return [f"{write(e)} = 0" for e in (*(e.expression for e in motion.final), *rows)]


def speeds(found: InSpeeds, write: Write) -> dict[str, Any]:
    """The quasi-velocities, the kinematic equations, what must not vanish, the equations of motion in them.

    `kinematic` has q' and `rates` u', by name; of too few quasi-velocities, `completed_by` says whose velocities
    complete them.
    """
    quasi, equations = found.velocities, found.equations
    result: dict[str, Any] = {
        "definitions": {u.name: write(e) for u, e in quasi.definitions.items()},
        "kinematic": {v.name.rstrip("'"): write(e) for v, e in quasi.kinematic.items()},
        "conditions": _nonzero(equations.conditions if equations else quasi.pivots, write),
    }
    if quasi.completing:
        result["completed_by"] = [q.name for q in quasi.completing]
    if equations is not None:
        result["equations"] = [f"{write(e)} = 0" for e in equations.expressions]
        if equations.rates is not None:
            result["rates"] = {u.name.rstrip("'"): write(value) for u, value in equations.rates.items()}
    return result


def by_lagrange(motion: EquationsOfMotion, write: Write) -> dict[str, Any]:
    """T, V, p_k, the Q_k of what is not in V, and Lagrange's equations; left out where these are not the method."""
    if not isinstance(motion, LagrangeMotion):
        return {}
    found, coordinates = motion.principle, motion.configuration.slots.coordinates

    def each(values: Sequence[sp.Expr]) -> dict[str, str]:
        return {q.name: write(v) for q, v in zip(coordinates, values, strict=True)}

    result: dict[str, Any] = {
        "kinetic_energy": write(found.kinetic),
        "potential_energy": write(found.potential),
        "momenta": each(found.momenta),
        "generalized_forces": each(found.applied),
    }
    if found.has_quasi_coordinates:
        result["quasi_coordinate_terms"] = each(found.quasi)
    return {"lagrange": result}


def integrals(conserved: Conserved, write: Write) -> list[dict[str, Any]]:
    """The integrals; last the energy where it is not conserved, with its rate (null: undecided)."""
    found: list[dict[str, Any]] = []
    for i in conserved.integrals:
        one: dict[str, Any] = {"kind": i.quantity.value}
        if i.coordinate is not None:
            one["coordinate"] = i.coordinate.name
        one |= {"expression": write(i.expression), "because": i.because.value}
        if i.displacement:
            one["displacement"] = {q.name: write(x) for q, x in i.displacement.items()}
        if i.multipliers:
            one["multipliers"] = [write(m) for m in i.multipliers]
        found.append(one)
    if conserved.energy is not None:
        rate = conserved.energy.rate
        expression = write(conserved.energy.expression)
        found.append({"kind": "energy", "expression": expression, "rate": None if rate is None else write(rate)})
    return found
