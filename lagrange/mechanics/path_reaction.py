"""The reaction R on the only particle or body, along a unit vector n:  R·n = m r''·n − F·n, by Newton's law.

No multiplier gives it where coordinates put a particle on its path outright: every constraint then only says what a
coordinate means, and exerts nothing. The force that keeps the particle on its path is along the normal of the path, a
unit vector n with n·∂r/∂q = 0 for every coordinate q.
"""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.results import Solution


@record
class PathReaction:
    """The force of a path on the particle on it.

    normal  the name of the unit vector n in the file
    value   R·n, without accelerations
    """

    normal: str
    value: sp.Expr


def path_reaction(solution: Solution) -> PathReaction | None:
    """The reaction along a normal that the file names; None where multipliers give it, or there is no such normal."""
    configuration = solution.own.configuration
    reactions = None if solution.own.dynamics is None else solution.own.dynamics.reactions
    if len(configuration.points) != 1 or configuration.rotations or configuration.links or reactions is None:
        return None
    if any(m != 0 for m in reactions.multipliers.values()):
        return None
    [point] = configuration.points
    slots, position = configuration.slots, point.position.fixed()
    displacements = [position.map(lambda c, q=q: c.diff(q)) for q in slots.coordinates]  # type: ignore[misc]
    for name, vector in solution.problem.abbreviations.items():
        unit = vector.fixed() if isinstance(vector, Vector) else Vector.zero()
        if is_zero(unit.dot(unit) - 1) is not True or any(is_zero(d.dot(unit)) is not True for d in displacements):
            continue
        value = textbook_form(reaction_along(unit, configuration))
        if set(slots.accelerations) & value.free_symbols:
            continue
        return PathReaction(name, value)
    return None


def reaction_along(unit: Vector, configuration: Configuration) -> sp.Expr:
    """m r''·n − F·n of the only particle or body."""
    [point] = configuration.points
    force = sum((f.vector.fixed() for f in configuration.loads), Vector.zero())
    return point.mass * point.acceleration.fixed().dot(unit) - force.dot(unit)
