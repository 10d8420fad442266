"""Beats and the resonance 2 : 1, in numbers.

The threshold of a sleeping axis, against the linear equations of the horizontal components in numbers.
"""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from lagrange.mechanics.consequences.oscillations import beats, double_resonance, sleeping_axis
from tests.support.shared import solved


def test_two_pendulums_exchange_their_motion() -> None:
    solution = solved("coupled-pendulums")
    found = beats(solution.chosen.linearization, tuple(p.symbol for p in solution.problem.parameters))
    assert found is not None
    assert found.coupling.name == "c"
    values = {"c": 0.2, "m": 1.5, "l": 0.7, "g": 9.81}
    difference = float(found.difference.subs({s: values[s.name] for s in found.difference.free_symbols}))
    c, m, l, g = values.values()

    def rate(_: float, y: np.ndarray) -> list[float]:
        a, b, v, w = y
        return [v, w, -g / l * a - c / m * (a - b), -g / l * b - c / m * (b - a)]

    a, b, v, w = solve_ivp(rate, (0, np.pi / difference), [1, 0, 0, 0], method="DOP853", rtol=1e-7, atol=1e-12).y[:, -1]
    assert np.hypot(a, v * np.sqrt(l / g)) < 0.03  # all of the motion is in the second
    assert np.hypot(b, w * np.sqrt(l / g)) == pytest.approx(1, abs=0.01)


def test_the_spring_pendulum_resonates() -> None:
    """Near the vertical, with 3 m g = c l, the swing grows out of the bounce; with another spring it does not."""
    found = double_resonance(solved("spring-pendulum").chosen)
    assert found is not None
    assert {str(sp.factor(s)) for s in found.condition} == {"c*l", "3*g*m"}
    assert (found.driven.name, found.driving.name) == ("r", "phi")

    def largest(c: float) -> float:
        m = l = 1.0
        g = 10.0

        def rate(_: float, y: np.ndarray) -> list[float]:
            r, phi, v, w = y
            return [v, w, r * w**2 - c / m * (r - l) + g * np.cos(phi), -(2 * v * w + g * np.sin(phi)) / r]

        rest = l + m * g / c
        return float(np.abs(solve_ivp(rate, (0, 40), [1.1 * rest, 0.01, 0, 0], rtol=1e-8).y[1]).max())

    assert largest(30) > 0.1
    assert largest(60) < 0.03


@pytest.mark.parametrize("name", ["swinging-atwood", "ex18-double-pendulum", "thrown-stone"])
def test_others_have_no_resonance_of_that_kind(name: str) -> None:
    solution = solved(name)
    assert double_resonance(solution.chosen) is None
    assert beats(solution.chosen.linearization, ()) is None


# Sleeping


@pytest.mark.parametrize(
    ("name", "more", "less"),
    [
        ("ball-on-a-ball", "b**2*n**2", "35*a*g"),  # Routh
        ("heavy-top", "C**2*n**2", "4*g*l*m*(A + l**2*m)"),  # Goldstein, section 5.7, with A about the mass centre
    ],
)
def test_what_stands_upright_by_its_spin(name: str, more: str, less: str) -> None:
    solution = solved(name)
    found = sleeping_axis(solution, solution.chosen, "n")
    assert found is not None
    assert (str(found.more), str(found.less)) == (more, less)


@pytest.mark.parametrize("name", ["euler-rigid-body", "suslov-body", "rolling-disc", "gyrocompass"])
def test_what_does_not(name: str) -> None:
    solution = solved(name)
    assert sleeping_axis(solution, solution.chosen, "n") is None
