"""Answers in numbers, with their units."""

from __future__ import annotations

import math

import pytest

from lagrange.explain.report import report
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.mechanics.questions.test_questions import SPHERE, Read

SLOPE = """\
title: A block slides down
parameters:
  m: {assume: positive, value: 40 kg}
  g: {assume: positive, value: "9.81 m/s^2"}
  alpha: {assume: acute, value: 30 deg}
  mu: {assume: positive, value: "1/4"}
  d: {assume: positive, value: 6 m}
coordinates: [x, y]
particles: {A: {mass: m, position: x*i + y*j}}
constraints: {plane: {equation: y >= 0, reaction: N}}
forces:
  weight: {on: A, vector: "m*g*(sin(alpha)*i - cos(alpha)*j)"}
  rub: {friction: mu, constraint: plane, on: A, slip: positive}
initial: {x: 0, x': 0}
ask:
  speed: {quantity: "x'", when: "x = d"}
  time: {quantity: t, when: "x = d"}
  push: {quantity: N, when: "x = d"}
"""


def test_answers_in_numbers_with_their_units(problem: Read) -> None:
    """a = g (sin 30° − cos 30°/4); the units of ẋ and t follow from those of the parameters."""
    a = 9.81 * (0.5 - math.sqrt(3) / 8)
    expected = {"speed": (math.sqrt(12 * a), "m/s"), "time": (math.sqrt(12 / a), "s")}
    expected["push"] = (40 * 9.81 * math.sqrt(3) / 2, "N")
    found = report(problem(SLOPE))
    answers = {a["name"]: (a["number"], a["unit"]) for a in as_object(found)["asked"]}
    assert {name: unit for name, (_, unit) in answers.items()} == {name: unit for name, (_, unit) in expected.items()}
    assert all(answers[name][0] == pytest.approx(value) for name, (value, _) in expected.items())
    page = terminal.text(found.derivation, found.notation, 80)
    assert "ẋ ≈ 5.777 m/s" in page
    assert "t ≈ 2.077 s" in page


def test_an_angle_is_given_in_degrees(problem: Read) -> None:
    state = "initial: {theta: 0, theta': 0}\nask: {leaves: {quantity: theta, when: N = 0}}\n"
    found = report(problem(SPHERE + state))
    [leaves] = as_object(found)["asked"]
    assert (leaves["number"], leaves["unit"]) == (pytest.approx(math.acos(2 / 3)), "rad")
    assert "That is θ ≈ 48.19°." in terminal.text(found.derivation, found.notation, 80)


def test_an_absolute_value_is_no_angle(problem: Read) -> None:
    found = report(problem(SLOPE.replace('speed: {quantity: "x\'"', 'speed: {quantity: "abs(x\')"')))
    page = terminal.text(found.derivation, found.notation, 80)
    assert "|ẋ| ≈ 5.777 m/s" in page
    answers = [line for line in page[page.index("Question") :].splitlines() if "|ẋ|" in line]
    assert answers
    assert not [line for line in answers if "°" in line]


SPUN = """\
title: A disc spun up
parameters: {I: 2 kg m^2, M: 5 N m}
coordinates: [phi]
bodies: {disc: {mass: 1, inertia: I, position: 0*i, angle: phi}}
forces: {motor: {on: disc, moment: M*k}}
initial: {phi: 0, phi': 0}
ask: {turns: {quantity: phi/(2*pi), when: "phi' = 300 rpm"}}
"""


def test_a_number_of_turns_has_no_unit_that_300_rpm_hide(problem: Read) -> None:
    """φ/2π = ω² I/(4π M), in which ω = 10π only."""
    explained = report(problem(SPUN))
    [answer] = as_object(explained)["asked"]
    assert answer["number"] == pytest.approx((10 * math.pi) ** 2 * 2 / (4 * math.pi * 5))
    assert answer["unit"] is None
