"""A wrong equation that states one force of constraint: what that force would be."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.references import ReferenceCandidate, reference_of_solution
from lagrange.answers.results.forces import explained_force
from tests.support.shared import solved


def pendulum() -> tuple[ReferenceCandidate, sp.Symbol, sp.Expr]:
    """The candidate in the file's coordinates, λ, and its value."""
    solution = solved("ex11-ideal-pendulum")
    candidate = reference_of_solution(solution).candidates[0]
    assert solution.own.dynamics is not None
    assert solution.own.dynamics.reactions is not None
    value = solution.own.dynamics.reactions.multipliers["rod"]
    [multiplier] = candidate.multipliers
    assert value is not None
    return candidate, multiplier, value


@pytest.mark.parametrize(
    ("factor", "said"),
    [
        (2, "this is the reaction for m twice as large"),
        (3, "only a number is wrong in it: the force is 1/3 times as large"),
        (sp.Rational(7, 5), ""),  # no ratio that is a usual mistake
    ],
)
def test_a_multiple_of_the_force_is_named(factor: sp.Expr, said: str) -> None:
    candidate, multiplier, value = pendulum()
    assert explained_force(multiplier - factor * value, candidate) == said


def test_an_equation_of_motion_states_no_force() -> None:
    candidate, multiplier, value = pendulum()
    acceleration = candidate.configuration.slots.accelerations[0]
    assert explained_force(multiplier - 2 * value + acceleration, candidate) == ""
    assert explained_force(value, candidate) == ""
