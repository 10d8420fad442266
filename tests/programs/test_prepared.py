"""A problem made ready: numbers for everything, and a start."""

from __future__ import annotations

import math

import numpy as np

import lagrange
from lagrange.programs.prepared import prepared
from lagrange.programs.simulation import simulated


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
