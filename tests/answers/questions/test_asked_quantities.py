"""Verdicts on answers to questions."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Source
from lagrange.problem.stated_answers import read_answers
from tests.support.paths import PROBLEMS
from tests.support.shared import loaded, reported

CASES = [
    ("leaving-a-sphere", "leaves", "acos(2/3)", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "leaves", "theta = acos(2/3)", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "leaves", "leaves = acos(2/3)", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "leaves", "3*cos(theta) = 2", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "leaves", "cos(theta) = 1/2", Verdict.WRONG),
    ("leaving-a-sphere", "leaves", "cos(theta)^2 = 4/9", Verdict.INCOMPLETE),
    ("leaving-a-sphere", "leaves", "g = g", Verdict.TRIVIAL),
    ("leaving-a-sphere", "leaves", "R*theta'^2 = 2/3*g", Verdict.WRONG),
    ("leaving-a-sphere", "leaves", "cos(theta = 2/3", Verdict.UNREADABLE),
    ("leaving-a-sphere", "speed", "-sqrt(2*g*R/3)", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "speed", "sqrt(g*R)", Verdict.WRONG),
    ("leaving-a-sphere", "pressure", "N = m*g*(2 - 3*cos(theta))", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "pressure", "m*g*(3*cos(theta) - 1)", Verdict.WRONG),
    ("released-pendulum", "speed", "sqrt(2*g*l*(1 - cos(alpha)))", Verdict.EQUIVALENT),
    ("released-pendulum", "speed", "\\sqrt{2gl(1 - \\cos\\alpha)}", Verdict.EQUIVALENT),
    ("released-pendulum", "speed", "sqrt(g*l*(1 - cos(alpha)))", Verdict.WRONG),
    ("released-pendulum", "other_side", "alpha", Verdict.WRONG),
    ("loop-the-loop", "least_height", "h = 2*R", Verdict.WRONG),
    ("loop-the-loop", "least_height", "2*h = 5*R", Verdict.EQUIVALENT),
    ("shaken-into-resonance", "motion", "F*t/(2*m*w)*sin(w*t)", Verdict.INCOMPLETE),
]


@pytest.mark.parametrize(("name", "question", "answer", "verdict"), CASES)
def test_the_verdict_on_an_answer_to_a_question(name: str, question: str, answer: str, verdict: Verdict) -> None:
    path = PROBLEMS / "motion" / f"{name}.yaml"
    examiner = Examiner(loaded(path), reported(path).solution)
    stated = read_answers(Source("answers", f"ask: {{{question}: '{answer}'}}" if "'" not in answer else
                                 f'ask: {{{question}: "{answer}"}}'), loaded(path))  # fmt: skip
    [judged] = examiner.check_answers(stated).others
    assert (judged.name, judged.verdict) == ("ask", verdict)


@pytest.mark.parametrize(
    ("name", "question", "answer", "said"),
    [
        ("weight-let-go-on-a-spring", "lowest", "x_max = m*g/k", "it is half as large as it should be"),
        ("weight-let-go-on-a-spring", "time", "2*pi*sqrt(m/k)", "it is twice as large as it should be"),
        ("over-the-top", "at_the_side", "sqrt(v^2 + 2*g*l)", "this is the answer for g with the opposite sign"),
        ("over-the-top", "at_the_side", "sqrt(v^2 - g*l)", "this is the answer for g half as large"),
        ("escape-from-a-planet", "escape_speed", "sqrt(K/R)", "a factor sqrt(2) is missing"),
        ("escape-from-a-planet", "escape_speed", "K*R", ""),
    ],
)
def test_what_is_said_of_a_wrong_value(name: str, question: str, answer: str, said: str) -> None:
    path = PROBLEMS / "motion" / f"{name}.yaml"
    stated = read_answers(Source("answers", f"ask: {{{question}: '{answer}'}}"), loaded(path))
    [judged] = Examiner(loaded(path), reported(path).solution).check_answers(stated).others
    [part] = judged.equations
    assert (part.verdict, part.diagnosis) == (Verdict.WRONG, said)
