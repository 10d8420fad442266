"""Directions that stay, and Bernoulli's equation of the hodograph against a shot integrated in numbers."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from lagrange.mechanics.consequences.directions import hodograph, kept_directions
from tests.support.shared import solved

LETTERS = ("v", "psi", "u")


def test_the_machine_of_appell_and_hamel_keeps_its_direction() -> None:
    pairs = [(x.name, y.name) for x, y in kept_directions(solved("appell-hamel").chosen)]
    assert pairs == [("x", "y"), ("x", "z"), ("y", "z")]


@pytest.mark.parametrize("name", ["thrown-stone", "charge-in-crossed-fields", "constant-speed"])
def test_other_motions_turn(name: str) -> None:
    assert not [*kept_directions(solved(name).chosen)]
    assert hodograph(solved(name).chosen, LETTERS) is None


def test_a_shot_against_the_air() -> None:
    """m g du = v D(v) dψ, with D = c v²."""
    found = hodograph(solved("ballistic-curve").chosen, LETTERS)
    assert found is not None
    assert [str(s) for s in found.sides] == ["d(u)*g*m", "d(psi)*v*D(v)"]
    m, g, c = 2.0, 9.81, 0.3

    def rate(_: float, s: np.ndarray) -> list[float]:
        v = np.hypot(*s)
        return [-c * v * s[0] / m, -g - c * v * s[1] / m]

    run = solve_ivp(rate, (0, 2), [8, 6], rtol=1e-10, atol=1e-12, dense_output=True).sol(np.linspace(0, 2, 2001))
    u, psi, v = run[0], np.arctan2(run[1], run[0]), np.hypot(*run)
    slope = np.gradient(u, psi)[1:-1]
    assert np.allclose(m * g * slope, (v * c * v**2)[1:-1], rtol=1e-4)
