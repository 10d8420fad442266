"""The values of a solved problem, with the units of the forces that it names.

A named reaction is a force (`dynamics.newton`), whatever the dimension of its constraint. It is in N even where a
number in a question, `x = 2 m`, hides the unit of its formula. Nothing is said of a name that stands for a multiplier.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from lagrange.core.units import unit_of
from lagrange.mechanics.results import Solution
from lagrange.problem.values import values_of

if TYPE_CHECKING:
    from lagrange.values.quantities import Values


def values_in(solution: Solution) -> Values | None:
    """The values of the problem that was solved; None where it has none."""
    values, newton = values_of(solution.problem), unit_of("N")
    if values is None or newton is None or solution.law is None or not values.units:
        return values
    forces = {r.force: newton.dimension for r in solution.law.newton.reactions if r.named}
    return replace(values, units={**forces, **values.units})
