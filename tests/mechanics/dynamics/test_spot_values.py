"""Values for a calculator: sensible, and they satisfy the equations."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]
PENDULUM = """
title: Pendulum
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: g*j
"""


def test_a_spot_value_satisfies_the_equations(problem: Read) -> None:
    text = f"{PENDULUM}generalized_coordinates: {{angle: {{coordinates: [th], substitute: {{x: l*sin(th), y: l*cos(th)}}}}}}\n"
    [choice] = solve(problem(text)).choices
    assert choice.spot is not None
    values = {s.name: v for s, v in choice.spot.values.items()}
    [acceleration] = choice.spot.accelerations.values()
    assert abs(acceleration + values["g"] / values["l"] * sp.sin(values["th"])) < 1e-5


def test_spot_values_are_sensible(problem: Read) -> None:
    """An angle of an incline is less than a right one, and of a + b cos ωt the first is the larger."""
    text = """
title: A block on an incline
parameters: [m, g, a, b, alpha, omega]
coordinates: [x]
particles: {P: {mass: m, position: "[x*cos(alpha), x*sin(alpha) + b*cos(omega*t) + a*x^2]"}}
gravity: -g*j
"""
    spot = solve(problem(text)).own.spot
    assert spot is not None
    values = {s.name: v for s, v in spot.values.items()}
    assert 0 < values["alpha"] < 1.5
    assert values["a"] > values["b"] > 0
    assert values["omega"].is_Integer


@pytest.mark.parametrize(("long", "short"), [("l", "c"), ("c", "l")])
def test_either_of_two_letters_may_have_to_be_the_larger(problem: Read, long: str, short: str) -> None:
    text = f"""
title: Offset crank
parameters: [m, l, c, g]
coordinates: [s, y]
particles: {{P: {{mass: m, position: s*i + y*j}}}}
gravity: -g*j
constraints: {{rod: (s - sqrt({long}^2 - {short}^2))^2 + y^2 = {long}^2}}
"""
    spot = solve(problem(text)).own.spot
    assert spot is not None
    values = {s.name: v for s, v in spot.values.items()}
    assert values[long] > values[short] > 0


TRACK = """
title: A block on a circular track
parameters: [m, g, R, mu]
coordinates: [x, y]
particles: {{P: {{mass: m, position: x*i + y*j}}}}
constraints: {{track: {{equation: x^2 + y^2 = R^2, reaction: N, by: surface}}}}
gravity: -g*j
forces: {{rub: {{friction: mu, constraint: track, on: P, slip: {0}, contact: {1}}}}}
"""


@pytest.mark.parametrize("slip", ["positive", "negative"])
@pytest.mark.parametrize("contact", ["positive", "negative"])
def test_a_spot_value_slips_and_presses_as_the_file_says(problem: Read, slip: str, contact: str) -> None:
    """N = m (g y − x'² − y'²)/R along the outer normal, by hand; the slip is counted along x."""
    spot = solve(problem(TRACK.format(slip, contact))).own.spot
    assert spot is not None
    v = {s.name: float(e) for s, e in spot.values.items()}
    assert (v["x'"] > 0) is (slip == "positive")
    assert (v["g"] * v["y"] - v["x'"] ** 2 - v["y'"] ** 2 > 0) is (contact == "positive")


@pytest.mark.parametrize("sense", ["positive", "negative"])
def test_a_spot_value_has_springs_on_the_side_that_the_file_says(problem: Read, sense: str) -> None:
    text = f"""
title: Two masses
parameters: [m, c, l, L]
coordinates: [u, v]
particles: {{P: {{mass: m, position: u*i}}, Q: {{mass: m, position: v*i}}}}
forces:
  middle: {{spring: c, between: [P, Q], length: l, sense: {sense}}}
"""
    spot = solve(problem(text)).own.spot
    assert spot is not None
    v = {s.name: float(e) for s, e in spot.values.items()}
    assert (v["v"] - v["u"] > 0) is (sense == "positive")


def test_a_state_in_which_the_constraints_are_dependent_is_not_taken(problem: Read) -> None:
    """Rods of lengths 2 and 1 in one line: a velocity of their end along it is impossible, up to rounding."""
    text = """
title: Double pendulum
parameters: [m, M, g]
coordinates: [x, y, X, Y]
particles: {A: {mass: m, position: x*i + y*j}, B: {mass: M, position: X*i + Y*j}}
constraints: {lower: "1 = (X - x)^2 + (Y - y)^2", upper: "(x^2 + y^2 - 4)/3 = 0"}
gravity: -g*j
"""
    spot = solve(problem(text)).own.spot
    assert spot is not None
    assert all(abs(v) < 100 for v in spot.values.values())


def test_numbers_are_those_of_the_figure(problem: Read) -> None:
    spot = solve(problem(f"{PENDULUM}figure: {{at: {{l: 1.3}}}}\n")).own.spot
    assert spot is not None
    assert {s.name: v for s, v in spot.values.items()}["l"] == sp.Rational(13, 10)


def test_angles_are_whole_degrees(problem: Read) -> None:
    text = f"{PENDULUM}generalized_coordinates: {{angle: {{coordinates: [th], substitute: {{x: l*sin(th), y: l*cos(th)}}}}}}\n"
    [choice] = solve(problem(text)).choices
    assert choice.spot is not None
    assert {s.name: v for s, v in choice.spot.values.items()}["th"] == sp.pi / 6
