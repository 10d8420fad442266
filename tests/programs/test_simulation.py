"""Simulations against motions that are known in closed form, other coordinates, and what must stay constant."""

from __future__ import annotations

import math
import time
from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

import lagrange
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.problem.model import Problem
from lagrange.programs.integrator import StoppedError, at, steps
from lagrange.programs.prepared import Prepared, prepared
from lagrange.programs.simulation import EventKind, Simulation, simulated
from lagrange.programs.special.durations import longest_time
from lagrange.programs.starting import settings_of
from lagrange.programs.tables import csv_text
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
    with pytest.raises(StoppedError) as stop:
        for _ in steps(lambda _, x: (x * x,), 0.0, (1.0,), 2.0, 1e-9, 1e-9):
            pass
    assert math.isclose(stop.value.time, 1.0, rel_tol=1e-6)


# motions that are known


def test_the_period_of_a_pendulum() -> None:
    made = made_of(loaded("ex11-ideal-pendulum"), "theta=1.2", "theta'=0")
    length, g = (made.start.values[sp.Symbol(n, positive=True)] for n in ("l", "g"))
    period = float(4 * math.sqrt(length / g) * mpmath.ellipk(math.sin(0.6) ** 2))
    motion = simulated(made.states, made.start, 50 * period, samples=51)
    assert np.abs(motion.states[0] - 1.2).max() < 1e-6  # at every whole period
    assert motion.is_accurate


def test_a_thrown_stone_is_exact() -> None:
    problem = lagrange.loads(
        "title: stone\nparameters: {m: {value: 2}, g: {value: 10}}\ncoordinates: [x, y]\n"
        "particles: {P: {mass: m, position: x*i + y*j}}\ngravity: -g*j\n"
        "initial: {x: 0, y: 0, x': 3, y': 4}\nask: {top: {quantity: y, when: y' = 0}, range: {quantity: x, when: y = 0}}\n"
    )
    made = prepared(problem)
    motion = simulated(made.states, made.start, 2.0, questions=problem.questions)
    assert made.start.assumed == {}
    assert np.allclose(motion.states[1], 4 * motion.times - 5 * motion.times**2, atol=1e-12)
    top, far = motion.events
    assert (top.name, far.name) == ("top", "range")
    assert math.isclose(top.time, 0.4, rel_tol=1e-9)
    assert math.isclose(top.value or 0, 0.8, rel_tol=1e-9)
    assert math.isclose(far.value or 0, 2.4, rel_tol=1e-9)


def test_the_sleigh_of_chaplygin_in_quasi_velocities() -> None:
    motion = moved("sleigh", 20.0, "u=1", "omega=0.5")
    assert motion.names == ("x", "y", "theta", "u", "omega")
    m, inertia, a = (motion.start.values[sp.Symbol(n, positive=True)] for n in ("m", "I_G", "a"))
    # u'^2 + (I/m + a^2) omega^2 is constant, and omega dies out: u tends to the root of it
    square = 1 + (inertia / m + a * a) * 0.25
    u, omega = motion.states[3], motion.states[4]
    assert np.allclose(u**2 + (inertia / m + a * a) * omega**2, square, rtol=1e-8)
    assert math.isclose(u[-1], math.sqrt(square), rel_tol=1e-3)


def test_all_coordinates_give_one_motion() -> None:
    choice = moved("ex18-double-pendulum", 5.0, "phi1=0.9", "phi2=1.4", "phi1'=0.3", samples=51)
    own = moved("ex18-double-pendulum", 5.0, "phi1=0.9", "phi2=1.4", "phi1'=0.3", choice="", samples=51)
    assert choice.names == ("phi1", "phi2", "phi1'", "phi2'")
    assert len(own.names) == 8
    for name in ("x1", "y1", "x2", "y2", "x2'"):
        assert np.abs(of(choice, name) - of(own, name)).max() < 1e-6
    for name in ("T_upper_rod", "T_lower_rod"):
        tension = choice.along(choice.equations.reactions[name])
        assert np.abs(tension - own.along(own.equations.reactions[name])).max() < 1e-4


def test_constraints_do_not_drift() -> None:
    motion = moved("ex18-double-pendulum", 50.0, "phi1=0.9", choice="", samples=200)
    assert motion.violation < 1e-10
    assert motion.drift["energy"] < 1e-6


@pytest.mark.parametrize(
    ("name", "settings"),
    [
        ("ex17-spherical-pendulum", ("phi'=2",)),
        ("heavy-top", ("psi'=20",)),
        ("rolling-disc", ()),
        ("cylinder-on-rough-incline", ()),
    ],
)
def test_what_is_conserved_stays(name: str, settings: tuple[str, ...]) -> None:
    motion = moved(name, 20.0, *settings)
    assert motion.drift
    assert max(motion.drift.values()) < 1e-7
    assert motion.is_accurate


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


def test_an_equilibrium_is_left_by_a_small_push() -> None:
    made = prepared(loaded("leaving-a-sphere"))
    assert made.start.pushed
    motion = simulated(made.states, made.start, longest_time(made.states, made.start), questions=made.problem.questions)
    [leaves] = [e for e in motion.events if e.name == "leaves"]
    assert math.isclose(math.cos(leaves.value or 0), 2 / 3, rel_tol=1e-6)


def test_initial_values_of_other_coordinates_are_carried_over() -> None:
    made = made_of(loaded("ex11-ideal-pendulum"), "x=0.3", "y'=0.2")
    motion = simulated(made.states, made.start, 0.1, samples=2)
    assert math.isclose(of(motion, "x")[0], 0.3, rel_tol=1e-9)
    assert math.isclose(of(motion, "y'")[0], 0.2, rel_tol=1e-9)


@pytest.mark.parametrize(
    ("settings", "code", "place"),
    [
        (("theta=",), None, ""),
        (("theta=blue",), "unknown-symbol", "1:7"),
        (("theta=3 kg*",), "unknown-unit", ""),
        (("theta''=1",), "unknown-parameter", "1:1"),
        (("phi'=1",), "unknown-parameter", "1:1"),
        (("x=1", "y=100"), "initial-contradicts", ""),
    ],
)
def test_settings_that_cannot_be_are_refused_at_their_place(
    settings: tuple[str, ...], code: str | None, place: str
) -> None:
    if code is None:
        assert settings_of(loaded("ex11-ideal-pendulum"), [Fragment.of(settings[0])]).parameters  # refused later
        return
    with pytest.raises(ProblemError) as error:
        made_of(loaded("ex11-ideal-pendulum"), *settings)
    assert error.value.diagnostics[0].code == code
    assert place in str(error.value)
    assert error.value.diagnostics[0].help


def test_the_table_has_units_in_its_header() -> None:
    lines = csv_text(moved("ex11-ideal-pendulum", 1.0, samples=11)).splitlines()
    assert lines[0] == "t (s),theta (rad),theta' (rad/s),T_rod (N),energy (N m)"
    assert len(lines) == 12
    assert all(len(line.split(",")) == 5 for line in lines)


# in Python


@cache
def solved() -> lagrange.Result:
    return lagrange.solve(loaded("ex11-ideal-pendulum"))


def test_simulate_in_python_gives_arrays() -> None:
    values = {"m": 0.5, "l": 2, "g": 10}
    motion = solved().simulate(3.0, values=values, initial={"theta": 0.5}, samples=31)
    assert motion.holds
    assert motion.t.shape == (31,)
    assert motion.y.shape == (2, 31)
    assert motion["theta"][0] == 0.5
    tension = 0.5 * (10 * np.cos(motion["theta"]) + 2 * motion["theta'"] ** 2)
    assert np.allclose(motion["T_rod"], tension)
    assert np.allclose(motion["theta''"], -5 * np.sin(motion["theta"]))
    assert np.ptp(motion.energy) < 1e-8
    assert np.allclose(motion[sp.Symbol("l") * sp.sin(sp.Symbol("theta"))], motion["x"])
    f = motion.function(sp.Symbol("theta'") ** 2)
    assert np.allclose(f(0.0, motion.y), motion["theta'"] ** 2)
    assert isinstance(f(0.0, [0.1, 3.0]), float)
    with pytest.raises(KeyError, match="theta"):
        motion["thta"]


def test_names_that_do_not_exist_are_refused() -> None:
    with pytest.raises(ValueError, match="did you mean `theta'`"):
        solved().simulate(1.0, initial={"thta'": 1})
    with pytest.raises(ValueError, match="parameters"):
        solved().simulate(1.0, values={"mass": 1})
    with pytest.raises(KeyError, match="angle"):
        solved().simulate(1.0, choice="angel")
    with pytest.raises(TypeError, match="expression of SymPy"):
        solved().simulate(1.0, functions={"u": "t^2"})  # type: ignore[dict-item]


@pytest.mark.parametrize(
    "given", [{"until": -1}, {"until": math.inf}, {"initial": {"theta": math.nan}}, {"values": {"l": math.inf}}]
)
def test_a_number_that_is_none_is_refused(given: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"and not a (positive|finite) number"):
        solved().simulate(**given)


def test_a_function_that_is_missing_is_asked_for_as_python_gives_it() -> None:
    with pytest.raises(ProblemError, match=r"functions=\{'l': \.\.\.\}"):
        lagrange.solve(loaded("shortening-pendulum")).simulate(1.0)


def test_plots_and_an_animation() -> None:
    motion = solved().simulate(2.0, initial={"theta": 1.0}, samples=41)
    assert len(motion.plot().axes) == 3
    portrait = motion.phase_portrait("theta").axes[0]
    assert "theta" in portrait.get_xlabel()
    animation = motion.animate(frames=5)
    artists = animation._func(2)
    assert artists[-1].get_text().startswith("t = ")
    rod = artists[0].get_data()
    assert math.isclose(math.hypot(rod[0][1] - rod[0][0], rod[1][1] - rod[1][0]), motion.simulation.start.values[
        sp.Symbol("l", positive=True)])  # fmt: skip
    assert min(rod[1]) < 0  # it hangs down on the page
    animation._draw_was_started = True


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
