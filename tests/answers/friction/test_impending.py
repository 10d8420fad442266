"""Stated equilibria with friction at its limit."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.own_answers import compared_answers
from tests.mechanics.equilibrium.friction.test_conditions_of_rest import COLLAR
from tests.mechanics.equilibrium.friction.test_friction_at_rest import ABOVE, INCLINE, LADDER, Read, solved


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
