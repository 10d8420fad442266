"""Verdicts on amplitudes of forced oscillations.

A steady state as it is worked out on paper.
"""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.response import without_hats
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.diagnostics import Fragment, Source
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.stated_answers import read_answers
from tests.support.shared import SHIPPED, loaded, reported, solved

DAMPED, ABSORBER = "damped-oscillator", "dynamic-absorber"


def judged(name: str, kind: str, key: str, answer: str) -> AnswerVerdict:
    path = SHIPPED[name]
    answers = read_answers(Source("answers", f'{kind}: {{"{key}": "{answer}"}}\n'), loaded(path))
    [other] = Examiner(loaded(path), reported(path).solution).check_answers(answers).others
    assert other.name == kind
    return other


RESPONSE = [
    (DAMPED, "x", "F/sqrt((c - m*w^2)^2 + b^2*w^2)", Verdict.EQUIVALENT),
    (DAMPED, "x", "-F/sqrt((c - m*w^2)^2 + (b*w)^2)", Verdict.EQUIVALENT),
    (DAMPED, "x", "x = F/c/sqrt((1 - m*w^2/c)^2 + (b*w/c)^2)", Verdict.EQUIVALENT),
    (DAMPED, "x", r"\\frac{F}{\\sqrt{(c - m w^2)^2 + b^2 w^2}}", Verdict.EQUIVALENT),
    (DAMPED, "x", "F/sqrt((c - m*w^2)^2 - b^2*w^2)", Verdict.WRONG),
    (DAMPED, "x", "F/(c - m*w^2)", Verdict.WRONG),
    (DAMPED, "x", "F*cos(w*t)/sqrt((c - m*w^2)^2 + b^2*w^2)", Verdict.WRONG),
    (DAMPED, "y", "F", Verdict.UNREADABLE),
    (DAMPED, "x", "F/(", Verdict.UNREADABLE),
    (ABSORBER, "y", "F*c_2/(c_2^2 - (c_1 + c_2 - m_1*w^2)*(c_2 - m_2*w^2))", Verdict.EQUIVALENT),
    (ABSORBER, "x", "F*c_2/((c_1 + c_2 - m_1*w^2)*(c_2 - m_2*w^2) - c_2^2)", Verdict.WRONG),
    (ABSORBER, "x", "abs(F*(c_2 - m_2*w^2)/((c_1 + c_2 - m_1*w^2)*(c_2 - m_2*w^2) - c_2^2))", Verdict.EQUIVALENT),
]


@pytest.mark.parametrize(("name", "key", "answer", "verdict"), RESPONSE)
def test_the_verdict_on_an_amplitude(name: str, key: str, answer: str, verdict: Verdict) -> None:
    assert judged(name, "response", key, answer).verdict == verdict


# Response in text


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("damped-oscillator", ["X = F/sqrt((c - m*w^2)^2 + b^2*w^2)"], "equivalent"),
        ("damped-oscillator", ["X = F/sqrt((c + m*w^2)^2 + b^2*w^2)"], "wrong"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict


def test_a_hat_is_an_amplitude_here() -> None:
    assert without_hats(Fragment.of(r"\hat{x} = F/c")).text == r"x_{max} = F/c"
    assert without_hats(Fragment.of("x = F/c")).text == "x = F/c"


@pytest.mark.parametrize(
    ("amplitude", "verdict", "why"),
    [
        ("82.66 mm", Verdict.EQUIVALENT, ""),
        ("A = 8.266 cm", Verdict.EQUIVALENT, ""),
        ("0.08266", Verdict.EQUIVALENT, ""),
        ("8.3 mm", Verdict.WRONG, ""),
        ("82.66 kg", Verdict.WRONG, "its unit is not one of what is asked for"),
    ],
)
def test_an_amplitude_with_its_unit_where_a_letter_of_the_unit_is_a_mass(
    amplitude: str, verdict: Verdict, why: str
) -> None:
    problem = read_problem(
        Source(
            "trailer.yaml",
            "title: Trailer\naxes: {j: up}\ncoordinates: [y]\nfind: response\n"
            "parameters: {m: 500 kg, k: 60 kN/m, c: 2 kN s/m, d: 40 mm, w: 12.566370614 rad/s}\n"
            "particles: {trailer: {mass: m, position: y*j}}\n"
            "forces:\n  spring: {potential: k*(y - d*sin(w*t))^2/2}\n"
            '  shock: {on: trailer, vector: "-c*(y\' - d*w*cos(w*t))*j"}\n',
        )
    )
    answers = read_answers(Source("answers", f"response: {{y: {amplitude}}}\n"), problem)
    [verdicts] = Examiner(problem, solve(problem)).check_answers(answers).others
    assert verdicts.verdict is verdict
    assert verdicts.equations[0].diagnosis == why
