"""Results in numbers, in JSON."""

from __future__ import annotations

import pytest

import lagrange
from lagrange.document.math_writer import text
from lagrange.mechanics.results import values_in
from lagrange.mechanics.solution import solve
from lagrange.render.json_numbers import asked_number, numbers_of_branches, quantity

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


SLED = """
title: Sled on a mound
parameters: {m: 30 kg, R: 4 m, g: 9.81 m/s^2}
frame: {type: polar, coordinates: [r, phi]}
coordinates: [r, phi]
particles: {S: {mass: m, position: r*e_r}}
constraints: {mound: {equation: r >= R, reaction: N}}
gravity: -g*j
generalized_coordinates: {angle: {coordinates: [phi]}}
initial: {phi: pi/2, phi': 0}
ask:
  speed: {quantity: "R*phi'", when: "N = 0"}
"""


def test_of_a_motion_to_either_side_each_branch_has_its_number_and_the_positive_one_is_the_answer() -> None:
    solution = solve(lagrange.loads(SLED), complete=False)
    [asked] = solution.asked
    values = values_in(solution)
    assert values is not None
    speed = (2 * 9.81 * 4 / 3) ** 0.5
    assert asked_number(asked, values, text) == {"number": pytest.approx(speed), "unit": "m/s"}
    numbers = [entry["number"] for entry in numbers_of_branches(asked, values, text)]
    assert sorted(numbers) == pytest.approx([-speed, speed])
