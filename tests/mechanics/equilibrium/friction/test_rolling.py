"""Rolling without slipping: the least coefficient of friction, against formulas by hand."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

INCLINE = """title: A body rolls down an incline
parameters: [m, g, R, alpha, mu, mu_s]
coordinates: [x, y, theta]
bodies: {{body: {{mass: m, inertia: {inertia}, position: x*i + y*j, angle: -theta}}}}
constraints: {{plane: {{equation: {plane}, reaction: N}}, rolling: {{equation: "{rolling}", reaction: F}}}}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
forces: {{rub: {{friction: mu, {static}constraint: plane, on: body, at: r_body - R*j}}}}
answers: {{rest: ["{rest}"]}}
"""
BOX = {"plane": "y >= R", "rolling": "x' = R*theta'", "static": "static: mu_s, ", "inertia": "m*R^2/2"}
PULLED = """title: A wheel is pulled by a moment
parameters: [m, g, R, M_0, mu]
coordinates: [x, y, theta]
bodies: {wheel: {mass: m, inertia: m*R^2, position: x*i + y*j, angle: -theta}}
constraints: {floor: {equation: y >= R, reaction: N}, rolling: {equation: "x = R*theta", reaction: F}}
gravity: -g*j
forces:
  motor: {on: wheel, moment: -M_0*k}
  rub: {friction: mu, static: mu, constraint: floor, on: wheel, at: r_wheel - R*j}
answers: {rest: ["M_0 <= 2*mu*m*g*R"]}
"""


@pytest.mark.parametrize(
    ("changes", "rest", "verdict"),
    [
        ({}, "tan(alpha) <= 3*mu_s", "equivalent"),  # 1 + m R²/I
        ({}, "tan(alpha) <= 2*mu_s", "wrong"),
        ({"inertia": "m*R^2"}, "tan(alpha) <= 2*mu_s", "equivalent"),
        ({"inertia": "2/5*m*R^2"}, "mu_s >= 2/7*tan(alpha)", "equivalent"),
        ({"plane": "y = R"}, "tan(alpha) <= 3*mu_s", "equivalent"),
        ({"rolling": "x = R*theta"}, "tan(alpha) <= 3*mu_s", "equivalent"),
    ],
)
def test_rolling_down_an_incline(problem: Read, changes: dict[str, str], rest: str, verdict: str) -> None:
    solution = solve(problem(INCLINE.format(**(BOX | changes | {"rest": rest}))))
    assert all(c.passed for c in solution.checks)
    [answer] = compared_answers(solution)
    assert (answer.name, answer.verdict.value) == ("rest", verdict)
    assert solution.own.dynamics is not None
    assert solution.own.dynamics.friction_forces == ()


def test_a_driven_wheel(problem: Read) -> None:
    """F = M_0/(2R) forward for a hoop."""
    [answer] = compared_answers(solve(problem(PULLED)))
    assert answer.verdict.value == "equivalent"


def test_what_rolls_has_no_kinetic_friction(problem: Read) -> None:
    with pytest.raises(ProblemError, match="does not slip") as caught:
        solve(problem(INCLINE.format(**(BOX | {"static": "", "rest": "mu_s >= 0"}))))
    assert caught.value.diagnostics[0].code == "friction-slip"
