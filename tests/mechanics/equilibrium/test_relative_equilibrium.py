"""Equilibria of the equations of motion."""

from __future__ import annotations

from lagrange.mechanics.equilibrium.relative_equilibrium import branches_at_rest, is_time, without_time
from tests.support.shared import solved


def test_a_bead_on_a_turning_hoop_is_at_rest_at_the_poles_and_beside_them() -> None:
    linear = next(v.linearization for v in solved("bead-on-rotating-hoop").views if v.linearization is not None)
    branches, complete = branches_at_rest(linear.equilibrium)
    assert complete
    assert len(branches) == len(linear.branches) >= 3


def test_what_is_time() -> None:
    configuration = solved("ex11-ideal-pendulum").own.configuration
    x = configuration.slots.coordinates[0]
    assert not is_time(x, configuration)
    assert without_time(x**2 + 1, configuration) == x**2 + 1
