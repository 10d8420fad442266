"""The integrator: known curves, and poles."""

from __future__ import annotations

import math

import pytest

from lagrange.programs.integrator import IntegrationStoppedError, at, steps


def test_a_circle_is_followed_and_interpolated() -> None:
    def rate(_: float, x: float, y: float) -> tuple[float, float]:
        return -y, x

    end = (0.0, (0.0, 0.0))
    for step in steps(rate, 0.0, (1.0, 0.0), 20.0, 1e-10, 1e-10):
        coefficients = step.interpolation()
        for share in (0.0, 0.3, 0.7, 1.0):
            time = step.time + share * step.length
            x, y = at(step, coefficients, time)
            assert math.hypot(x - math.cos(time), y - math.sin(time)) < 2e-9
        end = step.end, step.after
    assert end[0] == 20.0


def test_a_pole_ends_the_integration() -> None:
    with pytest.raises(IntegrationStoppedError) as stop:
        for _ in steps(lambda _, x: (x * x,), 0.0, (1.0,), 2.0, 1e-9, 1e-9):
            pass
    assert math.isclose(stop.value.time, 1.0, rel_tol=1e-6)
