"""A wrong equation that states one force of constraint, N = m g cos(theta): what that force would be.

Such an equation is compared as the value of a reaction is: with that at rest, with what balances the other forces as if
nothing were accelerated, with that of a changed problem.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.symbols import base

if TYPE_CHECKING:
    from lagrange.answers.references import ReferenceCandidate


def explained_force(equation: sp.Expr, candidate: ReferenceCandidate) -> str:
    """What the stated force is, in a sentence; empty if the equation states none, or that is not found.

    An equation with accelerations is one of motion, and no value of a force.
    """
    forces = [s for s in equation.free_symbols if s in candidate.multipliers]
    coordinates = {*candidate.configuration.slots.coordinates}
    if len(forces) != 1 or equation.free_symbols & {*candidate.configuration.slots.accelerations}:
        return ""
    slope = equation.diff(forces[0])
    if forces[0] in slope.free_symbols or any(base(s) != s and base(s) in coordinates for s in slope.free_symbols):
        return ""
    from lagrange.answers.models.letters import explained_reaction

    return explained_reaction(equation, candidate.models)
