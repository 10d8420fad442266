"""First integrals with their values at the start."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.mechanics.questions.integrals_of_motion import multiple_of_integral, parameter_of_integral
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


ORBIT = """title: Escape
parameters: {m: positive, mu: positive, a: positive, v: positive, b: positive}
coordinates: [r, phi]
particles: {S: {mass: m, position: "r*cos(phi)*i + r*sin(phi)*j"}}
forces: {attraction: {potential: -m*mu/r}}
initial: {r: a, phi: 0, r': 0, phi': v/a}
"""


@pytest.mark.parametrize(
    ("when", "speed"),
    [
        ("energy = 0", "sqrt(2*mu/a)"),  # ½ v² = μ/a
        ("2*energy = -m*mu/b", None),  # twice the integral is not seen to be one
        ("energy = -m*mu/(2*b)", "sqrt(mu*(2*b - a)/(a*b))"),  # vis viva, v² = μ (2/a − 1/b)
        ("m*r^2*phi' = m*b*a", "b"),  # the angular momentum
    ],
)
def test_the_speed_for_which_an_integral_has_a_value(problem: Read, when: str, speed: str) -> None:
    [asked] = solve(problem(ORBIT + f'ask: {{escape: {{quantity: v, when: "{when}"}}}}\n')).asked
    if speed is None:
        assert not asked.branches
        return
    assert asked.how is How.EXACT
    [branch] = asked.branches
    there = {"m": 2.0, "mu": 3.0, "a": 1.5, "b": 4.0}
    found = branch.rhs.evalf(subs={s: there[s.name] for s in branch.rhs.free_symbols})
    assert float(found) == pytest.approx(float(sp.sympify(speed).evalf(subs=there)))


def test_what_is_no_integral_is_left_to_others() -> None:
    x, v, c = sp.symbols("x v c", positive=True)
    assert multiple_of_integral(x, x, [], {x}) is None
    assert parameter_of_integral([v - c], c, c, [], {v}) is None
    assert parameter_of_integral([v], None, c, [], {v}) is None


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


ROUGH_RING = """title: Ring on a rough hoop
parameters: {m: positive, R: positive, g: positive, mu: positive}
gravity: -g*j
coordinates: [r, theta]
particles: {ring: {mass: m, position: r*cos(theta)*i - r*sin(theta)*j}}
constraints: {hoop: {equation: r = R, reaction: N, by: wire}}
forces: {rub: {friction: mu, constraint: hoop, on: ring, slip: positive, contact: negative}}
initial: {theta: 0, theta': 0}
ask: {speed: {quantity: "R*theta'", when: theta = pi/2}}
"""


def test_a_coordinate_that_is_held_has_no_integral_to_tell(problem: Read) -> None:
    """r'' = 0 tells nothing where r = R. By hand, v² = 2 g R (e^{πμ} − 3μ − 2μ² e^{πμ}) e^{−πμ}/(1 + 4μ²)."""
    [speed] = solve(problem(ROUGH_RING)).asked
    assert [i.coordinate.name for i in speed.integrals if i.coordinate is not None] == ["theta"]
    at = {"R": 2, "g": 10, "mu": 0.1}
    value = float(speed.branches[0].rhs.xreplace({s: at[s.name] for s in speed.branches[0].rhs.free_symbols}))
    e = math.exp(0.1 * math.pi)
    assert value**2 == pytest.approx(40 * (e - 0.3 - 0.02 * e) / e / 1.04)


AGAINST_A_WALL = """title: Two blocks and a spring, one against a wall
parameters: {m_1: {value: 1 kg}, m_2: {value: 2 kg}, k: {value: 300 N/m}, d: {value: 5 cm}, l: {value: 20 cm}}
coordinates: [x, y]
particles: {A: {mass: m_1, position: x*i}, B: {mass: m_2, position: y*i}}
constraints: {wall: {equation: x >= 0, reaction: N}}
forces: {spring: {spring: k, between: [A, B], length: l}}
initial: {x: 0, x': 0, y: l - d, y': 0}
ask: {v: {quantity: "y'", when: N = 0}, time: {quantity: t, when: N = 0}}
"""


def test_the_spring_between_a_held_block_and_another_has_one_side(problem: Read) -> None:
    """By hand: v = d √(k/m), after a quarter of a period; l/d > 1 has no arc cosine, and ends nothing."""
    speed, time = solve(problem(AGAINST_A_WALL)).asked
    names = {s.name: s for s in speed.branches[0].rhs.free_symbols}
    assert sp.simplify(speed.branches[0].rhs - names["d"] * sp.sqrt(names["k"] / names["m_2"])) == 0
    assert not speed.branches[0].conditions
    [quarter] = time.branches
    assert not quarter.conditions
    assert float(quarter.rhs.xreplace({s: {"m_2": 2, "k": 300}[s.name] for s in quarter.rhs.free_symbols})) == (
        pytest.approx(math.pi / 2 * math.sqrt(2 / 300))
    )
