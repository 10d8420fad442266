"""Stated conditions of rest, compared with those derived."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import check_answer
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import Fragment
from tests.mechanics.equilibrium.friction.test_conditions_of_rest import COLLAR, HELD, SMOOTH, STACKED
from tests.mechanics.equilibrium.friction.test_friction_at_rest import ROUGH, Read, solved


@pytest.mark.parametrize(
    ("text", "stated", "verdict"),
    [
        (ROUGH, "[(1 - mu_A*mu_B)*tan(theta) <= 2*mu_A]", "equivalent"),
        (ROUGH, "[(1 + mu_A*mu_B)*tan(theta) <= 2*mu_A]", "wrong"),
        (SMOOTH, "[tan(theta) <= 2*mu_A]", "equivalent"),
        (SMOOTH, "[theta <= atan(2*mu_A)]", "equivalent"),
        (SMOOTH, "[atan(tan(theta)/2) <= atan(mu_A)]", "equivalent"),
        (SMOOTH, "[tan(theta) >= 2*mu_A]", "wrong"),
        (COLLAR, "2*a*mu >= h", "equivalent"),
        (COLLAR, "a*mu > h", "wrong"),
        (STACKED, "[F <= mu_1*m*g]", "incomplete"),
        (STACKED, "[F <= mu_1*m*g, F <= mu_2*(m + M)*g]", "equivalent"),
        (HELD, "[P <= W*(tan(alpha) + mu)/(1 - mu*tan(alpha)), P >= W*tan(alpha - atan(mu))]", "equivalent"),
        (HELD, "[P <= W*tan(alpha + atan(mu)), P >= W*tan(alpha - atan(mu))]", "equivalent"),
        (HELD, "[atan(P/W) <= alpha + atan(mu), atan(P/W) >= alpha - atan(mu)]", "equivalent"),
        (HELD, "[atan(P/W) <= alpha + 2*atan(mu), atan(P/W) >= alpha - 2*atan(mu)]", "wrong"),
        (HELD, "[P <= W*(tan(alpha) + mu)/(1 - 2*mu*tan(alpha)), P >= W*tan(alpha - atan(mu))]", "wrong"),
    ],
)
def test_answers(problem: Read, text: str, stated: str, verdict: str) -> None:
    [answer] = compared_answers(solved(problem, f"{text}answers: {{rest: {stated}}}\n"))
    assert (answer.name, answer.verdict.value) == ("rest", verdict)


@pytest.mark.parametrize(
    ("text", "answer", "verdict"),
    [
        (ROUGH, ["(1 - mu_A*mu_B)*tan(theta) <= 2*mu_A"], "equivalent"),
        (ROUGH, ["tan(theta) <= 3*mu_A"], "wrong"),
        (ROUGH, [r"\tan\theta \le \mu_A (2 + \mu_B \tan\theta)"], "equivalent"),
        (STACKED, ["F <= mu_1*m*g, F <= mu_2*(m + M)*g"], "equivalent"),
        (STACKED, ["F <= mu_1*m*g", "F <= mu_2*(m + M)*g"], "equivalent"),
        (STACKED, ["F <= mu_1*m*g"], "incomplete"),
        (COLLAR, ["h <= 2*a*mu", "h = 2*a*mu"], "equivalent"),
        (COLLAR, ["h <= a*mu", "h = 2*a*mu"], "wrong"),
    ],
)
def test_conditions_as_an_answer(problem: Read, text: str, answer: list[str], verdict: str) -> None:
    """`check -e` reads inequalities, alone and beside the limit."""
    judged = check_answer(problem(text), tuple(map(Fragment.of, answer)))
    assert judged.verdict.value == verdict


CRATE = """title: Crate that is pushed
axes: {i: right, j: up}
parameters: {m: 40 kg, g: 9.81 m/s^2, mu: 0.3}
unknowns: [P]
coordinates: [x, y]
particles: {crate: {mass: m, position: x*i + y*j}}
constraints: {floor: {equation: y >= 0, reaction: N}}
gravity: -g*j
forces:
  push: {on: crate, vector: P*i}
  rub: {friction: mu, static: mu, constraint: floor, on: crate}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("stated", "verdict", "reason"),
    [
        ("P <= 117.7 N", "equivalent", ""),
        ("P <= 0.1177 kN", "equivalent", ""),
        ("P <= 26.46 lb", "equivalent", ""),
        ("P >= -117.7 N", "incomplete", "P has an upper limit as well"),
        ("P >= 117.7 N", "wrong", "the inequality has the wrong sense: its limit is right"),
        ("P <= 120 N", "wrong", ""),
    ],
)
def test_limits_of_a_force_in_numbers_with_units(problem: Read, stated: str, verdict: str, reason: str) -> None:
    [answer] = compared_answers(solved(problem, f"{CRATE}answers: {{rest: [{stated}]}}\n"))
    assert answer.verdict.value == verdict
    assert reason in answer.diagnosis


PARABOLA = """title: Rough parabola
parameters: [m, g, a, mu]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {wire: {equation: x^2 = 4*a*y, reaction: N}}
gravity: -g*j
forces: {rub: {friction: mu, static: mu, constraint: wire, on: P}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [("y <= a*mu^2", "equivalent"), ("abs(x) <= 2*a*mu", "equivalent"), ("y <= 2*a*mu^2", "wrong")],
)
def test_conditions_hold_where_the_constraints_do(problem: Read, answer: str, verdict: str) -> None:
    """The derived condition is about x, which the height determines on the wire."""
    judged = check_answer(problem(PARABOLA), (Fragment.of(answer),))
    assert judged.verdict.value == verdict


RING = """
title: A ring on a bar, pulled aside and upwards with the same force
parameters: [W, P, mu]
coordinates: [x, y]
particles: {B: {position: x*i + y*j}}
constraints: {bar: {equation: y = 0, reaction: N}}
forces:
  pull: {on: B, vector: P*i + P*j}
  weight: {on: B, vector: -W*j}
  rub: {friction: mu, static: mu, constraint: bar, on: B}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("P <= mu*abs(W - P)", "equivalent"),
        ("P^2 <= mu^2*(W - P)^2", "equivalent"),
        ("P^2 <= mu*(W - P)^2", "wrong"),
        ("P <= mu*(W - P)", "incomplete"),  # N upwards; it may rest with N downwards, too
        ("P <= mu*(P - W)", "incomplete"),
        ("P <= mu*(W + P)", "wrong"),
        ("P <= mu*(W - P)/2", "wrong"),
    ],
)
def test_one_of_two_cases_is_incomplete(problem: Read, stated: str, verdict: str) -> None:
    [answer] = compared_answers(solved(problem, f"{RING}answers: {{rest: [{stated}]}}\n"))
    assert answer.verdict.value == verdict
    assert ("one of several cases" in answer.diagnosis) is (verdict == "incomplete")


@pytest.mark.parametrize(
    ("text", "answer", "verdict"),
    [
        (ROUGH, "tan(theta) <= 2*mu_A/(1 - mu_A*mu_B) or mu_A*mu_B >= 1", "equivalent"),
        (ROUGH, "tan(theta) <= mu_A/(1 - mu_A*mu_B) or mu_A*mu_B >= 1", "wrong"),
        (ROUGH, "mu_A*mu_B >= 1", "incomplete"),
        (ROUGH, "mu_A*mu_B >= 2", "wrong"),
        (ROUGH, r"$\tan\theta \le \frac{2\mu_A}{1 - \mu_A\mu_B}$ or $\mu_A\mu_B \ge 1$", "equivalent"),
        (STACKED, "F <= mu_1*m*g or F <= mu_2*(m + M)*g", "wrong"),
    ],
)
def test_cases_of_rest(problem: Read, text: str, answer: str, verdict: str) -> None:
    assert check_answer(problem(text), (Fragment.of(answer),)).verdict.value == verdict


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        (r"F \le \min\left\{\mu_1mg,\ \mu_2(m + M)g\right\}", "equivalent"),
        (r"F \le \min\{\mu_1mg, \mu_2Mg\}", "wrong"),
        ("F <= mu_1*m*g und F <= mu_2*(m + M)*g", "equivalent"),
        ("F <= mu_1*m*g et F <= mu_2*M*g", "wrong"),
        ("F ≤ mu_1*m*g; kein Rutschen unten: F ≤ mu_2*(m + M)*g", "equivalent"),
    ],
)
def test_minima_in_braces_and_conjunctions(problem: Read, answer: str, verdict: str) -> None:
    assert check_answer(problem(STACKED), (Fragment.of(answer),)).verdict.value == verdict
