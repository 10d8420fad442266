"""Motions that need something of their own: orbits, equations too long to print, functions that nobody has given."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

import lagrange
from lagrange.core.diagnostics import ProblemError
from lagrange.core.operations import count_distinct
from lagrange.mechanics.nearby.long_equations import long_equations
from lagrange.programs.languages import Target
from lagrange.programs.numerical_system import NumericalSystem
from lagrange.programs.prepared import prepared, require_functions
from lagrange.programs.simulation import EventKind, simulated
from lagrange.programs.source import source_file
from lagrange.programs.special.durations import longest_time
from lagrange.programs.state_equations import state_equations
from tests.support.shared import in_numbers, loaded


def numbers(made):
    return {s.name: x for s, x in (*made.start.values.items(), *zip(made.states.state, made.start.state, strict=True))}


def test_two_bodies_begin_nearly_in_a_circle() -> None:
    made = in_numbers("two-body-problem")
    x = numbers(made)
    r, v = np.hypot(x["u"], x["v"]), np.hypot(x["u'"], x["v'"])
    assert made.start.orbits
    assert abs(x["u"] * x["u'"] + x["v"] * x["v'"]) < 1e-12  # at right angles
    assert v == pytest.approx(0.9 * np.sqrt(x["G"] * (x["m1"] + x["m2"]) / r))
    assert x["X'"] == x["Y'"] == 0


@pytest.mark.parametrize(
    ("position", "more"),
    [
        ("{mass: m, position: '[x, y]'}", "{potential: -K/sqrt((x - 1)^2 + (y + 2)^2)}"),
        ("{mass: m, position: '[x, y]'}", "{potential: K*log((x - 1)^2 + (y + 2)^2)}"),
        ("{mass: m, position: '[x, y]'}", "{potential: -K/((x - 1)^2 + (y + 2)^2)^2}"),
    ],
)
def test_an_orbit_about_a_fixed_point_turns_back(position: str, more: str) -> None:
    problem = lagrange.loads(
        "title: orbit\nparameters: {m: {assume: positive}, K: {assume: positive}}\ncoordinates: [x, y]\n"
        f"particles: {{P: {position}}}\nforces: {{centre: {more}}}\n"
    )
    made = prepared(problem)
    x = numbers(made)
    radius, velocity = np.array([x["x"] - 1, x["y"] + 2]), np.array([x["x'"], x["y'"]])
    assert radius @ velocity == pytest.approx(0, abs=1e-9)
    pull = -np.array(NumericalSystem(made.states, made.start.values).rate(0.0, *made.start.state)[2:])
    assert velocity @ velocity == pytest.approx(0.81 * pull @ radius)  # v² = a r in a circle


@pytest.mark.parametrize("force", ["{potential: K/r}", "{potential: K*r^2}"])
def test_without_attraction_nothing_orbits(force: str) -> None:
    problem = lagrange.loads(
        "title: no orbit\nparameters: {m: {assume: positive}, K: {assume: positive}}\ncoordinates: [r, phi]\n"
        "particles: {P: {mass: m, position: r*cos(phi)*i + r*sin(phi)*j}}\n" + f"forces: {{centre: {force}}}\n"
    )
    assert not prepared(problem).start.orbits


def test_a_slip_whose_sense_is_a_vector_ends() -> None:
    made = in_numbers("ball-with-backspin")
    motion = simulated(made.states, made.start, 10.0)
    x = numbers(made)
    v, w, size = x["v"], x["w"], x["R"]
    assert [e.kind for e in motion.events] == [EventKind.SLIP]
    assert motion.events[0].time == pytest.approx(2 * (v + size * w) / (7 * x["mu"] * x["g"]), rel=1e-9)


def test_equations_too_long_to_print_are_the_same_motion() -> None:
    problem = lagrange.loads(
        "title: sleigh\nparameters: {m: {value: 2}, J: {value: 0.7}, a: {value: 0.4}, k: {value: 3}}\n"
        "coordinates: [x, y, theta]\nlet: {e: cos(theta)*i + sin(theta)*j}\n"
        "bodies: {sleigh: {mass: m, inertia: J, position: x*i + y*j + a*e, angle: theta}}\n"
        "constraints: {blade: \"x'*sin(theta) = y'*cos(theta)\"}\nforces: {spring: {potential: k*x^2/2}}\n"
    )
    made = prepared(problem)
    solution, known = made.solution, made.states
    found = long_equations(solution.problem, solution.own.configuration)
    long = state_equations(replace(solution, long_equations=found))
    assert long.state == known.state
    rng = np.random.default_rng(5)
    for _ in range(3):
        y = NumericalSystem(known, made.start.values).projected(0.0, tuple(rng.uniform(0.2, 1.2, 6)))
        assert y is not None
        one, other = (NumericalSystem(s, made.start.values).rate(0.0, *y) for s in (known, long))
        assert other == pytest.approx(one, rel=1e-9, abs=1e-9)
    flow = NumericalSystem(long, made.start.values).rate(0.0, *y)
    change = [long.conserved["energy"].diff(s) for s in long.state]
    powers = [
        d * NumericalSystem(long, made.start.values).function(e)(0.0, *y) for d, e in zip(flow, change, strict=True)
    ]
    assert sum(powers) == pytest.approx(0, abs=1e-9 * max(map(abs, powers)))
    assert "lambda" not in source_file(long, made.start, Target.C).split("#include")[1]


def test_common_parts_are_counted_once() -> None:
    e = sp.Symbol("x")
    for k in range(60):
        e = (e + k) * (e - k - 1)  # written out it would have 2^60 operations
    assert count_distinct([e, e]) < 400


def test_functions_that_nobody_has_given_are_taken_from_samples() -> None:
    made = prepared(loaded("pole-on-cart"), complete=True)
    assert set(made.sampled) == {"F"}
    assert simulated(made.states, made.start, 1.0).is_accurate
    bowl = prepared(loaded("ex12-smooth-surface"), complete=True)
    assert bowl.sampled["f"] == sp.sympify("Z - (X**2 + Y**2)/4", {n: sp.Symbol(n, real=True) for n in "XYZ"})
    left = prepared(loaded("pole-on-cart")).states
    assert left.functions == ("F",)  # an exported file leaves it open, and Python has to give it
    with pytest.raises(ProblemError, match="the motion depends on F"):
        require_functions(left, {})


def test_a_motion_that_the_file_leaves_open_is_taken_before_an_orbit_is_looked_for() -> None:
    made = prepared(
        lagrange.loads(
            "title: hauled up\nparameters: {m: positive, g: positive}\nfunctions: {l: [t]}\ncoordinates: [x, y]\n"
            "particles: {P: {mass: m, position: x*i + y*j}}\nconstraints: {rope: x^2 + y^2 = l^2}\ngravity: g*i\n"
            "generalized_coordinates: {swing: {coordinates: [phi], substitute: {x: l*cos(phi), y: l*sin(phi)}}}\n"
        ),
        complete=True,
    )
    assert made.states.name == "swing"
    assert not made.start.orbits
    assert simulated(made.states, made.start, 0.5).is_accurate


def test_a_branch_that_cancels_in_the_equations_has_a_sign_in_the_positions() -> None:
    made = in_numbers("ex11-ideal-pendulum", "depth")
    assert made.states.branches
    assert not {*made.states.branches} & {p.symbol for p in made.states.parameters}
    motion = simulated(made.states, made.start, 0.3)
    assert motion.is_accurate


def test_what_is_simulated_of_an_impact_is_the_motion_after_it() -> None:
    made = prepared(loaded("ballistic-pendulum"), "angle")
    x = numbers(made)
    assert (made.states.state[0].name, x["theta"]) == ("theta", 0.0)  # the bullet stays in the block
    assert len(made.states.state) == 2
    assert x["theta'"] == pytest.approx(x["m"] * x["v"] / ((x["m"] + x["M"]) * x["l"]))
    motion = simulated(made.states, made.start, 2.0, questions=made.problem.questions)
    [swing] = motion.events
    height = x["l"] * (1 - np.cos(swing.value))
    assert height == pytest.approx((x["l"] * x["theta'"]) ** 2 / (2 * x["g"]), rel=1e-6)


def test_a_throw_is_not_followed_for_as_long_as_an_oscillation() -> None:
    for name, expected in (("thrown-stone", 10.0), ("double-atwood", 2.0), ("ex11-ideal-pendulum", 10.0)):
        made = in_numbers(name)
        assert longest_time(made.states, made.start) == expected


def test_a_stiffness_called_c_is_no_damping() -> None:
    text = (
        "title: spring\nparameters: {m: positive, c_1: positive}\ncoordinates: {x: {unit: m}}\n"
        "particles: {P: {mass: m, position: x*i}}\nforces: {f: FORCE}\n"
    )
    stiff = numbers(prepared(lagrange.loads(text.replace("FORCE", "{potential: c_1*x^2/2}"))))
    damped = numbers(prepared(lagrange.loads(text.replace("FORCE", "{damper: c_1, between: [P, 0]}"))))
    assert (stiff["c_1"], damped["c_1"]) == (20.0, 0.4)
