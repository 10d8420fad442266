"""Verdicts on stated velocities, impulses and losses of an impact, and on amplitudes."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.diagnostics import Source
from lagrange.problem.stated_answers import read_answers
from tests.support.shared import SHIPPED, loaded, reported

EDGE, WEDGE, HINGE = "rod-falls-on-an-edge", "ball-on-a-wedge", "centre-of-percussion"
DAMPED, ABSORBER = "damped-oscillator", "dynamic-absorber"


def judged(name: str, kind: str, key: str, answer: str) -> AnswerVerdict:
    path = SHIPPED[name]
    answers = read_answers(Source("answers", f'{kind}: {{"{key}": "{answer}"}}\n'), loaded(path))
    [other] = Examiner(loaded(path), reported(path).solution).check_answers(answers).others
    assert other.name == kind
    return other


IMPACT = [
    (EDGE, "theta'", "3*a*v/(l^2 + 3*a^2)", Verdict.EQUIVALENT, ""),
    (EDGE, "theta", "3*a*v/(l^2 + 3*a^2)", Verdict.EQUIVALENT, ""),
    (EDGE, "theta'", "theta' = 3*a*v/(l^2 + 3*a^2)", Verdict.EQUIVALENT, ""),
    (EDGE, "theta'", "(l^2 + 3*a^2)*theta' = 3*a*v", Verdict.EQUIVALENT, ""),
    (EDGE, "theta'", r"\\frac{3av}{l^2+3a^2}", Verdict.EQUIVALENT, ""),
    (EDGE, "theta'", "-y'/a", Verdict.EQUIVALENT, ""),
    (EDGE, "theta'", "-3*a*v/(l^2 + 3*a^2)", Verdict.WRONG, ""),
    (EDGE, "theta'", "3*a*v/(l^2 + a^2)", Verdict.WRONG, ""),
    (EDGE, "y'", "-v", Verdict.WRONG, ""),
    (EDGE, "N", "m*l^2*v/(l^2 + 3*a^2)", Verdict.EQUIVALENT, ""),
    (EDGE, "edge", "-m*l^2*v/(l^2 + 3*a^2)", Verdict.EQUIVALENT, "opposite"),
    (EDGE, "N", "m*v", Verdict.WRONG, ""),
    (EDGE, "energy_lost", "m*v^2*l^2/(2*l^2 + 6*a^2)", Verdict.EQUIVALENT, ""),
    (EDGE, "energy_lost", "m*v^2/2", Verdict.WRONG, ""),
    (EDGE, "phi'", "0", Verdict.UNREADABLE, "neither"),
    (EDGE, "y'", "v/(a - a)", Verdict.UNREADABLE, ""),
    (EDGE, "y'", "v/(", Verdict.UNREADABLE, ""),
    (WEDGE, "X'", "-m*v*(1 + e)*sin(2*alpha)/(2*(M + m*sin(alpha)^2))", Verdict.EQUIVALENT, ""),
    (WEDGE, "X'", "-m*v*(1 - e)*sin(2*alpha)/(2*(M + m*sin(alpha)^2))", Verdict.WRONG, ""),
    (WEDGE, "energy_lost", "(1 - e^2)*v^2*cos(alpha)^2/2*m*M/(M + m*sin(alpha)^2)", Verdict.EQUIVALENT, ""),
    (HINGE, "hinge.1", "J*(3*a - 2*l)/(2*l)", Verdict.EQUIVALENT, ""),
    (HINGE, "x'", "J/m", Verdict.WRONG, ""),
]


@pytest.mark.parametrize(("name", "key", "answer", "verdict", "said"), IMPACT)
def test_the_verdict_on_an_impact(name: str, key: str, answer: str, verdict: Verdict, said: str) -> None:
    other = judged(name, "impact", key, answer)
    assert other.verdict == verdict
    [part] = other.equations
    assert said in " ".join((part.diagnosis, *part.remarks, *(d.message for d in other.unreadable)))


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


@pytest.mark.parametrize(("kind", "name"), [("impact", DAMPED), ("response", EDGE)])
def test_a_problem_without_the_question_is_not_judged(kind: str, name: str) -> None:
    assert judged(name, kind, "x", "0").verdict is Verdict.UNDECIDED
