"""Wrong equilibria, reactions, frequencies and numbers: the feedback, and that it concerns what is wrong."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.verdicts import Judgement, Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.problem.model import Answers
from tests.answers.models.slips import feedback_on
from tests.support.shared import loaded, solved

EQUILIBRIA = [
    ("ladder", "P = W*tan(phi)", "the weight of `G` acting at the end of its length"),
    ("ladder", "P = -W/2*tan(phi)", "for gravity that acts the other way"),
    ("ladder", "P = W/2*tan(phi)^3", ""),
]
REACTIONS = [
    ("ex11-ideal-pendulum", "rod", "m*g*cos(theta)", "at rest"),
    ("slide-off-a-dome", "dome", "N = m*g*cos(theta)", "at rest"),
    ("hoop-on-incline", "rolling", "F = -m*g*sin(alpha)/3", "which a disc or solid cylinder has"),
    ("ex11-ideal-pendulum", "rod", "m*g*sin(theta)^3", ""),
]


def judged(name: str, answers: Answers) -> Judgement:
    return Examiner(loaded(name), solved(name)).check_answers(answers)


@pytest.mark.parametrize(("name", "answer", "said"), EQUILIBRIA)
def test_equilibria_of_a_changed_problem(name: str, answer: str, said: str) -> None:
    [verdict] = Examiner(loaded(name), solved(name)).check((Fragment.of(answer),)).each
    assert verdict.verdict is Verdict.WRONG
    assert said in verdict.diagnosis
    assert ("these are the equilibria" in verdict.diagnosis) is bool(said)
    assert said not in verdict.at_hint_level(2).diagnosis or not said


@pytest.mark.parametrize(("name", "constraint", "answer", "said"), REACTIONS)
def test_reactions_of_a_changed_problem(name: str, constraint: str, answer: str, said: str) -> None:
    [other] = judged(name, Answers(reactions={constraint: Fragment.of(answer)})).others
    [verdict] = other.equations
    assert verdict.verdict is Verdict.WRONG
    assert said in verdict.diagnosis
    assert bool(verdict.diagnosis) is bool(said)


@pytest.mark.parametrize(
    ("name", "number", "said"),
    [
        ("ex18-double-pendulum", 4, "not subtracted"),
        ("rolling-disc", 5, "not subtracted"),
        ("ex18-double-pendulum", 7, "determined by 4 coordinates"),
        ("ex18-double-pendulum", 2, ""),
        ("ex18-double-pendulum", 3, "1 constraint too few is subtracted"),
        ("ex18-double-pendulum", 1, "1 constraint too many is subtracted"),
    ],
)
def test_degrees_of_freedom(name: str, number: int, said: str) -> None:
    [other] = judged(name, Answers(degrees_of_freedom=number)).others
    assert said in other.diagnosis
    assert bool(other.diagnosis) is bool(said)


@pytest.mark.parametrize(
    ("stated", "said"),
    [("sqrt(g/a)", "twice the frequencies"), ("g/(4*a)", "squares"), ("sqrt(g/a)/2", ""), ("sqrt(g/a)*7/5", "")],
)
def test_frequencies(stated: str, said: str) -> None:
    [other] = judged("cycloidal-pendulum", Answers(frequencies=((Fragment.of(stated),),))).others
    assert said in other.diagnosis
    assert ("these are" in other.diagnosis) is bool(said)


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        (("sqrt(g/l)", "sqrt(g/l)"), "without the product theta1'*theta2' in the kinetic energy of `Q`"),
        (("sqrt(2*g/l)", "sqrt(g/l)"), "without theta1' in the velocity of `Q`"),
        (("sqrt(g/l)", "sqrt(5*g/(7*l))"), ""),
    ],
)
def test_frequencies_of_a_changed_problem(stated: tuple[str, ...], said: str) -> None:
    answers = Answers(frequencies=(tuple(map(Fragment.of, stated)),))
    [other] = judged("double-pendulum-small-oscillations", answers).others
    assert said in other.diagnosis
    assert ("these are" in other.diagnosis) is bool(said)


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("turning-parabola", "F = m*Omega*rho'", "It is half as large as it should be"),
    ],
)
def test_a_reaction_half_as_large(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
