"""Contacts that constraints keep from slipping: their friction is the reaction of these constraints, and no second one."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import NotCoveredError
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

HEMISPHERE = """title: A hemisphere on a rough slope
parameters: {m: positive, g: positive, r: positive, alpha: acute, mu: positive}
coordinates: {s: along the slope, y: from the slope, theta: {range: [-90 deg, 90 deg]}}
bodies: {cup: {mass: m, position: "s*i + y*j + 3/8*r*(sin(alpha - theta)*i - cos(alpha - theta)*j)", angle: -theta}}
constraints:
  slope: {equation: y >= r, reaction: N}
  rolling: {equation: "s' = r*theta'", reaction: F}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
forces: {rub: {friction: mu, static: mu, constraint: slope, on: cup, at: s*i + (y - r)*j}}
find: equilibrium
answers:
  equilibrium: ["sin(theta) = 8/3*sin(alpha)", "y = r"]
  reactions: {N: m*g*cos(alpha), F: -m*g*sin(alpha)}
  rest: ["tan(alpha) <= mu"]
"""
WHEEL_AND_BLOCK = """title: A wheel that rolls against a block
parameters: [m, M, g, R, mu, P]
coordinates: [x, y, theta, s, z]
bodies: {wheel: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: -theta}}
particles: {block: {mass: M, position: s*i + z*j}}
constraints:
  floor: {equation: y >= R, reaction: N}
  rolling: {equation: "x' = R*theta'", reaction: F}
  ground: {equation: z >= 0, reaction: N_b}
  rod: {equation: s - x = 3*R, reaction: T}
gravity: -g*j
forces:
  motor: {on: wheel, moment: -P*R*k}
  rub: {static: mu, friction: mu, constraint: floor, on: wheel, at: r_wheel - R*j}
  drag: {static: mu, friction: mu, constraint: ground, on: block}
find: equilibrium
answers: {rest: ["mu >= P/(m*g)", "mu >= P/(M*g)"]}
"""


def test_what_rolls_is_in_equilibrium_and_stable(problem: Read) -> None:
    """V = −m g (r θ sin α + 3/8 r cos θ): sin θ = 8/3 sin α, V'' > 0, and |F| ≤ μ N."""
    solution = solve(problem(HEMISPHERE))
    assert all(c.passed for c in solution.checks)
    assert [a.verdict.value for a in compared_answers(solution)] == ["equivalent"] * 3
    assert solution.own.at_rest is None
    assert solution.own.stability is not None
    [verdict] = solution.own.stability.verdicts
    assert verdict is not None
    assert verdict.verdict in (StabilityVerdict.STABLE, StabilityVerdict.CONDITIONAL)


def test_the_reaction_of_rolling_is_the_friction(problem: Read) -> None:
    """Wheel: F = P, T = −P; block: friction −P. Two forces at the contact made the bound on the wheel disappear."""
    solution = solve(problem(WHEEL_AND_BLOCK))
    [answer] = compared_answers(solution)
    assert answer.verdict.value == "equivalent"
    rest = solution.own.at_rest
    assert rest is not None
    assert rest.verified
    assert rest.open == ()
    assert rest.forces[sp.Symbol("F", real=True)] == sp.Symbol("P", positive=True)


def test_slip_cannot_impend_where_a_constraint_prevents_it(problem: Read) -> None:
    with pytest.raises(NotCoveredError, match="impending slip where the constraint `rolling` keeps"):
        solve(problem(HEMISPHERE.replace("find: equilibrium", "find: impending")))


WEDGE = """title: A wedge in a cleft
parameters: {P: positive, Q: positive, alpha: acute, mu: positive}
coordinates: [x, y, u, v, p, q]
let: {n_R: "cos(alpha)*i - sin(alpha)*j", n_L: "-cos(alpha)*i - sin(alpha)*j"}
particles: {wedge: {position: x*i + y*j}, right: {position: u*i + v*j}, left: {position: p*i + q*j}}
constraints:
  face_R: {equation: "dot(r_right - r_wedge, n_R) >= 0", reaction: N_R}
  face_L: {equation: "dot(r_left - r_wedge, n_L) >= 0", reaction: N_L}
  guide_R: {equation: v = 0, reaction: G_R}
  guide_L: {equation: q = 0, reaction: G_L}
forces:
  blow: {on: wedge, vector: -P*j}
  press_R: {on: right, vector: -Q*i}
  press_L: {on: left, vector: Q*i}
  rub_R: {friction: mu, static: mu, constraint: face_R, on: wedge, slip: -sin(alpha)*i - cos(alpha)*j}
  rub_L: {friction: mu, static: mu, constraint: face_L, on: wedge, slip: sin(alpha)*i - cos(alpha)*j}
find: [equilibrium, impending]
answers:
  rest:
    - "P*(cos(alpha) - mu*sin(alpha)) <= 2*Q*(sin(alpha) + mu*cos(alpha))"
    - "P*(cos(alpha) + mu*sin(alpha)) >= 2*Q*(sin(alpha) - mu*cos(alpha))"
  equilibrium: ["P = 2*Q*(sin(alpha) + mu*cos(alpha))/(cos(alpha) - mu*sin(alpha))"]
"""


def test_a_wedge_between_two_cheeks(problem: Read) -> None:
    """2Q tan(α − φ) ≤ P ≤ 2Q tan(α + φ) with μ = tan φ, in one case; both cheeks say the same at the limit."""
    solution = solve(problem(WEDGE))
    assert [a.verdict.value for a in compared_answers(solution)] == ["equivalent", "equivalent"]
    assert solution.own.at_rest is not None
    assert len(solution.own.at_rest.cases) == 1


PULLED = """title: A half cylinder pulled at its edge
parameters: [W, r, mu]
unknowns: [P]
coordinates: {x: right, y: up, theta: {range: [0, 90 deg]}}
bodies: {half: {position: x*i + y*j - 4*r/(3*pi)*(sin(theta)*i + cos(theta)*j), angle: -theta}}
constraints: {floor: {equation: y >= r, reaction: N}}
forces:
  weight: {on: half, vector: -W*j}
  pull: {on: half, vector: P*i, at: x*i + y*j + r*e1_half}
  rub: {friction: mu, static: mu, constraint: floor, on: half, at: x*i + (y - r)*j}
find: equilibrium
"""


def test_the_range_of_an_angle_gives_signs(problem: Read) -> None:
    """P r (1 − sin θ) = W (4r/3π) sin θ: μ ≥ 4 sin θ/(3π (1 − sin θ)), without |sin θ/(sin θ − 1)|."""
    rest = solve(problem(PULLED)).own.at_rest
    assert rest is not None
    [[condition]] = rest.cases
    assert not condition.left.has(sp.Abs)


DRAWN = """title: A rod drawn along a floor by a string
parameters: {W: positive, l: positive, beta: acute, mu: positive}
unknowns: [T]
coordinates: {x: right, y: up, theta: {range: [0, 90 deg]}}
bodies: {rod: {position: x*i + y*j, angle: theta}}
constraints: {floor: {equation: y >= l*sin(theta), reaction: N}}
forces:
  weight: {on: rod, vector: -W*j}
  string: {on: rod, vector: T*cos(beta)*i + T*sin(beta)*j, at: r_rod + l*e1_rod}
  rub: {friction: mu, static: mu, constraint: floor, on: rod, at: r_rod - l*e1_rod}
find: equilibrium
answers: {rest: ["mu*(tan(beta) - 2*tan(theta)) >= 1"]}
"""


def test_an_unknown_force_of_a_string_pulls(problem: Read) -> None:
    """T = W cos θ/(2 sin(β − θ)) ≥ 0: then N = W − T sin β and F = T cos β give one condition, which contains β > θ."""
    solution = solve(problem(DRAWN))
    [answer] = compared_answers(solution)
    assert answer.verdict.value == "equivalent"
    assert solution.own.at_rest is not None
    assert [len(case) for case in solution.own.at_rest.cases] == [1]


BEAM = """title: A beam on rough ground that leans on a smooth rail
parameters: [m, g, a, h, mu]
coordinates: [x, y, theta]
bodies: {beam: {mass: m, position: x*i + y*j, angle: theta}}
constraints:
  ground: {equation: y >= a*sin(theta), reaction: R}
  rail: {equation: "(y - h)*cos(theta) - x*sin(theta) >= 0", reaction: N}
gravity: -g*j
forces: {rub: {friction: mu, static: mu, constraint: ground, on: beam, at: r_beam - a*e1_beam, slip: -i}}
find: impending
"""


def test_a_limit_that_is_no_angle_in_closed_form_is_a_coefficient(problem: Read) -> None:
    """N = m g a sin θ cos θ/h (a cos θ arm), F = N sin θ, R = m g − N cos θ: μ = F/R."""
    motions = solve(problem(BEAM)).own.impending
    assert motions is not None
    [b] = motions[0].equilibrium.branches
    [limit] = [r for r in b.relations if r.lhs.name == "mu"]
    numbers = {"a": 1.5, "h": 1, "theta": sp.pi / 6}
    value = limit.rhs.xreplace({s: numbers[s.name] for s in limit.rhs.free_symbols}).evalf()
    assert abs(value - 3 * sp.sqrt(3) / 7) < 1e-9
    assert not b.left


TWO_BLOCKS = """title: Two blocks joined by a bar on an incline
parameters: {W_1: positive, W_2: positive, l: positive, alpha: acute, mu_1: positive, mu_2: positive}
coordinates: [x_1, y_1, x_2, y_2]
let: {down: "sin(alpha)*i - cos(alpha)*j"}
particles: {upper: {position: x_1*i + y_1*j}, lower: {position: x_2*i + y_2*j}}
constraints:
  plane_1: {equation: y_1 >= 0, reaction: N_1}
  plane_2: {equation: y_2 >= 0, reaction: N_2}
  bar: {equation: x_2 - x_1 = l, reaction: S, by: rod}
forces:
  weight_1: {on: upper, vector: W_1*down}
  weight_2: {on: lower, vector: W_2*down}
  rub_1: {friction: mu_1, static: mu_1, constraint: plane_1, on: upper, slip: i}
  rub_2: {friction: mu_2, static: mu_2, constraint: plane_2, on: lower, slip: i}
find: [equilibrium, impending]
ask: {bar: {quantity: S, when: x_1 = 0}}
answers: {ask: {bar: (mu_1 - mu_2)*W_1*W_2*cos(alpha)/(W_1 + W_2)}}
"""


def test_a_force_at_the_limit_with_the_relation_of_the_limit_put_in(problem: Read) -> None:
    """S = W_1 (μ_1 cos α − sin α) with (W_1 + W_2) tan α = μ_1 W_1 + μ_2 W_2 there."""
    solution = solve(problem(TWO_BLOCKS))
    assert all(c.passed for c in solution.checks)
    assert [a.verdict.value for a in compared_answers(solution)] == ["equivalent"]
