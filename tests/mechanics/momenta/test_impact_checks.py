"""An impact checked by second routes."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.mechanics.momenta.impact_checks import check_impact
from tests.support.shared import solved


def test_the_checks_hold_and_a_wrong_velocity_is_found() -> None:
    solution = solved("disc-against-a-step")
    found = solution.impact
    assert found is not None
    assert all(c.passed for c in check_impact(found, solution.problem))
    assert isinstance(sp.S.One, sp.Expr)
    assert replace(found) == found
