"""Units of the numbers of a motion."""

from __future__ import annotations

from lagrange.programs.units import Units, with_unit
from tests.support.shared import in_numbers


def test_an_angle_is_in_radians() -> None:
    states = in_numbers("ex11-ideal-pendulum", "angle").states
    theta, rate = states.state
    units = Units(states)
    assert (units.of(theta), units.of(rate)) == ("rad", "rad/s")
    assert with_unit("theta", "rad") == "theta (rad)"
    assert with_unit("n", "") == "n"
