"""How far a number can be moved."""

from __future__ import annotations

import sympy as sp

from lagrange.animation.sliders import coordinate_slider, parameter_slider
from tests.support.shared import loaded


def test_the_number_lies_between_the_ends_and_a_length_stays_positive() -> None:
    problem = loaded("ex11-ideal-pendulum")
    length = parameter_slider(sp.Symbol("l", positive=True), problem, 1.5, angle=False)
    x = coordinate_slider(problem.slots.coordinates[0], problem, 0.3, angle=False)
    assert 0 < length.low < 1.5 < length.high
    assert x.low < 0 < 0.3 < x.high
