"""Equations of an answer about the forces of impending motion."""

from __future__ import annotations

import pytest

from lagrange.answers.friction.impending import forces_put_in, names_of_forces
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from tests.support.shared import solved


def test_reactions_and_friction_have_names() -> None:
    solution = solved("ladder-on-rough-ground")
    [motion] = [m for v in solution.views for m in v.impending or ()]
    assert solution.law is not None
    assert {s.name for s in names_of_forces(motion, solution.law.newton)} == {"N_A", "N_B", "F_below", "F_above"}
    assert {s.name for s in names_of_forces(motion, None)} == {"F_below", "F_above"}


@pytest.mark.parametrize(
    ("line", "holds"),
    [
        ("N_B = mu*N_A", True),  # across; up and down N_A + nu N_B = W
        ("N_A + nu*N_B = W", True),
        ("F_below = mu*N_A", True),
        ("N_A*(1 + mu*nu) = W", True),
        ("N_B = nu*N_A", False),
        ("N_A = W", False),
        ("F_below = nu*N_A", False),
        ("N_A*tan(theta) = 2*N_B", False),  # no balance of moments
    ],
)
def test_equations_of_the_ladder_hold_or_not(line: str, holds: bool) -> None:
    """At its limit the ladder has N_A = W/(1 + μν) and N_B = μ N_A."""
    solution = solved("ladder-on-rough-ground")
    [motion] = [m for v in solution.views for m in v.impending or ()]
    assert solution.law is not None
    position = "tan(theta) = 2*mu/(1 - mu*nu)"
    stated = [Fragment.of(line), Fragment.of(position)]
    judged = forces_put_in(stated, motion, solution.law.newton, reference_of_solution(solution))
    assert judged.holds is holds
    assert [f.text for f in judged.positions] == [position]
    assert bool(judged.balance) is not holds  # what holds is an identity with the forces put in
