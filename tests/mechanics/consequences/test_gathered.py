"""Most systems have no consequence of these kinds.

Motions in the limit, against Suslov's equations and the sleigh's integrated in numbers.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from lagrange.mechanics.consequences.gathered import consequences, limit_motion
from lagrange.mechanics.limits import LONGEST_RATE
from tests.support.shared import solved


def test_a_pendulum_has_none() -> None:
    solution = solved("ex11-ideal-pendulum")
    c = consequences(solution, solution.chosen)
    assert (c.spins, c.directions, c.limits) == ((), (), ())
    assert (c.cone, c.hodograph, c.beats, c.resonance, c.sleeping) == (None,) * 5


# Limit motion


def test_suslovs_body_turns_evenly_in_the_end() -> None:
    [x] = limit_motion(solved("suslov-body").chosen, LONGEST_RATE)
    assert (x.vanishing.name, x.lasting.name, str(x.remaining), str(x.spin)) == ("u", "q", "A*q**2/2", "q*e2_top")
    assert str(x.unless) == "(A - C)*sin(delta_0)*cos(delta_0)"
    A, C, d = 3.0, 2.0, 0.5
    s, c = np.sin(d), np.cos(d)

    def rate(_: float, y: np.ndarray) -> list[float]:
        u, q = y
        return [(C - A) * u * q * s * c / (A * c**2 + C * s**2), (A - C) * u**2 * s * c / A]

    last = solve_ivp(rate, (0, 120), [1, -1], rtol=1e-10, atol=1e-12).y[:, -1]
    energy = (A * c**2 + C * s**2) + A
    assert abs(last[0]) < 1e-6
    assert last[1] == pytest.approx(np.sqrt(energy / A))


def test_the_sleigh_ends_straight() -> None:
    [x] = limit_motion(solved("sleigh").chosen, LONGEST_RATE)
    assert (x.vanishing.name, x.lasting.name, x.unless, x.spin) == ("omega", "u", None, None)


@pytest.mark.parametrize("name", ["snakeboard", "euler-rigid-body", "parallel-skates"])
def test_other_motions_go_on(name: str) -> None:
    assert not [*limit_motion(solved(name).chosen, LONGEST_RATE)]
