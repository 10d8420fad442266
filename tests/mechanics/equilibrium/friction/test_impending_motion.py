"""Motion that impends: friction at its limit, in each sense of slip."""

from __future__ import annotations

import math

import pytest
from sympy.parsing.sympy_parser import parse_expr

from lagrange.core.diagnostics import ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.results import with_known_values
from lagrange.mechanics.solution import solve
from lagrange.problem.values import values_of
from lagrange.render import json as in_json
from tests.mechanics.equilibrium.friction.test_friction_at_rest import ABOVE, INCLINE, LADDER, PUSHED, Read, solved


def test_without_a_sense_both_are_tried(problem: Read) -> None:
    text = (
        INCLINE.format(relation="=", more="", find="impending")
        .replace("P, ", "")
        .replace("  push: {on: block, vector: P*(-cos(alpha)*i - sin(alpha)*j)}\n", "")
    )
    written = in_json.as_object(report(problem(text)))
    assert written["equilibrium"] == [["tan(alpha) = mu_s", "y = 0"]]


def test_slips_that_no_displacement_has(problem: Read) -> None:
    """A ladder that slides out below slides down above, and never up: x = 2l sin θ, y = 2l cos θ of the ends."""
    text = LADDER.format(below="", above=ABOVE % "", find="impending")
    motions = next(v.impending for v in reversed(solved(problem, text).views) if v.impending)
    [motion] = motions
    friction = {c.name: (c.tangents[0] * motion.senses[c.name]).fixed().components for c in motion.contacts}
    assert friction == {"below": (-1, 0, 0), "above": (0, 1, 0)}
    [relation] = (r for r in motion.equilibrium.branches[0].relations if "theta" in str(r.lhs))
    values = {"mu_A": 0.4, "mu_B": 0.3}
    assert float(relation.rhs.subs({s: values[s.name] for s in relation.rhs.free_symbols})) == pytest.approx(0.8 / 0.88)
    assert str(relation.rhs) == "2*mu_A/(-mu_A*mu_B + 1)"


def test_impending_motion_needs_friction(problem: Read) -> None:
    text = PUSHED.replace("  rub: {friction: mu, static: mu_s, constraint: plane, on: block}\n", "")
    with pytest.raises(ProblemError) as caught:
        solve(problem(text.replace("find: equilibrium", "find: impending")))
    assert caught.value.diagnostics[0].code == "impending-without-friction"


BRACKET = """title: Bracket on a pipe
parameters: {W: positive, d: positive, h: positive, mu: positive}
unknowns: [s]
coordinates: [x, y, theta]
bodies: {bracket: {position: x*i + y*j, angle: theta}}
let: {A: r_bracket + d/2*e1_bracket - h*e2_bracket, B: r_bracket - d/2*e1_bracket}
constraints:
  low: {equation: "dot(A, i) >= d/2", reaction: N_A}
  high: {equation: "dot(B, i) <= -d/2", reaction: N_B}
forces:
  load: {on: bracket, vector: -W*j, at: r_bracket + s*e1_bracket}
  fA: {friction: mu, static: mu, constraint: low, on: bracket, at: A, slip: -j}
  fB: {friction: mu, static: mu, constraint: high, on: bracket, at: B, slip: -j}
find: impending
answers: {equilibrium: ["s = h/(2*mu)"]}
"""


def test_the_position_that_the_constraints_hold_is_used(problem: Read) -> None:
    """2 μ N = W and N h = W s, upright; the book's s = h/(2 μ) is right, and 2 s is not."""
    right = report(problem(BRACKET))
    [branch] = (b for v in right.solution.views for m in v.impending or () for b in m.equilibrium.branches)
    [relation] = branch.relations
    assert str(relation.rhs) == "h/(2*mu)"
    assert [v.verdict.value for v in right.answers] == ["equivalent"]
    wrong = report(problem(BRACKET.replace("h/(2*mu)", "h/mu")))
    assert [v.verdict.value for v in wrong.answers] == ["wrong"]


def test_what_friction_alone_holds(problem: Read) -> None:
    """A stone that an arm presses to the wall: the arm's own balance says what μ must be, h N = d μ N."""
    text = """title: Arm that holds a stone by friction
parameters: {W: positive, d: positive, h: positive, mu: positive}
coordinates: [x, y, theta, Y]
bodies: {arm: {position: x*i + y*j, angle: theta}}
particles: {stone: {position: Y*j}}
constraints:
  across: {equation: x = d*cos(theta) + h*sin(theta), reaction: A_x}
  up: {equation: y = d*sin(theta) - h*cos(theta), reaction: A_y}
  grip: {equation: "dot(r_arm - r_stone, i) >= d", reaction: N}
forces:
  weight: {on: stone, vector: -W*j}
  rub: {friction: mu, static: mu, constraint: grip, on: arm, at: r_arm, slip: j}
find: impending
"""
    written = in_json.as_object(report(problem(text)))
    assert [[e for e in branch if "mu" in e] for branch in written["equilibrium"]] == [["h/d = mu"]]


WEDGE = """title: Wedge driven under a block
parameters: {W: positive, P: positive, alpha: 10 deg, mu: 0.27}
coordinates: [x, y, z, n]
particles: {wedge: {mass: 0, position: x*i + z*j}, block: {mass: 0, position: n*i + y*j}}
constraints:
  floor: {equation: z >= 0, reaction: N_1}
  face: {equation: y >= z + (x - n)*tan(alpha), reaction: N_2}
  wall: {equation: n <= 0, reaction: N_3}
forces:
  weight: {on: block, vector: -W*j}
  push: {on: wedge, vector: P*i}
  below: {friction: mu, static: mu, constraint: floor, on: wedge, slip: i}
find: impending
"""


@pytest.mark.parametrize("values", ["", ", 400 N"])
def test_limits_are_solved_for_what_has_no_value(problem: Read, values: str) -> None:
    """By hand: N_2 cos α = W and P = N_2 sin α + μ W, so that P = W (tan α + μ)."""
    text = WEDGE if not values else WEDGE.replace("W: positive", "W: 400 N")
    [branch] = in_json.as_object(report(problem(text)))["equilibrium"]
    [limit] = (e.split(" = ")[1] for e in branch if e.startswith("P = "))
    size = parse_expr(limit.replace("^", "**")).subs({"W": 400, "alpha": math.pi / 18, "mu": 0.27})
    assert float(size) == pytest.approx(400 * (math.tan(math.pi / 18) + 0.27))


RINGS = """title: Two rings on a rough rod and a weight between them
parameters: [w, W, l, mu]
coordinates: [x_1, y_1, x_2, y_2, x, y]
particles: {A: {position: x_1*i + y_1*j}, B: {position: x_2*i + y_2*j}, C: {position: x*i + y*j}}
constraints:
  left: {equation: y_1 = 0, reaction: N_A}
  right: {equation: y_2 = 0, reaction: N_B}
  string_A: {equation: norm(r_C - r_A) <= l, reaction: T_A}
  string_B: {equation: norm(r_C - r_B) <= l, reaction: T_B}
forces:
  w_A: {on: A, vector: -w*j}
  w_B: {on: B, vector: -w*j}
  w_C: {on: C, vector: -W*j}
  f_A: {friction: mu, static: mu, constraint: left, on: A, slip: i, contact: positive}
  f_B: {friction: mu, static: mu, constraint: right, on: B, slip: -i, contact: positive}
generalized_coordinates:
  angle: {coordinates: [x, theta], substitute: {x_1: x - l*sin(theta), x_2: x + l*sin(theta), y_1: 0, y_2: 0, y: -l*cos(theta)}}
find: impending
"""


def test_where_displacements_are_singular_all_equations_of_balance_count(problem: Read) -> None:
    """2T cos θ = W, N = w + W/2 and T sin θ = μ N; strings that hang straight down make friction zero."""
    [branch] = in_json.as_object(report(problem(RINGS)))["equilibrium"]
    assert branch == ["tan(theta) = mu*(W + 2*w)/W"]


PUSHED_UP = """title: Block pushed up an incline by a horizontal force
parameters: {W: positive, alpha: acute, mu: positive}
unknowns: [P]
coordinates: [s, n]
particles: {block: {position: s*i + n*j}}
constraints:
  plane: {equation: n >= 0, reaction: N}
forces:
  load: {on: block, vector: -W*sin(alpha)*i - W*cos(alpha)*j}
  push: {on: block, vector: P*(cos(alpha)*i - sin(alpha)*j)}
  rub: {friction: mu, static: mu, constraint: plane, on: block, slip: i}
find: impending
"""


@pytest.mark.parametrize("push", ["P", "-P"])
def test_the_normal_force_presses_at_the_limit(problem: Read, push: str) -> None:
    """N = W/(cos α − μ sin α): on a slope beyond cot α = μ no push slides the block."""
    text = PUSHED_UP.replace("vector: P*(", f"vector: ({push})*(")
    motions = next(v.impending for v in reversed(solved(problem, text).views) if v.impending)
    conditions = [
        f"{c.lhs} {c.relation} {c.rhs}" for m in motions for b in m.equilibrium.branches for c in b.conditions
    ]
    assert conditions == ["cos(alpha) > mu*sin(alpha)"]


ROPE = """title: Crate held on a ramp by a rope
parameters: {W: %s, alpha: %s, beta: %s, mu: %s}
unknowns: [P]
coordinates: [s, n]
particles: {crate: {position: s*i + n*j}}
constraints: {ramp: {equation: n >= 0, reaction: N}}
forces:
  weight: {on: crate, vector: -W*sin(alpha)*i - W*cos(alpha)*j}
  rope: {on: crate, vector: P*cos(beta)*i + P*sin(beta)*j}
  rub: {friction: mu, static: mu, constraint: ramp, on: crate}
find: [equilibrium, impending]
"""


@pytest.mark.parametrize(
    ("given", "conditions"),
    [
        (("positive", "acute", "acute", "positive"), [["cos(beta) ≠ mu*sin(beta)"], ["pi/2 > alpha + beta"]]),
        (("800 N", "25 deg", "15 deg", "0.35"), [[], []]),
    ],
)
def test_limits_have_divisors_that_are_positive_for_little_friction(
    problem: Read, given: tuple[str, ...], conditions: list[list[str]]
) -> None:
    """N = W cos(α + β)/(cos β + μ sin β); of W cos(α + β)/(cos β − μ sin β) two signs are open, and none is stated."""
    found = solved(problem, ROPE % given)
    values = values_of(found.problem)
    views = found.views if values is None else with_known_values(found, values).views
    motions = next(v.impending for v in reversed(views) if v.impending)
    branches = [b for m in motions for b in m.equilibrium.branches]
    assert [str(r.rhs) for b in branches for r in b.relations] == [
        "W*(-mu*cos(alpha) + sin(alpha))/(-mu*sin(beta) + cos(beta))",
        "W*(mu*cos(alpha) + sin(alpha))/(mu*sin(beta) + cos(beta))",
    ]
    assert [[f"{c.lhs} {c.relation} {c.rhs}" for c in b.conditions] for b in branches] == conditions


def test_a_pull_that_would_lift_is_no_limit(problem: Read) -> None:
    """60° and 50°: cos(α + β) < 0, so that the rope would lift the crate off before it slides up."""
    motions = next(v.impending for v in reversed(solved(problem, ROPE % ("800 N", "60 deg", "50 deg", "0.35")).views))
    assert not any(
        "mu*cos(alpha) + sin(alpha)" in str(r.rhs)
        for m in motions or ()
        for b in m.equilibrium.branches
        for r in b.relations
    )
