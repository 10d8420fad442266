"""Rolling that can be integrated leaves free coordinates."""

from __future__ import annotations

from math import cos, sin

import numpy as np
import pytest
import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.mechanics.solution import solve
from tests.support.problem_texts import read

ROLLING = """title: t
parameters: [m, M, R, alpha, g]
coordinates: [X, s, theta]
particles: {wedge: {mass: M, position: X*i}}
bodies:
  cylinder: {mass: m, inertia: m*R^2/2, position: "(X + s*cos(alpha))*i - s*sin(alpha)*j", angle: theta}
constraints: {rolling: s' + R*theta' = 0}
gravity: -g*j
find: hamiltonian
"""


@pytest.mark.parametrize("choice", ["", "generalized_coordinates: {two: {coordinates: [X, s]}}\n"])
def test_rolling_that_integrates_leaves_free_coordinates(choice: str) -> None:
    """H of a cylinder that rolls on a wedge, by ½ p·M⁻¹p with M = [[M + m, m cos], [m cos, 3/2 m]]."""
    solution = solve(read(ROLLING + choice))
    assert solution.holds
    [found] = [v.hamiltonian for v in solution.views if v.hamiltonian is not None]
    assert [str(q) for q in found.integrated] == ["theta"]
    mass, wedge, tilt, height = 1.3, 3.1, 0.4, 0.7
    inertia = np.array([[wedge + mass, mass * cos(tilt)], [mass * cos(tilt), 1.5 * mass]])
    p = np.array([0.9, -1.7])
    expected = p @ np.linalg.solve(inertia, p) / 2 - mass * 9.7 * height * sin(tilt)
    values = {"m": mass, "M": wedge, "alpha": tilt, "g": 9.7, "s": height, "p_X": p[0], "p_s": p[1], "R": 0.2}
    value = found.function.xreplace({x: sp.Float(values[x.name]) for x in found.function.free_symbols})
    assert float(value) == pytest.approx(expected)


def test_a_blade_leaves_no_free_coordinates() -> None:
    text = """title: t
parameters: [m, I]
coordinates: [x, y, theta]
bodies: {skate: {mass: m, inertia: I, position: x*i + y*j, angle: theta}}
constraints: {blade: "y'*cos(theta) = x'*sin(theta)"}
find: hamiltonian
"""
    with pytest.raises(NotCoveredError, match="`blade` still acts"):
        solve(read(text))
