"""Two bodies, and a body about a fixed point, begin in an orbit that can be seen."""

from __future__ import annotations

import numpy as np
import pytest

import lagrange
from lagrange.programs.numerical_system import NumericalSystem
from lagrange.programs.prepared import prepared
from tests.programs.test_sticking import numbers
from tests.support.shared import in_numbers


def test_two_bodies_begin_nearly_in_a_circle() -> None:
    made = in_numbers("two-body-problem")
    x = numbers(made)
    r, v = np.hypot(x["u"], x["v"]), np.hypot(x["u'"], x["v'"])
    assert made.start.orbits
    assert abs(x["u"] * x["u'"] + x["v"] * x["v'"]) < 1e-12  # at right angles
    assert v == pytest.approx(0.9 * np.sqrt(x["G"] * (x["m1"] + x["m2"]) / r))
    assert x["X'"] == x["Y'"] == 0


@pytest.mark.parametrize(
    ("position", "more"),
    [
        ("{mass: m, position: '[x, y]'}", "{potential: -K/sqrt((x - 1)^2 + (y + 2)^2)}"),
        ("{mass: m, position: '[x, y]'}", "{potential: K*log((x - 1)^2 + (y + 2)^2)}"),
        ("{mass: m, position: '[x, y]'}", "{potential: -K/((x - 1)^2 + (y + 2)^2)^2}"),
    ],
)
def test_an_orbit_about_a_fixed_point_turns_back(position: str, more: str) -> None:
    problem = lagrange.loads(
        "title: orbit\nparameters: {m: {assume: positive}, K: {assume: positive}}\ncoordinates: [x, y]\n"
        f"particles: {{P: {position}}}\nforces: {{centre: {more}}}\n"
    )
    made = prepared(problem)
    x = numbers(made)
    radius, velocity = np.array([x["x"] - 1, x["y"] + 2]), np.array([x["x'"], x["y'"]])
    assert radius @ velocity == pytest.approx(0, abs=1e-9)
    pull = -np.array(NumericalSystem(made.states, made.start.values).rate(0.0, *made.start.state)[2:])
    assert velocity @ velocity == pytest.approx(0.81 * pull @ radius)  # v² = a r in a circle


@pytest.mark.parametrize("force", ["{potential: K/r}", "{potential: K*r^2}"])
def test_without_attraction_nothing_orbits(force: str) -> None:
    problem = lagrange.loads(
        "title: no orbit\nparameters: {m: {assume: positive}, K: {assume: positive}}\ncoordinates: [r, phi]\n"
        "particles: {P: {mass: m, position: r*cos(phi)*i + r*sin(phi)*j}}\n" + f"forces: {{centre: {force}}}\n"
    )
    assert not prepared(problem).start.orbits
