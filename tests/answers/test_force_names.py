"""What the name of a reaction may stand for in an answer."""

from __future__ import annotations

import pytest

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import check_answer
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import Fragment
from tests.answers.test_reactions import INCLINE, MULTIPLIER, PENDULUM, Read, solution


def test_the_name_of_a_multiplier_has_one_sign(problem: Read) -> None:
    """λ_rod is what the contract says: R = λ ∂f/∂r."""
    for sign, verdict in (("-", Verdict.EQUIVALENT), ("", Verdict.WRONG)):
        stated = f"lambda_rod = {sign}(m*g*cos(theta) + m*l*theta'^2)/(2*l)"
        text = PENDULUM.replace(", reaction: T", "") + f'answers: {{reactions: {{rod: "{stated}"}}}}\n'
        [answer] = compared_answers(solution(problem, text))
        assert (answer.verdict, answer.equations[0].remarks) == (verdict, ())


def test_the_remark_says_in_which_direction_a_force_is_taken(problem: Read) -> None:
    text = f"title: Example\n{INCLINE}constraints: {{plane: {{equation: 'y = -x*tan(alpha)', reaction: N}}}}\n"
    answer = ("m*x'' = -N*sin(alpha)", "m*y'' = -N*cos(alpha) - m*g")
    said = check_answer(problem(text), tuple(map(Fragment.of, answer))).equations
    assert said.verdict is Verdict.EQUIVALENT
    opposite = "`N` is taken along `-sin(alpha)*i - cos(alpha)*j` on `P`; in the derivation it acts along "
    assert [e.remarks for e in said.equations] == [(f"{opposite}`sin(alpha)*i + cos(alpha)*j`",)] * 2
    mixed = ("m*x'' = -N*sin(alpha)", "m*y'' = N*cos(alpha) - m*g")
    assert check_answer(problem(text), tuple(map(Fragment.of, mixed))).verdict is Verdict.WRONG
    multiplier = ("m*x'' = N*tan(alpha)", "m*y'' = N - m*g")
    said = check_answer(problem(text), tuple(map(Fragment.of, multiplier))).equations
    assert said.verdict is Verdict.EQUIVALENT
    assert all(MULTIPLIER in r for e in said.equations for r in e.remarks)


CHAIN = """title: Example
parameters: [m, g, l]
coordinates: [y1, y2]
particles: {A: {mass: m, position: y1*j}, B: {mass: m, position: y2*j}}
constraints: {upper: {equation: y1 = l, reaction: S}, lower: {equation: y2 - y1 = l, reaction: T}}
gravity: g*j
"""


@pytest.mark.parametrize(
    ("answer", "verdict", "remarks"),
    [
        (("m*y1'' = m*g - S + T", "m*y2'' = m*g - T"), Verdict.EQUIVALENT, 0),
        (("m*y1'' = m*g + S - T", "m*y2'' = m*g + T"), Verdict.EQUIVALENT, 3),
        (("m*y1'' = m*g + S + T", "m*y2'' = m*g - T"), Verdict.EQUIVALENT, 1),
        (("m*y1'' = m*g - S - T", "m*y2'' = m*g + T"), Verdict.EQUIVALENT, 2),
        (("m*y1'' = m*g - S + T", "m*y2'' = m*g + T"), Verdict.WRONG, 0),
    ],
)
def test_each_name_has_one_meaning_in_the_whole_answer(
    problem: Read, answer: tuple[str, ...], verdict: Verdict, remarks: int
) -> None:
    said = check_answer(problem(CHAIN), tuple(map(Fragment.of, answer))).equations
    assert said.verdict is verdict
    assert (
        sum(len(e.remarks) for e in said.equations if e.verdict is Verdict.EQUIVALENT and verdict is not Verdict.WRONG)
        == remarks
    )
