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


def test_constant_power_integrates_over_the_way(problem: Read) -> None:
    text = """title: Car with constant power
parameters: [m, P, v_1, v_2]
coordinates: [x]
particles: {car: {mass: m, position: x*i}}
forces: {engine: {on: car, vector: "P/x'*i"}}
initial: {x: 0, x': v_1}
ask: {way: {quantity: x, when: x' = v_2}}
"""
    [asked] = solve(problem(text)).asked
    m, p, v_1, v_2 = sp.symbols("m P v_1 v_2", positive=True)
    assert [sp.expand(v - m * (v_2**3 - v_1**3) / (3 * p)) for b in asked.branches for v in b.values] == [0]
