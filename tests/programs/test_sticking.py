"""Where friction holds, or turns with the slip."""

from __future__ import annotations

import math

import pytest

from lagrange.programs.simulation import EventKind, simulated
from lagsolve.simulation_report import report_text
from tests.programs.test_contacts import BLOCK, PUCK, UPWARDS, moved
from tests.support.shared import in_numbers


def numbers(made):
    return {s.name: x for s, x in (*made.start.values.items(), *zip(made.states.state, made.start.state, strict=True))}


def test_a_slip_whose_sense_is_a_vector_ends() -> None:
    made = in_numbers("ball-with-backspin")
    motion = simulated(made.states, made.start, 10.0)
    x = numbers(made)
    v, w, size = x["v"], x["w"], x["R"]
    assert [e.kind for e in motion.events] == [EventKind.SLIP]
    assert motion.events[0].time == pytest.approx(2 * (v + size * w) / (7 * x["mu"] * x["g"]), rel=1e-9)


@pytest.mark.parametrize(
    ("angle", "static", "acceleration"),
    [(20, 0.5, 0.0), (40, 0.5, math.sin(math.radians(40)) - 0.5 * math.cos(math.radians(40))), (40, 1, 0.0)],
)
def test_a_block_at_rest_slides_if_friction_does_not_hold_it(angle: float, static: float, acceleration: float) -> None:
    motion = moved(BLOCK.format(angle=angle, static=static, speed=0))
    if acceleration:
        assert not motion.events
        assert motion.states[0][-1] == pytest.approx(9.81 * acceleration * 4.5, rel=1e-9)
    else:
        assert [(e.kind, e.time) for e in motion.events] == [(EventKind.HELD, 0)]
        assert "nothing slips at the start" in report_text(motion, 3.0, by_default=False)


def test_a_block_that_slides_upwards_stops_or_comes_back() -> None:
    up = 9.81 * (math.sin(math.radians(40)) + 0.5 * math.cos(math.radians(40)))
    [held] = moved(BLOCK.format(angle=40, static=1, speed=-2)).events
    assert held.kind is EventKind.HELD
    assert held.time == pytest.approx(2 / up, rel=1e-9)
    assert not moved(BLOCK.format(angle=40, static=0.5, speed=-2)).events


@pytest.mark.parametrize("speed", [2, 0])
def test_a_slip_in_a_plane_ends(speed: float) -> None:
    motion = moved(PUCK.format(speed=speed))
    [event] = motion.events
    assert event.kind is EventKind.HELD
    assert event.time == pytest.approx(speed / 0.981, rel=1e-5)
    assert event.state[0] == pytest.approx(speed**2 / (2 * 0.981), rel=1e-5)


def test_a_puck_that_is_pushed_up_a_rough_plane_comes_back_or_stays() -> None:
    """Up it is slowed by g(sin α + μ cos α), down it is sped up by g(sin α − μ cos α), if that is positive."""
    up, down = (9.81 * (0.5 + s * 0.3 * math.sqrt(3) / 2) for s in (1, -1))
    motion = moved(UPWARDS.replace("0.1", "0.3"))
    assert not motion.events
    assert motion.states[3][-1] == pytest.approx(down * (3 - 2 / up), rel=1e-5)
    assert motion.states[0][-1] == pytest.approx(down * (3 - 2 / up) ** 2 / 2 - 2 / up, rel=1e-5)
    assert [e.kind for e in moved(UPWARDS.replace("0.1", "0.7")).events] == [EventKind.HELD]


def test_of_a_body_pushed_by_an_oblique_force_the_slip_begins_along_it() -> None:
    text = PUCK.format(speed=0).replace("forces: {", "forces: {push: {on: P, vector: 3*i + 4*j}, ")
    motion = moved(text)
    assert motion.states[4][-1] / motion.states[3][-1] == pytest.approx(4 / 3, rel=1e-6)
    assert math.hypot(*motion.states[3:5, -1]) == pytest.approx(3 * (5 - 0.981), rel=1e-5)
