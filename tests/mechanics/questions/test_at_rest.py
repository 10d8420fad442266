"""Questions about a system at rest, by hand and by differences."""

from __future__ import annotations

from collections.abc import Callable
from math import acos, atan, cos, exp, isclose, pi, sin, sqrt

import pytest
import sympy as sp

from lagrange.answers.questions.asked_quantities import check_asked
from lagrange.core.diagnostics import ProblemError, Source
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


MOTOR = """
title: Motor whose weight keeps a belt tight
parameters: {W: 500 N, c: 0.3 m, h: 0.2 m, r: 80 mm, mu: 0.35}
unknowns: [M, T_1, T_2]
coordinates: {theta: angle of the base, phi: angle of the pulley}
bodies:
  base: {position: 0*i, angle: theta}
  pulley: {position: c*e1_base + h*e2_base, angle: phi}
forces:
  weight: {on: pulley, vector: -W*j}
  upper: {on: pulley, vector: -T_1*i, at: r_pulley + r*j}
  lower: {on: pulley, vector: -T_2*i, at: r_pulley - r*j}
  motor: {on: pulley, moment: M*k}
  stator: {on: base, moment: -M*k}
  belt: {belt: mu, angle: pi, tight: T_2, slack: T_1}
find: impending
ask:
  greatest: {quantity: M, when: theta = 0}
"""


def test_the_law_of_a_belt_at_its_limit_determines_the_moment() -> None:
    """Moments about the hinge: T_1 (h + r) + T_2 (h - r) = W c, with T_2 = T_1 exp(pi mu) and M = (T_2 - T_1) r."""
    solution = solve(read_problem(Source("motor.yaml", MOTOR)))
    [greatest] = solution.asked
    ratio = exp(0.35 * pi)
    slack = 500 * 0.3 / (0.28 + 0.12 * ratio)
    values = {p.symbol: p.value for p in solution.problem.parameters}
    assert isclose(float(greatest.branches[0].rhs.xreplace(values)), slack * (ratio - 1) * 0.08, rel_tol=1e-9)
    assert all(c.passed for c in solution.checks)


CORD = """
title: Cylinder on a rough incline, held by a level cord
parameters: {W: positive, R: positive, alpha: acute, mu: positive, b: positive}
unknowns: [T]
coordinates: [x, y, phi]
let: {n: -sin(alpha)*i + cos(alpha)*j}
bodies:
  cylinder: {position: x*i + y*j, angle: phi}
constraints:
  incline: {equation: "dot(r_cylinder, n) >= R", reaction: N}
forces:
  weight: {on: cylinder, vector: -W*j}
  cord: {on: cylinder, vector: T*i, at: r_cylinder + R*j}
  rub: {friction: mu, static: mu, constraint: incline, on: cylinder, at: r_cylinder - R*n}
find: equilibrium
ask:
  tension: {quantity: T, when: phi = 0}
"""


def test_friction_at_rest_is_an_unknown_of_the_balance() -> None:
    """About the point of contact: T R (1 + cos alpha) = W R sin alpha. Nothing moves, so no inertia is needed."""
    problem = read_problem(Source("cord.yaml", CORD))
    solution = solve(problem)
    W, alpha = (problem.scope.scalars[n] for n in ("W", "alpha"))
    [tension] = solution.asked
    assert sp.simplify(tension.branches[0].rhs - W * sp.sin(alpha) / (1 + sp.cos(alpha))) == 0
    assert all(c.passed for c in solution.checks)


def test_what_friction_leaves_open_is_not_determined() -> None:
    """A block on an incline may lean on a cord with any tension that friction admits."""
    block = CORD.replace("bodies", "particles").replace(", angle: phi", "").replace("x, y, phi", "x, y")
    block = (
        block.replace(", at: r_cylinder - R*n", "").replace(", at: r_cylinder + R*j", "").replace("phi = 0", "x = 0")
    )
    with pytest.raises(ProblemError, match="not determined") as refused:
        solve(read_problem(Source("block.yaml", block)))
    assert "impending" in refused.value.diagnostics[0].help


ROPE = """
title: A sledge drawn by a rope
parameters:
  W: {value: 400 N}
  mu: {value: 0.3}
  beta: {assume: acute, unit: rad}
  a: {unit: m}
  h: {unit: m}
unknowns: [P, M]
coordinates: {x: {unit: m}, y: {unit: m}}
particles: {sledge: {position: x*i + y*j}}
constraints: {ground: {equation: y >= 0, reaction: N}}
forces:
  weight: {on: sledge, vector: -W*j}
  rope: {on: sledge, vector: P*cos(beta)*i + P*sin(beta)*j}
  rub: {friction: mu, static: mu, constraint: ground, on: sledge, slip: i}
find: impending
ask:
"""


@pytest.mark.parametrize(
    ("when", "angle"),
    [
        ("tan(beta) = mu", lambda mu: atan(mu)),
        ("sin(beta) = mu*cos(beta)", lambda mu: atan(mu)),
        ("cos(beta) = 2*mu", lambda mu: acos(2 * mu)),
        ("beta = 60 deg", lambda _: pi / 3),
        ("[sin(beta) = h/a, a = 2*h]", lambda _: pi / 6),
        ("[sin(beta) = h/a, a^2 = 2*h^2]", lambda _: pi / 4),
    ],
)
def test_relations_between_parameters_are_put_into_the_answer(when: str, angle: Callable[[float], float]) -> None:
    """The pull of a rope at an angle that `when` says: a number, P = μ W/(cos β + μ sin β)."""
    beta = angle(0.3)
    pull = 0.3 * 400 / (cos(beta) + 0.3 * sin(beta))
    text = ROPE + f"  pull: {{quantity: P, when: {when}}}\nanswers: {{ask: {{pull: {pull:.4g} N}}}}\n"
    solution = solve(read_problem(Source("rope.yaml", text)))
    [branch] = solution.asked[0].branches
    assert isclose(branch.rhs.xreplace(solution.problem.given_values), pull, rel_tol=1e-9)
    assert all(c.passed for c in solution.checks)


def test_an_answer_in_letters_that_when_relates_is_right() -> None:
    """P = μ W/(cos β + μ sin β) is right where tan β = μ, and so is P = W sin β; P = W tan β is not."""
    text = ROPE + "  pull: {quantity: P, when: tan(beta) = mu}\nanswers: {ask: {pull: %s}}\n"
    stated = {"mu*W/(cos(beta) + mu*sin(beta))": "equivalent", "W*sin(beta)": "equivalent", "W*tan(beta)": "wrong"}
    for answer, verdict in stated.items():
        solution = solve(read_problem(Source("rope.yaml", text % answer)))
        assert check_asked(dict(solution.problem.answers.ask), solution).verdict.value == verdict, answer


@pytest.mark.parametrize("when", ["beta = 120 deg", "a = -h", "sin(beta) = 2"])
def test_what_parameters_cannot_be_never_holds(when: str) -> None:
    text = ROPE + f"  pull: {{quantity: P, when: {when}}}\n"
    with pytest.raises(ProblemError) as raised:
        solve(read_problem(Source("rope.yaml", text)))
    assert [d.code for d in raised.value.diagnostics] == ["never-holds"]


def test_a_relation_between_parameters_that_is_not_solved_leaves_no_answer() -> None:
    text = ROPE + "  pull: {quantity: P, when: cos(beta) = beta}\n"
    [asked] = solve(read_problem(Source("rope.yaml", text))).asked
    assert not asked.answered


HELD = """
title: A loaded ladder on rough ground against a rough wall
parameters:
  W: {value: 300 N}
  l: {value: 4 m}
  mu: {value: 0.5}
  s: {unit: m, meaning: way of the load along the ladder}
coordinates: {x: {unit: m}, y: {unit: m}, theta: {range: [0, 90 deg]}}
bodies: {ladder: {position: x*i + y*j, angle: pi - theta}}
constraints:
  ground: {equation: y >= l/2*sin(theta), reaction: N_A}
  wall: {equation: x >= l/2*cos(theta), reaction: N_B}
forces:
  load: {on: ladder, vector: -W*j, at: r_ladder + (s - l/2)*e1_ladder}
  foot: {friction: mu, static: mu, constraint: ground, on: ladder, at: r_ladder - l/2*e1_ladder, slip: i}
  top: {friction: mu, static: mu, constraint: wall, on: ladder, at: r_ladder + l/2*e1_ladder, slip: -j}
find: impending
ask:
  wall: {quantity: N_B, when: theta = 45 deg}
answers: {ask: {wall: 120 N}}
"""


def test_the_second_route_knows_which_parameter_a_limit_determines() -> None:
    """N_B = μ W/(1 + μ²) = 120 N for the only place of the load at which the ladder slips at 45°: s = l (μ + μ²)/(1 + μ²)."""
    solution = solve(read_problem(Source("held.yaml", HELD)))
    [state] = solution.asked[0].branches[0].states
    s = next(v for p, v in state.items() if p.name == "s")
    assert s.xreplace(solution.problem.given_values) == sp.Rational(12, 5)
    assert all(c.passed for c in solution.checks)
