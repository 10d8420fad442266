"""Accelerations and multipliers at one state in numbers, against a pendulum by hand.

Positions of rest in numbers, against a pendulum by hand.
"""

from __future__ import annotations

from dataclasses import replace
from math import atan, cos, pi, sin

import pytest

from lagrange.core.diagnostics import NotCoveredError, ProblemError
from lagrange.mechanics.nearby.one_state import (
    RestInNumbers,
    check_rest_in_numbers,
    check_state,
    rest_in_numbers,
    start_in_numbers,
)
from tests.mechanics.nearby.test_linear_motion import PENDULUM, problem_of


def test_a_pendulum_that_moves(tmp_path) -> None:
    """m = 2, l = 3, k = 5, c = 7 at (9/5, 12/5) with the speed 1: a = −(v²/l²) r + s t, and λ from the radial part."""
    problem, configuration = problem_of(tmp_path, PENDULUM.replace("x: 0, y: l, x': 0", "x: 9/5, y: 12/5, x': 4/5"))
    found = start_in_numbers(problem, configuration)
    assert found is not None
    assert found.agrees
    x, y, v, u = 1.8, 2.4, 0.8, -0.6
    force = (-5 * x - 7 * v, 20 - 7 * u)
    tangential = (force[0] * 0.8 - force[1] * 0.6) / 2
    expected = (tangential * 0.8 - x / 9, -tangential * 0.6 - y / 9)
    assert [float(a) for a in found.accelerations.values()] == pytest.approx(expected)
    # m r'' − F = 2 λ r
    assert float(found.multipliers["rod"]) == pytest.approx((2 * expected[0] - force[0]) / (2 * x))
    assert check_state(replace(found, agrees=False), "accelerations").passed is False


@pytest.mark.parametrize("start", ["x: 0, y: l", "x': 0"])
def test_a_state_that_is_not_determined_has_no_numbers(tmp_path, start: str) -> None:
    assert start_in_numbers(*problem_of(tmp_path, PENDULUM.replace("x: 0, y: l, x': 0", start))) is None


def test_accelerations_that_a_state_leaves_open_are_not_given(tmp_path) -> None:
    """On its axis a spherical pendulum has no azimuth; besides, a mass that varies is not covered."""
    text = """
title: t
parameters: {g: {value: 10}}
coordinates: [theta, phi]
particles: {P: {mass: MASS, position: "sin(theta)*cos(phi)*i + sin(theta)*sin(phi)*j - cos(theta)*k"}}
gravity: -g*k
initial: {theta: START, phi: 0, theta': 0, phi': 1}
"""
    start = text.replace("MASS", "1").replace("START", "0")
    assert start_in_numbers(*problem_of(tmp_path, start)) is None
    assert start_in_numbers(*problem_of(tmp_path, start.replace("theta: 0", "theta: 1"))) is not None
    varying = text.replace("MASS", "2 - t, leaves: {relative: 0}").replace("START", "1")
    assert start_in_numbers(*problem_of(tmp_path, varying)) is None


# Rest in numbers


# A pendulum of weight 20 on a rod of length 3, pushed aside by 15, rests at tan θ = 3/4, and opposite.
VALUES = "title: t\nparameters: {m: {value: 2}, l: {value: 3}, g: {value: 10}, F: {value: 15}}\n"
FORCES = "gravity: g*j\nforces: {push: {on: P, vector: F*i}}\n"
ON_A_ROD = f"""{VALUES}coordinates: [x, y]
particles: {{P: {{mass: m, position: "[x, y]"}}}}
constraints: {{rod: x^2 + y^2 = l^2}}
{FORCES}"""
BY_AN_ANGLE = f"""{VALUES}coordinates: [theta]
particles: {{P: {{mass: m, position: "[l*sin(theta), l*cos(theta)]"}}}}
{FORCES}"""
ANGLE = atan(3 / 4)


def rest_of(tmp_path, text: str, start: str) -> RestInNumbers:
    return rest_in_numbers(*problem_of(tmp_path, f"{text}initial: {{{start}}}\n"))


@pytest.mark.parametrize(("start", "angle", "stable"), [("theta: 0.3", ANGLE, True), ("theta: 3.5", ANGLE + pi, False)])
def test_a_pendulum_rests_below_and_above(tmp_path, start: str, angle: float, stable: bool) -> None:
    rest = rest_of(tmp_path, BY_AN_ANGLE, start)
    assert [float(x) for x in rest.position.values()] == pytest.approx([angle])
    assert rest.stable is stable
    assert rest.agrees
    assert check_rest_in_numbers(replace(rest, agrees=False))[0].passed is False


@pytest.mark.parametrize("side", [1, -1])
def test_a_rod_pulls_below_and_pushes_above(tmp_path, side: int) -> None:
    """Weight and push, 25 along the rod, are −2 λ l there. The iteration begins at the side, at 4-5-3."""
    rest = rest_of(tmp_path, ON_A_ROD, f"x: {side * 12}/5, y: {side * 9}/5")
    place = [float(x) for x in rest.position.values()]
    assert place == pytest.approx([side * 3 * sin(ANGLE), side * 3 * cos(ANGLE)])
    assert float(rest.multipliers["rod"]) == pytest.approx(-side * 25 / 6)
    assert rest.stable is (side > 0)  # by the curvature of the constraint alone: the forces are constant


@pytest.mark.parametrize(
    ("text", "start", "error", "said"),
    [
        (ON_A_ROD.replace("g: {value: 10}", "g: positive"), "y: 3", NotCoveredError, "in letters"),
        (ON_A_ROD, "x: 1, y: 1", ProblemError, "no state near"),
        (BY_AN_ANGLE.replace("gravity: g*j\n", "").replace("F*i", "F*theta'*i"), "theta: 1", NotCoveredError, "not reached"),
        (BY_AN_ANGLE.replace("coordinates: [theta]", "coordinates: [theta, s]") + "constraints: {skid: \"s' = l*theta'\"}\n",
         "theta: 1", NotCoveredError, "constraints on velocities"),
    ],
)  # fmt: skip
def test_what_has_no_such_position_is_refused(tmp_path, text: str, start: str, error: type, said: str) -> None:
    with pytest.raises(error, match=said):
        rest_of(tmp_path, text, start)
