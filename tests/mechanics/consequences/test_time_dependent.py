"""Fast drives and slow changes: the conditions against Floquet's theory and against integrated motions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from lagrange.core.diagnostics import Source
from lagrange.core.symbols import prime, t
from lagrange.mechanics.consequences.time_dependent import fast_drive, slow_change, uniform_stiffness
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.shared import solved

DRIVEN = """
title: Pendulum with a driven support
parameters: {m: positive, l: positive, a: positive, w: positive, g: positive, b: positive}
coordinates: [theta]
particles:
  P: {mass: m, position: "SUPPORT + l*sin(theta)*i - l*cos(theta)*j"}
gravity: -g*j
"""


def read(text: str) -> InCoordinates:
    return solve(read_problem(Source("driven.yaml", text))).chosen


def grows(speed: float) -> bool:
    """Whether small motions about the upright grow, by their monodromy matrix, with l = g = 1, w = 400, a w = speed."""
    w = 400.0

    def linear(t: float, y: np.ndarray) -> list[float]:
        return [y[1], (1 - speed * w * np.cos(w * t)) * y[0]]

    columns = [
        solve_ivp(linear, (0, 2 * np.pi / w), start, rtol=1e-11, atol=1e-13).y[:, -1] for start in ([1, 0], [0, 1])
    ]
    return bool(max(abs(np.linalg.eigvals(np.array(columns).T))) > 1 + 1e-6)


def test_a_support_shaken_fast_holds_the_pendulum_upside_down() -> None:
    found = fast_drive(solved("kapitza-pendulum").chosen)
    assert found is not None
    [upright] = found.changed
    assert (upright.place, upright.without_drive) == (0, False)
    a, w, g, l = (
        next(s for s in (upright.more * upright.less).free_symbols if s.name == n) for n in ["a", "Omega", "g", "l"]
    )
    assert sp.factor(upright.more - upright.less) == sp.factor(a**2 * w**2 - 2 * g * l)
    assert grows(0.97 * np.sqrt(2))
    assert not grows(1.03 * np.sqrt(2))


def test_a_support_shaken_sideways_lifts_the_hanging_pendulum() -> None:
    """The mean of the integrated motion stays at the angle that the mean equation gives, and not below."""
    found = fast_drive(read(DRIVEN.replace("SUPPORT", "a*cos(w*t)*i")))
    assert found is not None
    [hanging] = found.changed
    assert (hanging.place, hanging.without_drive) == (0, True)
    values = {"a": 2 / 400, "w": 400.0, "g": 1.0, "l": 1.0}
    mean = sp.lambdify(
        found.coordinate, found.mean.subs({s: values[s.name] for s in found.mean.free_symbols if s.name in values})
    )
    lifted = np.arccos(2 / 2**2)  # cos θ = 2 g l/(a w)²
    assert mean(lifted) == pytest.approx(0, abs=1e-12)

    def rate(t: float, y: np.ndarray) -> list[float]:
        return [y[1], -np.sin(y[0]) + 2 * 400 * np.cos(400 * t) * np.cos(y[0])]

    times = np.linspace(0, 10, 4001)
    angles = solve_ivp(rate, (0, 10), [lifted, 0], t_eval=times, rtol=1e-9, atol=1e-11, max_step=0.002).y[0]
    assert np.abs(angles - lifted).max() < 0.03


def test_both_components_of_a_drive_count() -> None:
    """A support on a circle: γ² + σ² = 1/l² at every angle, so that the mean is that of no drive at all."""
    assert fast_drive(read(DRIVEN.replace("SUPPORT", "a*cos(w*t)*i + a*sin(w*t)*j"))) is None


@pytest.mark.parametrize(
    "support", ["a*cos(w*t)*i + b*cos(w*t)*j", "a*cos(w*t)*i + a*cos(2*w*t)*j", "a*t^2*i", "a*cos(w*t)*cos(theta)*i"]
)
def test_drives_of_other_kinds_are_left_alone(support: str) -> None:
    assert fast_drive(read(DRIVEN.replace("SUPPORT", support))) is None


def test_the_amplitude_of_a_pendulum_that_is_pulled_up() -> None:
    found = slow_change(solved("shortening-pendulum").chosen)
    assert found is not None
    assert (found.place, found.exponent) == (0, sp.Rational(-3, 4))

    def rate(t: float, y: np.ndarray) -> list[float]:
        l, v = 4 - t / 100, -1 / 100
        return [y[1], -(2 * v * y[1] + np.sin(y[0])) / l]

    run = solve_ivp(rate, (0, 300), [0.01, 0], rtol=1e-9, atol=1e-12, max_step=0.1)
    energy = np.hypot(run.y[0], run.y[1] * np.sqrt(4 - run.t / 100))  # the amplitude at the momentary frequency
    assert energy[-1] / energy[0] == pytest.approx(4**0.75, rel=0.01)


@pytest.mark.parametrize("name", ["ex11-ideal-pendulum", "kapitza-pendulum", "ex17-spherical-pendulum"])
def test_no_length_changes_slowly_elsewhere(name: str) -> None:
    assert slow_change(solved(name).chosen) is None


WIRE = """
title: Bead on a turning wire
parameters: {m: positive, w: positive, a: positive}
coordinates: [r]
particles: {P: {mass: m, position: "r*cos(w*t)*i + r*sin(w*t)*j"}}
forces: {pull: {potential: "m*a*r"}}
"""


def test_a_motion_that_grows_satisfies_its_equation() -> None:
    view = read(WIRE)
    found = uniform_stiffness(view)
    assert found is not None
    assert view.motion is not None
    [equation] = (e.expression for e in view.motion.final)
    for part in (found.first, found.second):
        path = found.rest + part
        state = {
            found.coordinate: path,
            prime(found.coordinate): path.diff(t),
            prime(found.coordinate, 2): path.diff(t, 2),
        }
        assert sp.simplify(equation.xreplace(state)) == 0
    assert uniform_stiffness(solved("ex11-ideal-pendulum").chosen) is None
    assert uniform_stiffness(read(WIRE.replace("m*a*r", "m*a*r^2 + m*w^2*r^2"))) is None  # it oscillates
