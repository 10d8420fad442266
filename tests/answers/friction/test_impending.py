"""Stated equilibria with friction at its limit."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import check_answer
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import Fragment
from tests.mechanics.equilibrium.friction.test_conditions_of_rest import COLLAR
from tests.mechanics.equilibrium.friction.test_friction_at_rest import ABOVE, INCLINE, LADDER, Read, solved
from tests.support.shared import loaded


@pytest.mark.parametrize(
    ("text", "stated", "verdict"),
    [
        (LADDER.format(below=", slip: i", above=ABOVE % ", slip: -j", find="impending"), '["tan(theta) = 2*mu_A/(1 - mu_A*mu_B)"]', "equivalent"),
        (LADDER.format(below=", slip: i", above=ABOVE % ", slip: -j", find="impending"), '["tan(theta) = 2*mu_A"]', "wrong"),
        (COLLAR, '["h = 2*a*mu"]', "equivalent"),
        (INCLINE.format(relation=">=", more=", slip: -i", find="impending").replace("P, ", "") + "unknowns: [P]\n", '["P = m*g*(sin(alpha) + mu_s*cos(alpha))/(cos(alpha) - mu_s*sin(alpha))"]', "equivalent"),
        (INCLINE.format(relation=">=", more=", slip: positive", find="impending").replace("P, ", "") + "unknowns: [P]\n", '["P = m*g*(sin(alpha) - mu_s*cos(alpha))/(cos(alpha) + mu_s*sin(alpha))"]', "equivalent"),
        (INCLINE.format(relation=">=", more="", find="impending").replace("P, ", "") + "unknowns: [P]\n", '[["P = m*g*(sin(alpha) - mu_s*cos(alpha))/(cos(alpha) + mu_s*sin(alpha))"], ["P = m*g*(sin(alpha) + mu_s*cos(alpha))/(cos(alpha) - mu_s*sin(alpha))"]]', "equivalent"),
        (INCLINE.format(relation=">=", more="", find="impending").replace("P, ", "") + "unknowns: [P]\n", '["P = m*g*(sin(alpha) - mu_s*cos(alpha))/(cos(alpha) + mu_s*sin(alpha))"]', "incomplete"),
    ],
)  # fmt: skip
def test_impending_motion(problem: Read, text: str, stated: str, verdict: str) -> None:
    [answer] = compared_answers(solved(problem, f"{text}answers: {{equilibrium: {stated}}}\n"))
    assert (answer.name, answer.verdict.value) == ("equilibrium", verdict)


SLOPE = """
title: Two blocks on a slope, joined by a rope along it
parameters: {W_1: 100 N, W_2: 50 N, mu_1: {value: 0.2}, mu_2: {value: 0.5}, L: m, alpha: acute}
coordinates: [x_1, y_1, x_2, y_2]
particles: {lower: {position: x_1*i + y_1*j}, upper: {position: x_2*i + y_2*j}}
constraints: {slope_1: y_1 >= 0, slope_2: y_2 >= 0, rope: x_1 - x_2 <= L}
forces:
  weight_1: {on: lower, vector: W_1*(sin(alpha)*i - cos(alpha)*j)}
  weight_2: {on: upper, vector: W_2*(sin(alpha)*i - cos(alpha)*j)}
  rub_1: {friction: mu_1, static: mu_1, constraint: slope_1, on: lower, slip: i}
  rub_2: {friction: mu_2, static: mu_2, constraint: slope_2, on: upper, slip: i}
find: impending
"""


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("(W_1 + W_2)*tan(alpha) = mu_1*W_1 + mu_2*W_2", "equivalent"),
        ("tan(alpha) = 0.3", "equivalent"),
        ("10*sin(alpha) = 3*cos(alpha)", "equivalent"),
        ("(W_1 + W_2)*sin(alpha) = 45*cos(alpha)", "equivalent"),  # letters and numbers
        ("(W_1 + W_2)*sin(alpha) = 50*cos(alpha)", "wrong"),
        ("alpha = 16.70 deg", "equivalent"),
        ("tan(alpha) = 0.35", "wrong"),
        ("alpha = 16.9 deg", "wrong"),
    ],
)
def test_the_inclination_at_which_slip_begins_is_no_coordinate(problem: Read, stated: str, verdict: str) -> None:
    """tan α = (μ_1 W_1 + μ_2 W_2)/(W_1 + W_2) = 45/150."""
    [answer] = compared_answers(solved(problem, f'{SLOPE}answers: {{equilibrium: ["{stated}"]}}\n'))
    assert answer.verdict.value == verdict


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("P = W*(tan(alpha + atan(mu)) + mu)", "equivalent"),
        ("P = W*tan(alpha + 2*atan(mu))", "wrong"),  # it has no value at a place where the derived force has one
        ("P = W*(tan(alpha + atan(mu)) - mu)", "wrong"),
    ],
)
def test_an_answer_by_angles_of_friction(stated: str, verdict: str) -> None:
    """A wedge under a load: W tan(α + φ) from the incline, and μ W from the floor."""
    judged = check_answer(loaded("wedge-that-lifts"), (Fragment.of(stated),))
    assert judged.verdict.value == verdict


POST = """title: Turns of a rope on a post
parameters: [P, Q, mu]
unknowns: [beta, T]
coordinates: [y]
particles: {ship: {position: y*j}}
forces:
  pull: {on: ship, vector: Q*j}
  rope: {on: ship, vector: -T*j}
  post: {belt: mu, angle: beta, tight: T, slack: P}
find: [equilibrium, impending]
"""


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("beta = log(Q/P)/mu", "equivalent"),
        ("beta = (log(Q) - log(P))/mu", "equivalent"),
        ("Q = P*exp(mu*beta)", "equivalent"),
        ("beta = log(P/Q)/mu", "wrong"),
    ],
)
def test_an_unknown_angle_of_contact(problem: Read, stated: str, verdict: str) -> None:
    solution = solved(problem, f'{POST}answers: {{equilibrium: ["{stated}"]}}\n')
    [answer] = compared_answers(solution)
    assert answer.verdict.value == verdict
    [condition] = solution.own.at_rest.cases[0]
    assert str(condition.left) == "log(Q/P)/mu"


WEDGE = """
title: A block raised by a wedge
parameters: {W: positive, alpha: acute, phi_s: acute, P: positive}
coordinates: [x, y, u, v]
particles: {wedge: {position: x*i + y*j}, block: {position: u*i + v*j}}
constraints:
  floor: {equation: y >= 0, reaction: N_1}
  slope: {equation: "(v - y)*cos(alpha) + (u - x)*sin(alpha) >= 0", reaction: N_2}
  wall: {equation: u <= 0, reaction: N_3}
forces:
  weight: {on: block, vector: -W*j}
  push: {on: wedge, vector: P*i}
  rub_1: {friction: tan(phi_s), static: tan(phi_s), constraint: floor, on: wedge, slip: i}
  rub_2: {friction: tan(phi_s), static: tan(phi_s), constraint: slope, on: block, slip: "-cos(alpha)*i + sin(alpha)*j"}
find: impending
"""


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("P = W*(tan(phi_s) + tan(alpha + phi_s))", "equivalent"),
        ("P*cos(phi_s)*cos(alpha + phi_s) = W*sin(alpha + 2*phi_s)", "equivalent"),
        ("P = W*(tan(phi_s) + tan(alpha))", "wrong"),
        ("P = W*tan(alpha + phi_s)", "wrong"),
    ],
)
def test_a_load_that_is_given_where_a_divisor_must_not_vanish(problem: Read, stated: str, verdict: str) -> None:
    [answer] = compared_answers(solved(problem, f'{WEDGE}answers: {{equilibrium: ["{stated}"]}}\n'))
    assert answer.verdict.value == verdict
