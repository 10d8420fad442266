"""The figure of a web page: what moves, and why something stays still.

How far a number can be moved.

The surface of a bowl.
"""

from __future__ import annotations

import sympy as sp

import lagrange
from lagrange.animation.figure import Still, coordinate_slider, parameter_slider, surfaces
from lagrange.animation.moving import moving_figure
from lagrange.mechanics.solution import solve
from tests.support.shared import loaded, reported


def test_what_cannot_be_drawn_stays_still_and_says_why():
    still = moving_figure(reported("form-in-two-variables", complete=False).solution)
    assert isinstance(still, Still)
    assert still.reason


# Sliders


def test_the_number_lies_between_the_ends_and_a_length_stays_positive() -> None:
    problem = loaded("ex11-ideal-pendulum")
    length = parameter_slider(sp.Symbol("l", positive=True), problem, 1.5, angle=False)
    x = coordinate_slider(problem.slots.coordinates[0], problem, 0.3, angle=False)
    assert 0 < length.low < 1.5 < length.high
    assert x.low < 0 < 0.3 < x.high


# Samples


BOWL = """
title: Bowl
parameters: [a, b, c]
coordinates: [x, y, z]
particles: {P: {position: x*i + y*j + z*k}}
constraints: {bowl: z = a*(x - c)^2 + b*y^2}
find: constraints
"""


def test_a_surface_is_solved_for_its_height_and_has_its_bottom() -> None:
    solution = solve(lagrange.loads(BOWL), complete=False)
    [((x, y, height), along, shift)] = surfaces(solution.own.configuration)
    assert along == (x, y)
    a, b, c = (p.symbol for p in solution.problem.parameters)
    assert (height - a * (x - c) ** 2 - b * y**2).expand() == 0
    assert shift == c
