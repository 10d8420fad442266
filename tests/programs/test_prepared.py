"""A problem made ready: numbers for everything, and a start.

How long a motion is followed by default, and what motions need before they are followed.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import lagrange
from lagrange.programs.prepared import longest_time, prepared
from lagrange.programs.simulation import simulated
from tests.support.shared import in_numbers, loaded


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


# Durations


def numbers(made):
    return {s.name: x for s, x in (*made.start.values.items(), *zip(made.states.state, made.start.state, strict=True))}


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
