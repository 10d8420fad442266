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
    found = {q.name: str(e) for m in start.motions for q, e in m.solutions.items()}
    assert found == {"x": "t*v", "y": "-g*t**2/2"}


def test_without_an_initial_state_nothing_is_known() -> None:
    text = THROWN.replace("initial: {x: 0, y: 0, x': v, y': 0}\n", "")
    assert solve(lagrange.loads(text), complete=False).from_start is None
