"""Results in numbers, in JSON."""

from __future__ import annotations

import lagrange
from lagrange.document.math_writer import text
from lagrange.mechanics.results import values_in
from lagrange.mechanics.solution import solve
from lagrange.render.json_numbers import quantity

WEIGHT = """
title: Weight on a spring
parameters: {m: 2 kg, k: 400 N/m, g: 9.81 m/s^2}
coordinates: {x: {unit: m}}
particles: {P: {mass: m, position: x*j}}
gravity: -g*j
forces: {spring: {potential: k*x^2/2}}
"""


def test_a_value_has_its_number_and_unit() -> None:
    solution = solve(lagrange.loads(WEIGHT), complete=False)
    m, k, g = (p.symbol for p in solution.problem.parameters)
    found = quantity(m * g / k, values_in(solution), text)
    assert found["unit"] == "m"
    assert abs(float(found["number"]) - 0.04905) < 1e-9
    assert quantity(None, values_in(solution), text) == quantity(m, None, text) == {}
