"""The state in which a system is drawn satisfies its constraints."""

from __future__ import annotations

import pytest

from tests.support.drawings import DRAWN, evaluated, system_of


@pytest.mark.parametrize("name", DRAWN)
def test_a_pose_satisfies_the_constraints(name: str) -> None:
    system = system_of(name)
    for f in system.configuration.finite_constraints:
        assert abs(evaluated(f, system)) < 1e-8
