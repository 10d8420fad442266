"""The balance of forces in rough contacts, solved in an order.

Coordinates that the constraints determine are substituted.
"""

from __future__ import annotations

import sympy as sp

from lagrange.explain.report import report
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.kinematics import file_configuration
from lagrange.mechanics.equilibrium.friction.balance import held_coordinates
from lagrange.render import json as in_json
from tests.mechanics.equilibrium.friction.test_friction_at_rest import ROUGH, Read, solved


def test_the_forces_that_are_found_satisfy_the_balance(problem: Read) -> None:
    [rest] = [v.at_rest for v in solved(problem, ROUGH).views if v.at_rest is not None]
    assert [sp.simplify(e.xreplace(dict(rest.forces))) for e in rest.balance.values()] == [0] * len(rest.balance)


# Held positions


SHAFT = """title: Bracket on a rough shaft, written without a choice of coordinates
axes: {i: right, j: up}
parameters: {W: positive, mu: positive, h: positive, d: positive, x_W: positive}
coordinates: [x, y, theta]
bodies: {bracket: {inertia: 0, position: x*i + y*j, angle: theta}}
constraints:
  A: {equation: "x + d/2 - h*sin(theta) <= d/2", reaction: N_A}
  B: {equation: "x - d/2 >= -d/2", reaction: N_B}
forces:
  load: {on: bracket, vector: -W*j, at: r_bracket + x_W*i}
  rub_A: {friction: mu, static: mu, constraint: A, on: bracket, at: r_bracket + d/2*i + h*e2_bracket, slip: -j}
  rub_B: {friction: mu, static: mu, constraint: B, on: bracket, at: r_bracket - d/2*i, slip: -j}
find: equilibrium
"""


def test_coordinates_that_the_constraints_hold_are_put_in(problem: Read) -> None:
    rest = in_json.as_object(report(problem(SHAFT)))["rest"]
    assert sorted(case[0] for case in rest["cases"]) == ["h/(2*x_W) <= mu", "h/d < mu"]


DRAWER = """title: Drawer
parameters: [P, L, w, e, mu]
coordinates: [x, y, theta]
bodies: {drawer: {position: x*i + y*j, angle: theta}}
let: {A: r_drawer + w/2*e1_drawer + L/2*e2_drawer, B: r_drawer - w/2*e1_drawer - L/2*e2_drawer}
constraints:
  right: {equation: "dot(A, i) <= w/2", reaction: N_A}
  left: {equation: "dot(B, i) >= -w/2", reaction: N_B}
forces:
  pull: {on: drawer, vector: P*j, at: r_drawer - e*e1_drawer + L/2*e2_drawer}
  fA: {friction: mu, static: mu, constraint: right, on: drawer, at: A, slip: j}
  fB: {friction: mu, static: mu, constraint: left, on: drawer, at: B, slip: j}
find: impending
answers: {equilibrium: ["mu = L/(2*e)"]}
"""


def test_a_drawer_is_about_to_slip_as_it_is_drawn(problem: Read) -> None:
    """P e = N L and P = 2 μ N; that it would fit askew as well is no second limit."""
    made = report(problem(DRAWER))
    assert [v.verdict.value for v in made.answers] == ["equivalent"]
    [branch] = (b for v in made.solution.views for m in v.impending or () for b in m.equilibrium.branches)
    assert len(branch.relations) == 1


TONGS = """title: Tongs
parameters: [W, a, b, c, d, h, mu]
coordinates: [x, y, theta, Y]
bodies: {arm: {position: x*i + y*j, angle: theta}}
particles: {block: {position: Y*j}}
let: {A: r_arm - a*e1_arm + b*e2_arm, B: r_arm + d*e1_arm - h*e2_arm}
constraints:
  pin: {equation: x = 0, reaction: X}
  link: {equation: "norm(A - (b + c)*j) = sqrt(a^2 + c^2)", reaction: S}
  grip: {equation: "dot(B - r_block, i) >= d", reaction: N}
forces:
  weight: {on: block, vector: -W/2*j}
  rub: {friction: mu, static: mu, constraint: grip, on: arm, at: B}
find: equilibrium
"""


def test_tongs_are_held_where_their_vectors_are_simple(problem: Read) -> None:
    """The link is quadratic in y, and holds the arm upright: the condition of rest is then μ ≥ c h/(a b + a c + c d)."""
    read = problem(TONGS)
    held = held_coordinates(file_configuration(read, classify(read).constrained))
    assert {q.name: v for q, v in held.items()} == {"x": 0, "y": 0, "theta": 0}


STEP = """title: Bar leaning over a step
parameters: [m, g, l, h, mu]
coordinates: [x, y, theta]
bodies: {bar: {mass: m, position: x*i + y*j, angle: theta}}
constraints:
  floor: {equation: "y - l/2*sin(theta) >= 0", reaction: N_A}
  step: {equation: "x*sin(theta) + (h - y)*cos(theta) <= 0", reaction: N_B}
gravity: -g*j
forces:
  rub: {friction: mu, static: mu, constraint: floor, on: bar, at: r_bar - l/2*(cos(theta)*i + sin(theta)*j)}
find: equilibrium
answers: {rest: ["l*sin(theta)^2*cos(theta) <= mu*(2*h - l*sin(theta)*cos(theta)^2)"]}
"""


def test_lengths_that_the_constraints_give_are_put_into_the_conditions(problem: Read) -> None:
    """N_B h/sin θ = ½ m g l cos θ about the foot; the place of the mass centre is in no condition."""
    made = report(problem(STEP))
    assert [v.verdict.value for v in made.answers] == ["equivalent"]
    [rest] = (v.at_rest for v in made.solution.views if v.at_rest is not None)
    assert {q.name for q in rest.lengths.values} == {"x", "y"}
    assert [str(e) for e in rest.lengths.nonzero] == ["sin(theta)"]
    [[condition]] = rest.cases
    assert {s.name for s in (condition.right - condition.left).free_symbols} == {"l", "h", "mu", "theta"}
