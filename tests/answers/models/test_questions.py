"""Wrong answers to questions: what was lost between the energy and the reaction."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.examiner import Examiner
from lagrange.answers.models.questions import explained_value
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.problem.model import Answers
from tests.answers.models.slips import feedback_on
from tests.support.shared import loaded, solved

# worked out by hand: the value that the mistake leads to
QUESTIONS = [
    ("loop-the-loop", "least_height", "2*R", "the velocity is taken as zero there"),
    ("loop-the-loop", "speed_at_the_top", "sqrt(2*g*h)", "the potential energy is missing"),
    ("loop-the-loop", "press_at_the_bottom", "2*m*g*h/R", "what the forces contribute is missing"),
    ("loop-the-loop", "press_at_the_bottom", "m*g", "that of a body at rest"),
    ("loop-the-loop", "press_at_the_bottom", "m*g*(1 + 7*h/R)", ""),
    ("leaving-a-sphere", "leaves", "cos(theta) = 1/2", "is the 1/2 of T missing?"),
    ("leaving-a-sphere", "pressure", "m*g*(2 - cos(theta))", "has the wrong sign"),
    ("ballistic-pendulum", "swing", "cos(theta) = 1 - m^2*v^2/(2*M^2*g*l)", "with M in place of M + m"),
    ("released-pendulum", "tension", "m*g*cos(theta)", "that of a body at rest"),
    ("released-pendulum", "speed", "sqrt(2*g*l)", "that at the start is missing"),
]


@pytest.mark.parametrize(("problem", "question", "answer", "said"), QUESTIONS)
def test_what_was_lost(problem: str, question: str, answer: str, said: str) -> None:
    examiner = Examiner(loaded(problem), solved(problem, complete=False))
    [other] = examiner.check_answers(Answers(ask={question: Fragment.of(answer)})).others
    [verdict] = other.equations
    assert verdict.verdict is Verdict.WRONG
    assert said in verdict.diagnosis
    assert bool(verdict.diagnosis) is bool(said)


def test_differences_of_values() -> None:
    m, g, l, mu = sp.symbols("m g l mu", positive=True)
    right = m * g + mu * m * l
    assert explained_value(m * g, right, set()) == "this is the answer without l, as if l = 0"
    assert explained_value(mu * m * l - m * g, right, set()) == "the sign of the term m*g is wrong"
    assert explained_value(right * l, right, set()) == "there is a factor l too many"
    assert explained_value(-right * l, right, set()) == "its sign is wrong and there is a factor l too many"
    assert explained_value(-m * g * 2 / 3, m * g, set()) == (
        "its sign is wrong, and a number: it has to be 3/2 times as large"
    )
    assert explained_value(right * 35 / 36, right, set()) == ""
    assert explained_value(right + sp.Symbol("q"), right, set()) == "the right answer does not depend on q"


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (
            "rod-falls-on-an-edge",
            "theta' = 3*a*v/l^2",
            "this is the velocity for the moment of inertia about the mass centre",
        ),
        ("bell-and-clapper", "I_2 = m*b*((M*a^2 + I_1)/(M*a) - l - b)", "the term m*l in the denominator is missing"),
        ("bead-on-rotating-hoop", "cos(theta) = g/(Omega^2*R): omega = Omega", "without g, as if g = 0"),
    ],
)
def test_terms_of_denominators(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("hoop-off-a-cylinder", "cos(theta) = (R + a)/(2*R + a)", "taken for its change"),
        ("loop-the-loop", "h = 3*R/2", "wrong sign"),
    ],
)
def test_what_holds_for_any_value_explains_none(problem: str, stated: str, said: str) -> None:
    assert said not in feedback_on(problem, stated)
