"""Conditions on a problem of statics, and the checks of equilibria."""

from __future__ import annotations

from dataclasses import replace

import pytest

from lagrange.mechanics.equilibrium.checks import check_equilibrium
from tests.support.shared import solved


@pytest.mark.parametrize("name", ["roberval-balance", "inverted-pendulum-springs"])
def test_equilibria_hold_and_a_moved_one_does_not(name: str) -> None:
    solution = solved(name)
    [resting, *_] = [v.equilibrium for v in solution.views if v.equilibrium is not None]
    checks = check_equilibrium(resting, resting)
    assert checks
    assert all(c.passed for c in checks)
    assert replace(resting) == resting
