"""What drives a system periodically."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import t
from lagrange.mechanics.equilibrium.driven.drives import drive_of, harmonics, time_beside_harmonics, undriven
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
