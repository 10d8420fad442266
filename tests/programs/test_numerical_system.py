"""A motion in numbers."""

from __future__ import annotations

import math

import pytest

from lagrange.programs.numerical_system import NumericalSystem
from tests.support.shared import in_numbers


def test_the_rate_of_a_pendulum() -> None:
    made = in_numbers("ex11-ideal-pendulum", "angle")
    values = {s.name: x for s, x in made.start.values.items()}
    rate = NumericalSystem(made.states, made.start.values).rate(0.0, 0.4, -0.2)
    assert list(rate) == pytest.approx([-0.2, -values["g"] / values["l"] * math.sin(0.4)])
