"""Questions about the motion after an impact, against results worked out by hand.

Where an impulse vanishes, and that the place exists.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import NotCoveredError, ProblemError, Source
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.mechanics.through_impact import Vanishing, vanishings
from lagrange.problem.loader import read_problem
from tests.support.shared import reported

BALL = """
title: Ball
parameters: {m: positive, g: positive, h: positive, e: {assume: positive, range: [0, 1]}}
coordinates: [y]
particles: {ball: {mass: m, position: y*j}}
gravity: -g*j
impact:
  before: {y: 0, y': -sqrt(2*g*h)}
  constraints: {floor: y >= 0}
  restitution: {floor: e}
ask:
  height: {quantity: y, when: y' = 0}
  back: {quantity: t, when: y = 0}
"""
ROD = """
title: Rod
parameters: [m, l, g, v]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: m*l^2/3, position: x*i + y*j, angle: theta}}
gravity: -g*j
impact:
  before: {x: l, y: 0, theta: 0, x': 0, y': -v, theta': 0}
  constraints: {hinge: r_rod - l*(cos(theta)*i + sin(theta)*j) = 0}
ask:
  at_once: {quantity: theta', when: t = 0}
  below: {quantity: theta', when: theta = -pi/2}
"""


def solved(text: str) -> Solution:
    solution = solve(read_problem(Source("case.yaml", text)))
    assert [c.name for c in solution.checks if c.passed is not True] == []
    return solution


def answers(solution: Solution) -> dict[str, sp.Expr]:
    found = {}
    for a in solution.asked:
        [b] = a.branches
        found[a.question.name] = b.rhs
    return found


def equal(a: sp.Expr, b: str) -> bool:
    other = sp.sympify(b, locals={s.name: s for s in a.free_symbols})
    return bool(sp.simplify(a - other) == 0)


def test_a_ball_that_rebounds() -> None:
    found = answers(solved(BALL))
    assert equal(found["height"], "e**2*h")
    assert equal(found["back"], "2*e*sqrt(2*h/g)")


def test_a_new_constraint_without_restitution_remains_and_one_with_it_does_not() -> None:
    ball, rod = solved(BALL), solved(ROD)
    assert ball.after is not None
    assert rod.after is not None
    assert ball.after.problem.constraints == ()
    assert [c.name for c in rod.after.problem.constraints] == ["hinge.1", "hinge.2"]
    found = answers(rod)
    assert equal(found["at_once"], "-3*v/(4*l)")
    assert equal(found["below"], "-sqrt(9*v**2/(16*l**2) + 3*g/(2*l))")


def test_the_ballistic_pendulum_in_its_angle() -> None:
    report = reported("ballistic-pendulum")
    after = report.solution.after
    assert after is not None
    assert [c.coordinates for c in after.problem.choices] == [(sp.Symbol("theta", real=True),)]
    titles = [s.title for s in report.derivation.steps]
    assert titles.index("The motion after the impact") < titles.index("Extreme value of the angle")


FLOOR = """
title: Ball
parameters: [m, g, v, w]
coordinates: [x, y]
particles: {ball: {mass: m, position: x*i + y*j}}
gravity: -g*j
impact:
  before: {x: 0, y: 0, x': w, y': -v}
  constraints: {floor: {equation: y >= 0, reaction: N}}
  restitution: {floor: 0}
ask:
  push: {quantity: N, when: t = 0}
"""


def test_reactions_of_new_constraints_while_they_act() -> None:
    assert equal(answers(solved(FLOOR))["push"], "m*g")
    with pytest.raises(NotCoveredError, match="`N` after the impact"):
        solve(read_problem(Source("case.yaml", FLOOR.replace("{floor: 0}", "{floor: 1/2}"))))


def test_the_initial_state_is_that_just_before_the_impact() -> None:
    moved = FLOOR.replace("x: 0, y: 0, ", "") + "initial: {x: 0, y: 0, x': w}\n"
    assert equal(answers(solved(moved))["push"], "m*g")
    with pytest.raises(ProblemError, match="`x` has different values at t = 0 and just before"):
        read_problem(Source("case.yaml", FLOOR + "initial: {x: 1}\n"))
    with pytest.raises(ProblemError, match="not with `initial`"):
        solve(read_problem(Source("case.yaml", FLOOR + "initial: {x: 0}\nfind: [motion, impact]\n")))


def test_a_question_in_a_coordinate_that_is_lost_is_refused() -> None:
    text = ROD.replace(
        "ask:", "generalized_coordinates: {w: {coordinates: [x, y, phi], substitute: {theta: phi + x}}}\nask:"
    )
    text = text.replace("quantity: theta', when: t = 0", "quantity: phi', when: t = 0")
    with pytest.raises(NotCoveredError, match="`phi` after the impact"):
        solve(read_problem(Source("case.yaml", text)))


# Vanishing impulses


a, b, l, h, R, J = sp.symbols("a b l h R J", positive=True)


def test_the_centre_of_percussion() -> None:
    assert [*vanishings(J * (3 * a - 2 * l) / (2 * l), [sp.S.One, l / 2])] == [Vanishing(3 * a, 2 * l, turns=True)]


def test_an_even_power_keeps_the_sense() -> None:
    [found] = vanishings(J * (a - l) ** 2 / l**2, [])
    assert not found.turns


def test_what_cannot_vanish_or_would_need_an_imaginary_position_is_not_a_place() -> None:
    assert not [*vanishings(J * (a + l) / l, [])]
    assert [*vanishings(J * (2 * h - 3 * R) / R, [sp.sqrt(2 * h * R - h**2)])]
    assert not [*vanishings(J * (2 * h - 5 * R) / R, [sp.sqrt(2 * h * R - h**2)])]


PERCUSSION = """
title: Rod that is struck
axes: {i: right, j: up}
parameters: [m, l, J, b]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: m*l^2/12, position: x*i + y*j, angle: theta}}
constraints:
  along: {equation: x = l/2*sin(theta), reaction: H}
  up: {equation: y = -l/2*cos(theta), reaction: V}
gravity: -9.81*j
impact:
  before: {x: 0, y: -l/2, theta: 0, theta': 0, x': 0, y': 0}
  impulses: {blow: {on: rod, vector: J*i, at: -b*j}}
find: impact
ask:
  sweet: {quantity: b, when: H = 0}
  half: {quantity: b, when: H = -J/2}
  swing: {quantity: "theta'", when: t = 0}
"""


def test_a_question_for_a_parameter_about_reactions_alone_is_about_their_impulses() -> None:
    """Momentum about the hinge, J b = m l²/3 ω, and of the centre, J + H = m ω l/2."""
    problem = read_problem(Source("rod.yaml", PERCUSSION))
    solution = solve(problem)
    assert [a.question.name for a in solution.asked] == ["sweet", "half", "swing"]
    m, l, J, b = (p.symbol for p in problem.parameters)
    values = [a.branches[0].values[0] for a in solution.asked]
    assert [sp.simplify(v - e) for v, e in zip(values, (2 * l / 3, l / 3, 3 * J * b / (m * l**2)), strict=True)] == [
        0
    ] * 3
    alone = solve(read_problem(Source("rod.yaml", PERCUSSION[: PERCUSSION.index("  half")])))
    assert [a.branches[0].values for a in alone.asked] == [(2 * l / 3,)]


def test_a_parameter_that_no_impulse_determines_is_asked_for_after_the_impact() -> None:
    text = PERCUSSION[: PERCUSSION.index("  sweet")] + "  none: {quantity: m, when: V = 0}\n"
    solution = solve(read_problem(Source("rod.yaml", text)))
    assert solution.after is not None
    assert not solution.asked[0].answered
