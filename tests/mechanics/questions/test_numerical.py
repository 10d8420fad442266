"""Questions answered in numbers."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.mechanics.questions import numerical
from lagrange.mechanics.questions.results import How
from tests.mechanics.questions.test_questions import Read, asked

QUARTER = """
title: Pendulum
axes: {i: right, j: down}
parameters: {m: {value: 1}, l: {value: 1}, g: {value: 9.81}, alpha: {value: 1}}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}
gravity: g*j
initial: {theta: alpha, theta': 0}
ask: {it: {quantity: t, when: theta = 0}}
"""


def test_a_time_that_is_no_elementary_integral_is_found_in_numbers(problem: Read) -> None:
    """A quarter of the period is K(sin α/2) √(l/g); the integral needs no extra."""
    answer = asked(problem, QUARTER)
    assert answer.integrand is not None
    exact = sp.elliptic_k(sp.sin(sp.Rational(1, 2)) ** 2).evalf() / sp.sqrt(9.81)
    assert answer.how is How.NUMERICAL
    assert float(answer.branches[0].rhs) == pytest.approx(float(exact), rel=1e-5)


def test_without_the_extra_it_is_said_which_one_is_missing(problem: Read, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numerical, "is_available", lambda: False)
    answer = asked(problem, QUARTER.replace("when: theta = 0", "when: theta'^2 = 1"))
    assert not answer.answered
    assert answer.needs == "sim"


def test_without_values_such_a_question_is_left_open(problem: Read) -> None:
    answer = asked(
        problem,
        QUARTER.replace("{m: {value: 1}, l: {value: 1}, g: {value: 9.81}, alpha: {value: 1}}", "[m, l, g, alpha]"),
    )
    assert (answer.how, answer.branches, answer.needs) == (None, (), "")
    assert answer.integrand is not None
    assert answer.integrals


SATELLITE = """
title: Ellipse with its far end after hours
parameters: {m: kg, K: {value: 4e14 m^3/s^2}, a: {value: 7000 km}, e: {value: 0.5}}
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
forces: {f: {potential: -m*K/r}}
initial: {r: a, r': 0, phi: 0, phi': sqrt(K*(1 + e)/a^3)}
ask: {it: {quantity: t, when: phi = pi}}
"""


def test_a_slow_motion_is_followed_for_longer(problem: Read) -> None:
    """Half a period of an ellipse is π √((a/(1 − e))³/K)."""
    answer = asked(problem, SATELLITE)
    assert answer.how is How.NUMERICAL
    assert float(answer.branches[0].rhs) == pytest.approx(math.pi * (1.4e7**3 / 4e14) ** 0.5, rel=1e-5)


CRANK = """
title: Slider crank
parameters: {r: {value: 0.1 m}, l: {value: 0.3 m}, w: {value: 150 rad/s}, m: {value: 2 kg}}
coordinates: [x, phi]
particles: {piston: {mass: m, position: x*i}}
constraints: {drive: phi = w*t, rod: "(x - r*cos(phi))^2 + (r*sin(phi))^2 = l^2"}
initial: {phi: 0, x: r + l}
ask: {it: {quantity: "x'", when: phi = 60 deg}}
"""


def test_of_several_exact_answers_that_which_comes_first_is_found(problem: Read) -> None:
    """x = r cos φ + √(l² − r² sin²φ), and not the other side of the crank, where the equations hold as well."""
    answer = asked(problem, CRANK)
    assert answer.how is How.EXACT
    [branch] = answer.branches
    angle, r, l, w = math.pi / 3, 0.1, 0.3, 150
    by_hand = -r * w * math.sin(angle) * (1 + r * math.cos(angle) / math.sqrt(l**2 - (r * math.sin(angle)) ** 2))
    values = {s: sp.Rational(str(v)) for s, v in zip(sp.symbols("r l w", positive=True), (r, l, w), strict=True)}
    assert float(branch.rhs.xreplace(values)) == pytest.approx(by_hand)


HEMISPHERE = """
title: A particle slides off a hemisphere that can move
parameters: {m: 1 kg, M: 1 kg, R: 1 m, g: 9.81 m/s^2}
coordinates: [X, theta]
particles: {H: {mass: M, position: X*i}, P: {mass: m, position: X*i + R*sin(theta)*i + R*cos(theta)*j}}
gravity: -g*j
initial: {X: 0, X': 0, theta: 0, theta': 0}
ask: {it: {quantity: "X'", when: "g*cos(theta) = R*theta'^2"}}
"""


def test_from_an_unstable_equilibrium_the_integrals_lead_to_the_state(problem: Read) -> None:
    """For equal masses contact ends where c³ − 6 c + 4 = 0, c = √3 − 1, with θ'² = 4 g (1 − c)/(R (2 − c²))."""
    answer = asked(problem, HEMISPHERE)
    cosine = math.sqrt(3) - 1
    rate = math.sqrt(4 * 9.81 * (1 - cosine) / (2 - cosine**2))
    assert (answer.how, answer.mirrored) == (How.NUMERICAL, True)
    assert float(answer.branches[0].rhs) == pytest.approx(-rate * cosine / 2, rel=1e-5)


def test_the_two_sides_of_an_equilibrium_must_agree() -> None:
    q, square = sp.Symbol("q", real=True), sp.Float(1)
    assert numerical.nearest_place(q, sp.S.Zero, sp.cos(q) - sp.Rational(1, 2), square) == pytest.approx(math.pi / 3)
    assert numerical.nearest_place(q, sp.S.Zero, sp.sin(q) - sp.Rational(1, 2), square) is None
    assert numerical.nearest_place(q, sp.S.Zero, sp.cos(q) - sp.Rational(1, 2), sp.cos(2 * q)) is None  # out of reach
