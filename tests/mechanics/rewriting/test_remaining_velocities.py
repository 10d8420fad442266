"""The energy without the velocities that a choice of coordinates eliminates."""

from __future__ import annotations

import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.rewriting.remaining_velocities import in_remaining_velocities
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

ROLLER = """
title: Roller on an incline, and one whose turns a spring counts
parameters: [m, I, R, g, alpha, c]
coordinates: [x, theta]
bodies: {roller: {mass: m, inertia: I, position: x*i, angle: -theta}}
constraints: {rolling: x' = R*theta'}
forces: {weight: {on: roller, vector: m*g*sin(alpha)*i}}
generalized_coordinates: {way: {coordinates: [x]}}
"""
x, theta = sp.symbols("x' theta'", real=True)
m, I, R, c = sp.symbols("m I R c", positive=True)


def test_the_energy_is_collected_in_the_velocities_that_remain() -> None:
    [choice] = solve(read_problem(Source("roller.yaml", ROLLER))).choices
    motion = choice.motion
    assert motion is not None
    place, angle = sp.symbols("x theta", real=True)
    kinetic = m * x**2 / 2 + I * theta**2 / 2
    found = in_remaining_velocities(kinetic - c * place, motion)
    assert theta not in found.free_symbols
    assert sp.expand(found - (kinetic - c * place).subs(theta, x / R)) == 0
    kept = kinetic + c * angle**2  # of what the angle itself is, ẋ = R θ̇ says nothing
    assert in_remaining_velocities(kept, motion) == kept
