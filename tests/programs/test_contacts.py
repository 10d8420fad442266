"""Where simulations end: contacts that the file makes one-sided, slips that end or never begin; and what goes on."""

from __future__ import annotations

import json
import math

import pytest

import lagrange
from lagrange.animation.figure import MovingFigure
from lagrange.animation.moving import moving_figure
from lagrange.explain.report import report
from lagrange.programs.integrator import IntegrationStoppedError, steps
from lagrange.programs.prepared import prepared
from lagrange.programs.simulation import EventKind, Simulation, simulated
from lagrange.render import html
from lagsolve.simulation_report import report_text
from tests.support.browser import CHROMIUM
from tests.support.played import played

DOME = """
title: Bead on a smooth circle
parameters: {{m: {{value: 1}}, R: {{value: 1}}, g: {{value: 9.81}}}}
coordinates: [r, theta]
particles: {{P: {{mass: m, position: r*sin(theta)*i + r*cos(theta)*j}}}}
constraints: {{circle: {{equation: {constraint}, reaction: N}}}}
gravity: -g*j
generalized_coordinates: {{angle: {{coordinates: [theta], substitute: {{r: R}}}}}}
initial: {{theta: 0.1, theta': {speed}}}
"""
LEAVES = (2 / 3) * math.cos(0.1)  # cos θ where N = 0

BLOCK = """
title: Block on a rough incline
parameters: {{m: {{value: 1}}, alpha: {{value: {angle} deg}}, g: {{value: 9.81}}, mu: {{value: 0.5}}, mu_s: {{value: {static}}}}}
coordinates: [x, y]
particles: {{P: {{mass: m, position: x*i + y*j}}}}
constraints: {{plane: {{equation: y = 0, reaction: N}}}}
forces: {{rub: {{friction: mu, static: mu_s, constraint: plane, on: P}}}}
gravity: g*(sin(alpha)*i - cos(alpha)*j)
initial: {{x: 0, x': {speed}}}
"""
PUCK = """
title: Puck on rough ice
parameters: {{m: {{value: 1}}, g: {{value: 9.81}}, mu: {{value: 0.1}}}}
coordinates: [x, y, z]
particles: {{P: {{mass: m, position: x*i + y*j + z*k}}}}
constraints: {{ice: {{equation: z = 0, reaction: N}}}}
forces: {{rub: {{friction: mu, constraint: ice, on: P}}}}
gravity: -g*k
initial: {{x: 0, y: 0, x': {speed}, y': 0}}
"""


UPWARDS = PUCK.format(speed=-2).replace("-g*k", "g*(sin(30*pi/180)*i - cos(30*pi/180)*k)")
SAND = """
title: Sand cart
parameters: {m_0: {value: 300 kg}, q: {value: 200 kg/s}, g: {value: 9.81 m/s^2}}
coordinates: [x]
particles: {cart: {mass: m_0 - q*t, position: x*i, leaves: {relative: 0}}}
gravity: g*i
initial: {x: 0, x': 0}
"""


def moved(text: str, until: float = 3.0) -> Simulation:
    made = prepared(lagrange.loads(text))
    return simulated(made.states, made.start, until)


@pytest.mark.parametrize("constraint", ["r >= R", "'r = R', by: surface"])
def test_a_contact_that_the_file_makes_one_sided_ends(constraint: str) -> None:
    motion = moved(DOME.format(constraint=constraint, speed=0))
    [event] = motion.events
    assert event.kind is EventKind.CONTACT
    assert math.cos(event.state[0]) == pytest.approx(LEAVES, rel=1e-9)


@pytest.mark.parametrize("constraint", ["r = R", "'r = R', by: wire"])
def test_an_equation_acts_on_both_sides(constraint: str) -> None:
    motion = moved(DOME.format(constraint=constraint, speed=0))
    assert motion.times[-1] == 3
    if "wire" in constraint:
        assert not motion.events
        return
    [event] = motion.events
    assert (event.kind, event.name) == (EventKind.REVERSED, "N")
    assert math.cos(event.state[0]) == pytest.approx(LEAVES, rel=1e-9)
    assert "N changes its sign" in report_text(motion, 3.0, by_default=False)


def test_a_contact_that_would_have_to_pull_at_the_start_ends_there() -> None:
    [event] = moved(DOME.format(constraint="r >= R", speed=5)).events
    assert (event.kind, event.time) == (EventKind.CONTACT, 0)


STRING = """
title: Pendulum on a string
parameters: {m: {value: 1}, l: {value: 1}, g: {value: 9.81}}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {string: {equation: x^2 + y^2 = l^2, by: string}}
gravity: g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
initial: {theta: 0, theta': 6}
"""


def test_a_string_goes_slack() -> None:
    motion = moved(STRING)
    assert motion.events[-1].kind is EventKind.CONTACT
    # T = m l θ'² + m g cos θ = 0 with l θ'²/2 = 18 − g (1 − cos θ)
    assert math.cos(motion.events[-1].state[0]) == pytest.approx(-(36 - 2 * 9.81) / (3 * 9.81), rel=1e-9)


def test_an_integration_that_gets_nowhere_ends() -> None:
    def rate(_time: float, y: float) -> list[float]:
        return [-math.copysign(1.0, y)]  # to and fro about zero

    with pytest.raises(IntegrationStoppedError, match="steps would be needed"):
        list(steps(rate, 0.0, (1e-9,), 1.0, 1e-10, 1e-13))


@pytest.mark.skipif(CHROMIUM is None, reason="there is no browser")
def test_a_page_ends_where_a_simulation_does() -> None:
    texts = [
        DOME.format(constraint="'r = R', by: surface", speed=0),
        DOME.format(constraint="r = R", speed=0),
        BLOCK.format(angle=20, static=0.5, speed=0),
        BLOCK.format(angle=40, static=1, speed=0),
        BLOCK.format(angle=20, static=0.5, speed=2),
        BLOCK.format(angle=40, static=0.5, speed=-2),
        UPWARDS.replace("0.1", "0.3"),
        UPWARDS.replace("0.1", "0.7"),
        SAND,
    ]
    reports = [report(lagrange.loads(text), complete=False) for text in texts]
    figures = [moving_figure(r.solution) for r in reports]
    assert all(isinstance(f, MovingFigure) for f in figures)
    pages = [html.render([(r.derivation, r.notation)], moving=[f]) for r, f in zip(reports, figures, strict=True)]
    surface, equation, *held, slid, back, puck, stays, empty = played(
        pages, 'one.run = play(2); one.message = read("message");'
    )
    assert "contact is lost" in surface["message"]
    assert equation["run"]["done"] == "true"
    assert "an equation acts on both sides" in equation["message"]
    assert all("Friction holds" in one["message"] for one in held)
    assert "the slip ends" in slid["message"]
    # A slip that ends begins again in the other sense, or in another direction of the plane.
    for one, slope, mu in ((back, 40, 0.5), (puck, 30, 0.3)):
        up, down = (9.81 * (math.sin(math.radians(slope)) + s * mu * math.cos(math.radians(slope))) for s in (1, -1))
        state = json.loads(one["run"]["state"])
        assert state[len(state) // 2] == pytest.approx(down * (2 - 2 / up), rel=2e-4)
    assert "friction holds it" in stays["message"]
    assert "t = 1.5 s: no mass is left" in empty["message"]
    assert "t = 1.595 s" in slid["message"]  # as simulated: v/(g (mu cos(alpha) - sin(alpha)))
