"""Accelerations and multipliers at one state in numbers, against a pendulum by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest

from lagrange.mechanics.nearby.accelerations import check_state, start_in_numbers
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
