"""Simulations against motions that are known in closed form, other coordinates, and what must stay constant."""

from __future__ import annotations

import math
import time

import mpmath
import numpy as np
import pytest
import sympy as sp

import lagrange
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.problem.model import Problem
from lagrange.programs.prepared import Prepared, prepared
from lagrange.programs.simulation import EventKind, Simulation, simulated
from lagrange.programs.starting import settings_of
from tests.support.shared import in_numbers, loaded


def made_of(problem: Problem, *settings: str, choice: str | None = None) -> Prepared:
    given = settings_of(problem, [Fragment.of(s, "--set") for s in settings])
    assert not given.parameters
    return prepared(problem, choice, given)


def moved(name: str, until: float, *settings: str, choice: str | None = None, samples: int | None = None) -> Simulation:
    made = made_of(loaded(name), *settings, choice=choice) if settings else in_numbers(name, choice)
    return simulated(made.states, made.start, until, questions=made.problem.questions, samples=samples)


def of(simulation: Simulation, name: str) -> np.ndarray:
    return simulation.along(sp.Symbol(name, real=True))


# the integrator


# motions that are known


def test_the_period_of_a_pendulum() -> None:
    made = made_of(loaded("ex11-ideal-pendulum"), "theta=1.2", "theta'=0")
    length, g = (made.start.values[sp.Symbol(n, positive=True)] for n in ("l", "g"))
    period = float(4 * math.sqrt(length / g) * mpmath.ellipk(math.sin(0.6) ** 2))
    motion = simulated(made.states, made.start, 50 * period, samples=51)
    assert np.abs(motion.states[0] - 1.2).max() < 1e-6  # at every whole period
    assert motion.is_accurate


def test_the_sleigh_of_chaplygin_in_quasi_velocities() -> None:
    motion = moved("sleigh", 20.0, "u=1", "omega=0.5")
    assert motion.names == ("x", "y", "theta", "u", "omega")
    m, inertia, a = (motion.start.values[sp.Symbol(n, positive=True)] for n in ("m", "I_G", "a"))
    # u'^2 + (I/m + a^2) omega^2 is constant, and omega dies out: u tends to the root of it
    square = 1 + (inertia / m + a * a) * 0.25
    u, omega = motion.states[3], motion.states[4]
    assert np.allclose(u**2 + (inertia / m + a * a) * omega**2, square, rtol=1e-8)
    assert math.isclose(u[-1], math.sqrt(square), rel_tol=1e-3)


def test_a_contact_that_ends_ends_the_simulation() -> None:
    motion = moved("ladder-leaves-the-wall", 20.0)
    asked = {e.name: e for e in motion.events if e.kind is EventKind.ASKED}
    assert motion.events[-1].kind is EventKind.CONTACT
    # cos θ = (2/3) cos θ_0, the classical answer
    start = motion.start.state[motion.names.index("theta")]
    assert math.isclose(math.cos(asked["leaves"].value or 0), 2 / 3 * math.cos(start), rel_tol=1e-9)
    assert math.isclose(motion.times[-1], motion.events[-1].time, rel_tol=1e-9)
    assert len(motion.times) > 500


SLIDE = """
title: Block on a spring on a rough table
parameters: {m: {value: 1}, k: {value: 10}, mu: {value: 0.1}, g: {value: 10}}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {table: y = 0}
gravity: -g*j
forces:
  spring: {on: P, vector: -k*x*i}
  rub: {friction: mu, constraint: table, on: P}
initial: {x: 1, x': 0.001}
"""


def test_dry_friction_changes_its_sense_until_it_holds() -> None:
    made = prepared(lagrange.loads(SLIDE))
    motion = simulated(made.states, made.start, 60.0)
    assert motion.events[-1].kind is EventKind.HELD
    # each swing loses 2 mu g m/k = 0.2: 1, -0.8, 0.6, -0.4, 0.2, 0
    turns = [x for x, a, b in zip(motion.states[0][1:-1], motion.states[2][:-2], motion.states[2][2:], strict=True)
             if a * b < 0]  # fmt: skip
    assert abs(motion.states[0][-1]) < 0.1 + 1e-9  # where friction can hold it
    assert math.isclose(motion.events[-1].time, 5 * math.pi / math.sqrt(10), rel_tol=1e-2)
    assert min(motion.states[0]) == pytest.approx(-0.8, abs=1e-3)
    assert len(turns) >= 4
    x, velocity = motion.states[0], motion.states[2]
    slipping = np.abs(velocity) > 1e-6
    expected = -10 * x - np.sign(velocity)
    assert np.allclose(of(motion, "x''")[slipping], expected[slipping])  # with the sense that slip has at each time


def test_a_prescribed_motion_and_an_undefined_function_can_be_given() -> None:
    made = made_of(loaded("pole-on-cart"), "F=0.2*cos(2*t)")
    assert not list(made.states.functions)
    motion = simulated(made.states, made.start, 5.0)
    assert len(motion.times) == 1001
    with pytest.raises(ProblemError) as error:
        made_of(loaded("pole-on-cart"), "F=x*t")
    assert "--set:1:3" in str(error.value)


# in Python


def test_a_double_pendulum_is_followed_for_a_thousand_seconds_in_less_than_two() -> None:
    made = in_numbers("ex18-double-pendulum")
    begun = time.process_time()
    motion = simulated(made.states, made.start, 1000.0)
    assert time.process_time() - begun < 2.0
    assert motion.drift["energy"] < 1e-7


def test_a_motion_ends_where_no_mass_is_left() -> None:
    """Sand falls out with the velocity of the cart: x'' = g sin(alpha) says nothing of the mass, which ends at m_0/q."""
    text = """
title: Sand cart
parameters: {m_0: {value: 400 kg}, q: {value: 5 kg/s}, g: {value: 9.81 m/s^2}}
coordinates: [x]
particles: {cart: {mass: m_0 - q*t, position: x*i, leaves: {relative: 0}}}
gravity: g*i
initial: {x: 0, x': 0}
"""
    made = made_of(lagrange.loads(text))
    found = simulated(made.states, made.start, 100.0)
    [event] = found.events
    assert event.kind is EventKind.EMPTY
    assert event.time == pytest.approx(80, abs=1e-6)


def test_a_motion_from_a_lagrangian_alone() -> None:
    """An oscillating circuit: q = e^(−t/2) (cos w t + sin(w t)/(2 w)) with w² = 3/4, for L = R = C = 1."""
    text = """
title: Circuit
parameters: {L: {value: 1}, R: {value: 1}, C: {value: 1}}
coordinates: [q]
lagrangian: L*q'^2/2 - q^2/(2*C)
forces: {resistor: {generalized: {q: -R*q'}}}
initial: {q: 1, q': 0}
"""
    made = made_of(lagrange.loads(text))
    found = simulated(made.states, made.start, 4.0)
    w = math.sqrt(3) / 2
    assert found.states[0, -1] == pytest.approx(math.exp(-2) * (math.cos(4 * w) + math.sin(4 * w) / (2 * w)), abs=1e-9)


def test_a_rocket_burns_until_nothing_is_left() -> None:
    """Its acceleration q u/m grows beyond bounds; the end is that of its mass, not an unknown singularity."""
    text = """
title: Rocket
parameters: {m_0: {value: 4 kg}, q: {value: 2 kg/s}, u: {value: 10 m/s}}
coordinates: [x]
particles: {rocket: {mass: m_0 - q*t, position: x*i, leaves: {relative: -u*i}}}
initial: {x: 0, x': 0}
"""
    made = made_of(lagrange.loads(text))
    [event] = simulated(made.states, made.start, 5.0).events
    assert (event.kind, event.name) == (EventKind.EMPTY, "rocket")
    assert event.time == pytest.approx(2, abs=1e-6)
