"""The motion from the initial state, where nothing is asked."""

from __future__ import annotations

import lagrange
from lagrange.mechanics.solution import solve

THROWN = """
title: Stone
parameters: [m, g, v]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
gravity: -g*j
initial: {x: 0, y: 0, x': v, y': 0}
"""


def test_a_thrown_stone() -> None:
    start = solve(lagrange.loads(THROWN), complete=False).from_start
    assert start is not None
    assert sorted(str(m) for motion in start.motions for m in [motion.value if hasattr(motion, "value") else motion])


def test_without_an_initial_state_nothing_is_known() -> None:
    text = THROWN.replace("initial: {x: 0, y: 0, x': v, y': 0}\n", "")
    assert solve(lagrange.loads(text), complete=False).from_start is None
