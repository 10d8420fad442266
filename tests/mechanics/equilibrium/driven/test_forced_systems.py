"""A driven system, still and moved."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.symbols import prime, t
from lagrange.mechanics.equilibrium.driven.forced_systems import forced_systems
from tests.support.shared import loaded


def test_the_drive_is_taken_out_and_named() -> None:
    systems = forced_systems(loaded("damped-oscillator"), steady=True)
    assert systems.drive is not None
    [u] = systems.moved.slots.prescribed
    assert systems.small[u].has(sp.cos)
    assert systems.small[prime(u)] == systems.small[u].diff(t)
    assert systems.still.slots.prescribed == ()


def test_without_a_drive_there_is_no_steady_state() -> None:
    with pytest.raises(NotCoveredError):
        forced_systems(loaded("ex11-ideal-pendulum"), steady=True)
