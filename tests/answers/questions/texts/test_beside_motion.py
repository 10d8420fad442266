"""Results beside complete equations of motion: right ones are confirmed, wrong ones make the answer wrong."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Graded, Grader, Submission
from tests.support.shared import loaded, solved

SPHERE = "theta'' = g/R*sin(theta)\n"


def graded(problem: str, text: str) -> Graded:
    grader = Grader.of(Examiner(loaded(problem), solved(problem)))
    return grader.grade(Submission("a", (("answer.txt", text.encode()),)))


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("It leaves where cos(theta) = 2/3", "equivalent"),
        ("It leaves where cos(theta) = 1/2", "wrong"),
        ("speed: sqrt(2*g*R/3)", "equivalent"),
        ("speed: sqrt(g*R/3)", "wrong"),
        ("v = sqrt(g*R/3)", "wrong"),
        ("At theta = 0 the particle is at rest", "equivalent"),
        ("k = g/R, which is a constant", "equivalent"),
    ],
)
def test_values_that_are_asked_for(line: str, verdict: str) -> None:
    assert graded("leaving-a-sphere", SPHERE + line + "\n").verdict.value == verdict


@pytest.mark.parametrize(
    ("condition", "verdict"),
    [
        (", rolls if mu_s >= tan(alpha)/3", "equivalent"),
        (", rolls if mu_s >= tan(alpha)/2", "wrong"),
        ("\nIt does not slip as long as mu_s >= tan(alpha)/2", "wrong"),
        ("\nmu_s >= tan(alpha)/2", "wrong"),
        ("\nfor m > 0", "equivalent"),
    ],
)
def test_a_limit_of_what_is_asked_for_may_be_an_inequality(condition: str, verdict: str) -> None:
    assert graded("rolling-without-slip", f"x'' = 2/3*g*sin(alpha){condition}\n").verdict.value == verdict


def test_the_question_that_a_line_answers_is_named() -> None:
    outcome = graded("leaving-a-sphere", SPHERE + "cos(theta) = 2/3\n")
    assert [e.remarks for a in outcome.others for e in a.equations] == [("it is taken as the answer to `leaves`",)]


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("Equilibrium: cos(theta) = g/(Omega^2*R)", "equivalent"),
        ("Equilibrium: cos(theta) = g/(Omega*R)", "wrong"),
        ("frequencies: sqrt(g/R - Omega^2)", "equivalent"),
        ("frequencies: sqrt(g/R + Omega^2)", "wrong"),
        ("T = 1/2*m*R^2*(theta'^2 + Omega^2*sin(theta)^2)", "equivalent"),
        ("theta = 0 stable if Omega < sqrt(g/R), theta = pi is unstable", "equivalent"),
        ("theta = 0 stable if Omega > sqrt(g/R)", "wrong"),
        ("theta = pi is stable", "wrong"),
    ],
)
def test_equilibria_and_frequencies(line: str, verdict: str) -> None:
    motion = "theta'' = (Omega^2*cos(theta) - g/R)*sin(theta)\n"
    assert graded("bead-on-rotating-hoop", motion + line + "\n").verdict.value == verdict


@pytest.mark.parametrize(("power", "verdict"), [("^2", "equivalent"), ("", "wrong")])
def test_steady_motions(power: str, verdict: str) -> None:
    motion = "r'' = r*phi'^2*sin(alpha)^2 - g*cos(alpha)\nr*phi'' + 2*r'*phi' = 0\n"
    steady = f"steady motion: r_0 = g*cos(alpha)/(phi'{power}*sin(alpha)^2)\n"
    assert graded("marble-in-a-cone", motion + steady).verdict.value == verdict


@pytest.mark.parametrize(
    ("root", "verdict"), [("sqrt((c - m*w^2)^2 + b^2*w^2)", "equivalent"), ("(c - m*w^2)", "wrong")]
)
def test_amplitudes(root: str, verdict: str) -> None:
    text = f"m*x'' + b*x' + c*x = F*cos(w*t)\nA = F/{root}\n"
    assert graded("damped-oscillator", text).verdict.value == verdict


def test_a_name_that_the_equation_contains_is_a_definition() -> None:
    text = "theta'' = -w_0^2*sin(theta), w_0 = sqrt(g/l)\nlowest_tension = m*g*(3 - 2*cos(alpha))\n"
    assert graded("released-pendulum", text).verdict.value == "equivalent"
