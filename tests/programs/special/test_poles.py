"""Poles of coordinates, at which a simulation stops."""

from __future__ import annotations

import math

import pytest

from lagrange.programs.simulation import EventKind, simulated
from lagrange.programs.special.poles import REASON
from tests.support.shared import in_numbers


def test_the_depth_of_a_pendulum_ends_at_the_bottom() -> None:
    made = in_numbers("ex11-ideal-pendulum", "depth")
    values = {s.name: x for s, x in made.start.values.items()}
    motion = simulated(made.states, made.start, 10.0)
    [event] = motion.events
    assert (event.kind, event.name) == (EventKind.STOPPED, REASON)
    assert not motion.is_accurate
    assert motion.drift["energy"] < 1e-6
    # The angle of the same pendulum has no pole there: the time from rest to the bottom is a quarter of its period.
    swing = math.acos(made.start.state[0] / values["l"])
    k = math.sin(swing / 2)
    mean, geometric = 1.0, math.sqrt(1 - k * k)
    for _ in range(6):
        mean, geometric = (mean + geometric) / 2, math.sqrt(mean * geometric)
    quarter = math.pi / (2 * mean) * math.sqrt(values["l"] / values["g"])
    assert event.time == pytest.approx(quarter, abs=0.05)
    assert event.time <= quarter
    assert len(motion.times) == motion.states.shape[1]


def test_a_motion_that_stays_away_from_the_pole_goes_on() -> None:
    made = in_numbers("ex11-ideal-pendulum", "depth")
    motion = simulated(made.states, made.start, 0.5)
    assert motion.is_accurate
    assert not motion.events
