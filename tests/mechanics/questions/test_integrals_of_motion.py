"""First integrals with their values at the start."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.mechanics.questions.results import How
from lagrange.mechanics.solution import solve
from tests.mechanics.test_book_questions import Read

CENTRE = """
title: Straight up
parameters: [m, a, K]
coordinates: [r]
particles: {P: {mass: m, position: r*i}}
forces: {attraction: {potential: -m*K/r}}
initial: {r: a, r': sqrt(K/a)}
ask: {time: {quantity: t, when: r' = 0}}
"""


def test_the_time_to_a_turning_point_that_the_energy_gives(problem: Read) -> None:
    [time] = solve(problem(CENTRE)).asked
    assert time.how is How.EXACT
    value = time.branches[0].rhs
    assert float(value.xreplace(dict.fromkeys(value.free_symbols, sp.S.One))) == pytest.approx(1 + math.pi / 2)
