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
        (SMOOTH, "[tan(theta) >= 2*mu_A]", "wrong"),
        (COLLAR, "2*a*mu >= h", "equivalent"),
        (COLLAR, "a*mu > h", "wrong"),
        (STACKED, "[F <= mu_1*m*g]", "incomplete"),
        (STACKED, "[F <= mu_1*m*g, F <= mu_2*(m + M)*g]", "equivalent"),
        (HELD, "[P <= W*(tan(alpha) + mu)/(1 - mu*tan(alpha)), P >= W*tan(alpha - atan(mu))]", "equivalent"),
        (HELD, "[P <= W*tan(alpha + atan(mu)), P >= W*tan(alpha - atan(mu))]", "equivalent"),
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
