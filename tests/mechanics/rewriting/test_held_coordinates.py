"""What constraints give of the motion is put in, and only that."""

from __future__ import annotations

import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.core.symbols import prime
from lagrange.mechanics.rewriting.held_coordinates import (
    held_values,
    in_remaining_velocities,
    where_held,
    without_given_rates,
)
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

BOWL = """title: A ball in a bowl
parameters: {m: positive, r: positive, R: positive, h: real, g: positive}
coordinates: [a, phi, psi, z]
bodies:
  ball: {mass: m, inertia: 2*m*r^2/5, position: "a*(sin(phi)*i - cos(phi)*j) + z*k", angle: psi}
constraints: {bowl: "2*a = 2*R - 2*r", plane: "z + h = a", rolling: "(R - r)*phi' + r*psi' = 0"}
gravity: -g*j
"""


def test_a_ball_in_a_bowl() -> None:
    """7 (R − r) φ'' + 5 g sin φ = 0, as energy gives it: ½ m (1 + 2/5) (R − r)² φ'² − m g (R − r) cos φ."""
    solution = solve(read_problem(Source("bowl.yaml", BOWL)), complete=False)
    configuration = solution.own.configuration
    a, phi, _, z = configuration.slots.coordinates
    R, r, g = (next(p.symbol for p in solution.problem.parameters if p.symbol.name == n) for n in ("R", "r", "g"))
    held = held_values(configuration)
    assert held == {a: R - r, prime(a): 0, prime(a, 2): 0}  # z is held by two constraints together
    assert where_held(a * sp.sin(phi) + prime(a, 2), held) == (R - r) * sp.sin(phi)
    assert where_held(z**2, held) == z**2
    freed = without_given_rates(solution.chosen)
    assert freed is not None
    wanted = 7 * (R - r) * prime(phi, 2) + 5 * g * sp.sin(phi)
    ratios = [sp.cancel(where_held(e.expression, held) / wanted) for e in freed.equations]
    assert any(x != 0 and not x.free_symbols & {phi, prime(phi, 2)} for x in ratios)


# -- The energy without the velocities that a choice of coordinates eliminates -----------------------------------------


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
