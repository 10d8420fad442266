"""Questions about a system at rest, by hand and by differences."""

from __future__ import annotations

from math import cos, isclose, pi, sin, sqrt

import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

CRANK = """
title: Couple on a crank at a given angle
source: of the kind in Beer and Johnston, Vector Mechanics for Engineers, Statics, chapter 10
description: >-
  A force P pushes the slider of a crank mechanism towards the shaft, and a couple M on the crank holds it. How large is the couple when
  the crank stands at 60°? The connecting rod makes the angle φ with the line of the slider.
axes: {i: right, j: up}
parameters:
  r: {value: 100 mm, meaning: length of the crank}
  l: {value: 250 mm, meaning: length of the connecting rod}
  P: {value: 2 kN, meaning: force on the slider}
unknowns: [M]
coordinates:
  theta: angle of the crank
  phi: {meaning: angle of the connecting rod, range: [-90 deg, 90 deg]}
bodies:
  crank: {inertia: 0, position: 0*i, angle: theta, shape: {rod: [0*i, r*e1_crank]}}
particles:
  slider: {position: (r*cos(theta) + l*cos(phi))*i}
constraints:
  guide: r*sin(theta) = l*sin(phi)
forces:
  load: {on: slider, vector: -P*i}
  couple: {on: crank, moment: -M*k}
find: equilibrium
ask:
  couple: {quantity: M, when: theta = 60 deg}
answers:
  degrees_of_freedom: 1
  classification: [holonomic, scleronomic]
  integrable: {guide: true}
  equilibrium: ["M = P*r*sin(theta + phi)/cos(phi)"]
  ask: {couple: 210.1}
"""

TRIANGLE = """
title: Forces in a triangle of bars
source: of the kind in Timoshenko and Young, Engineering Mechanics, chapter 4 (bars removed, and replaced by their forces)
description: >-
  Two bars of length l are hinged at A and B and carry a load P at their common end C; a tie holds B, which can roll along the
  ground. What are the forces in the tie and in the bars when C stands 4 m above the ground, and B is 6 m from A?
axes: {i: right, j: up}
parameters:
  P: {value: 8 kN, meaning: load}
  l: {value: 5 m, meaning: length of each bar}
unknowns: [T]
coordinates:
  x_B: {meaning: distance of the roller from A, unit: m}
  x_C: {meaning: distance of the joint C from A, unit: m}
  y_C: {meaning: height of the joint C, unit: m}
particles:
  B: {position: x_B*i}
  C: {position: x_C*i + y_C*j}
constraints:
  bar_AC: {equation: x_C^2 + y_C^2 = l^2, reaction: S_1, by: rod}
  bar_BC: {equation: (x_B - x_C)^2 + y_C^2 = l^2, reaction: S_2, by: rod}
forces:
  load: {on: C, vector: -P*j}
  tie: {on: B, vector: -T*i}
find: equilibrium
ask:
  tie: {quantity: T, when: [x_B = 6 m, x_C = 3 m, y_C = 4 m]}
  bar: {quantity: S_1, when: [x_B = 6 m, x_C = 3 m, y_C = 4 m]}
answers:
  degrees_of_freedom: 1
  classification: [holonomic, scleronomic]
  integrable: {bar_AC: true, bar_BC: true}
  equilibrium: ["T = P*x_C*(x_B - x_C)/(x_B*y_C)"]
  ask: {tie: 3000, bar: -5000}
"""


def test_crank_by_the_power_of_its_forces() -> None:
    """M θ' = −P x' of the slider, x' by differences."""

    def x(theta: float) -> float:
        return 0.1 * cos(theta) + sqrt(0.25**2 - (0.1 * sin(theta)) ** 2)

    [asked] = solve(read_problem(Source("crank.yaml", CRANK))).asked
    [branch] = asked.branches
    found = float(
        branch.rhs.xreplace({sp.Symbol(n, positive=True): v for n, v in (("r", 0.1), ("l", 0.25), ("P", 2000))})
    )
    rate = (x(pi / 3 + 1e-6) - x(pi / 3 - 1e-6)) / 2e-6
    assert isclose(found, -2000 * rate, rel_tol=1e-7)


def test_triangle_of_bars_by_its_joints() -> None:
    """Joint C: 2 S 4/5 = −P; joint B: T = −S 3/5."""
    tie, bar = solve(read_problem(Source("triangle.yaml", TRIANGLE))).asked
    rule = {sp.Symbol("P", positive=True): 8000, sp.Symbol("l", positive=True): 5}
    assert (tie.branches[0].rhs.xreplace(rule), bar.branches[0].rhs.xreplace(rule)) == (3000, -5000)


COIN = """
title: Coin on a turntable
axes: {i: outward, k: up}
parameters: [m, g, r, w, mu]
coordinates: [x, z]
particles: {coin: {mass: m, position: x*i + z*k}}
constraints: {table: {equation: z >= 0, reaction: N}, place: {equation: x = r, reaction: F}}
forces:
  weight: {on: coin, vector: -m*g*k}
  centrifugal: {on: coin, vector: m*w^2*x*i}
find: equilibrium
ask: {slips: {quantity: w, when: "-F = mu*N"}}
"""


def test_a_positive_parameter_has_no_negative_value() -> None:
    """m w² r = μ m g: of both roots the file means the positive one."""
    [asked] = solve(read_problem(Source("coin.yaml", COIN))).asked
    [branch] = asked.branches
    mu, g, r = sp.symbols("mu g r", positive=True)
    assert branch.rhs.equals(sp.sqrt(mu * g / r))


KERB = """
title: Wheel before a kerb
parameters: [W, r, h]
unknowns: [P]
coordinates: [x, y, theta]
bodies: {wheel: {inertia: 0, position: x*i + y*j, angle: theta}}
constraints:
  kerb: {equation: norm(r_wheel - h*j) >= r, reaction: R}
  ground: {equation: y >= r, reaction: N}
forces:
  weight: {on: wheel, vector: -W*j}
  pull: {on: wheel, vector: P*i}
find: equilibrium
ask:
  lift: {quantity: P, when: N = 0}
  pressure: {quantity: R, when: N = 0}
"""


def test_an_edge_that_would_have_to_pull_is_no_answer() -> None:
    """About the edge, P (r - h) = W sqrt(r^2 - (r - h)^2); R = W r/(r - h) presses only where the axle is above it."""
    problem = read_problem(Source("kerb.yaml", KERB))
    W, r, h = (problem.scope.scalars[n] for n in ("W", "r", "h"))
    lift, pressure = solve(problem).asked
    assert len(lift.branches) == 2
    for b in (*lift.branches, *pressure.branches):
        assert b.excluded_by({r: sp.Integer(2), h: sp.Integer(3)})
        assert not b.excluded_by({r: sp.Integer(5), h: sp.Integer(2)})
    assert pressure.branches[0].rhs.xreplace({W: 6, r: 5, h: 2}) == 10
