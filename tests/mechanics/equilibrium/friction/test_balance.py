"""The balance of forces in rough contacts, solved in an order."""

from __future__ import annotations

import sympy as sp

from tests.mechanics.equilibrium.friction.test_friction_at_rest import ROUGH, Read, solved


def test_the_forces_that_are_found_satisfy_the_balance(problem: Read) -> None:
    [rest] = [v.at_rest for v in solved(problem, ROUGH).views if v.at_rest is not None]
    assert [sp.simplify(e.xreplace(dict(rest.forces))) for e in rest.balance.values()] == [0] * len(rest.balance)
