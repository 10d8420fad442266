"""Wrong conditions of rest, amplitudes, impacts, limits of friction, values: the causes named.

The answers come from wrong models, worked out by a script that shares no code with the program.
"""

from __future__ import annotations

import json

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Source
from lagrange.problem.stated_answers import read_answers
from tests.answers.results.diagnoses import Row, assert_explained, diagnoses
from tests.support.shared import loaded, solved

RESULTS: list[Row] = [
    ("loop-the-loop", "ask", {"least_height": "3*R"}, "the square of the velocity there is half as large"),
    ("ladder-leaves-the-wall", "ask", {"leaves": "cos(theta) = cos(alpha)/3"}, "by how much it has changed since"),
    ("escape-from-a-planet", "ask", {"escape_speed": "sqrt(K/R)"}, "as from a kinetic energy without its 1/2"),
    ("raindrop", "ask", {"acceleration": "x'' = g"}, "without the reactive force on `drop`"),
    ("leaving-a-sphere", "ask", {"speed": "sqrt(2*g*R)"}, "this is the value where theta = pi/2"),
    ("ballistic-pendulum", "ask", {"swing": "cos(theta) = 1 - m*v^2/(2*(M + m)*g*l)"}, "to be conserved in the impact"),
    ("swinging-atwood", "reactions", {"string": "F = 2*M*m*g/(M + m)"}, "the reaction at rest where theta = 0"),
    ("swinging-atwood", "reactions", {"string": "F = M*g"}, "balances the other forces in the equation of y"),
    ("shortening-pendulum", "reactions", {"rope": "T = m*g*cos(phi)"}, "at rest with constant l"),
    (
        "charge-in-a-magnetic-field",
        "hamiltonian",
        "((p_x - q*B*y/2)^2 + (p_y + q*B*x/2)^2)/(2*m) - q*E*y",
        "for B with the",
    ),
    ("pendulum-in-wind", "reactions", {"rod": "W"}, "without F, as if F = 0"),
    ("pendulum-in-wind", "reactions", {"rod": "F + W"}, "two parts at right angles are added"),
    ("bead-in-a-turning-tube", "hamiltonian", "p_r^2/(2*m) + k*(r - a)^2/2 + m*r^2*Omega^2/2", "is wrong"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), RESULTS)
def test_other_results(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


@pytest.mark.parametrize(
    ("problem", "constraint", "stated"),
    [
        ("ex14-two-particles", "rod", "m1*((x2' - x1')^2 + (y2' - y1')^2 + (z2' - z1')^2)/l"),
        ("cylinder-in-cylinder", "rolling", "m*g*sin(phi)*3/7"),
    ],
)
def test_a_wrong_reaction_is_not_called_one_at_rest_because_all_of_it_vanishes_there(
    problem: str, constraint: str, stated: str
) -> None:
    _, diagnosis = diagnoses(problem, {"reactions": {constraint: stated}})
    assert "at rest" not in diagnosis
    assert "balances" not in diagnosis


@pytest.mark.parametrize(
    ("problem", "answers", "where", "why"),
    [
        ("leaving-a-sphere", {"ask": {"leaves": "cos(theta) = 1/2"}}, "", "1/2 of T"),
        ("sphere-in-disguise", {"classification": ["nonholonomic", "scleronomic"]}, "not right: nonholonomic", "law"),
        ("roberval-balance", {"equilibrium": ["P = 2*W"]}, "", "twice as large"),
        ("ex14-two-particles", {"degrees_of_freedom": 6}, "", "not subtracted"),
    ],
)
def test_hint_levels_of_results(problem: str, answers: object, where: str, why: str) -> None:
    read = read_answers(Source("answers", json.dumps(answers)), loaded(problem))
    judgement = Examiner(loaded(problem), solved(problem, complete=False)).check_answers(read)
    said = [" ".join(str(judgement.at_hint_level(level)).split()) for level in (1, 2, 3)]
    assert [why in text for text in said] == [False, False, True]
    assert where in said[1]
    assert not where or where not in said[0]
    [other] = judgement.others
    assert any(why in cause for cause in other.causes)
