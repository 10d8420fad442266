"""What drives a system periodically.

A driven system, still and moved.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.symbols import prime, t
from lagrange.mechanics.equilibrium.drives import drive_of, forced_systems, harmonics, time_beside_harmonics, undriven
from tests.support.shared import loaded


def test_the_frequency_of_a_drive() -> None:
    problem = loaded("damped-oscillator")
    [frequency] = harmonics(problem)
    assert t not in frequency.free_symbols
    assert not time_beside_harmonics(problem)
    drive = drive_of(problem, frequency, frozenset())
    assert harmonics(undriven(problem, drive)) == set()


def test_a_pendulum_is_not_driven() -> None:
    assert harmonics(loaded("ex11-ideal-pendulum")) == set()
    assert isinstance(t, sp.Symbol)


# Forced systems


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
