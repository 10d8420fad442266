"""Verdicts on velocities after an impact.

An impact as it is worked out on paper.
"""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.impact import with_losses
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment, Source
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.stated_answers import read_answers
from tests.answers.questions.test_response import DAMPED, judged
from tests.support.shared import loaded, solved

EDGE, WEDGE, HINGE = "rod-falls-on-an-edge", "ball-on-a-wedge", "centre-of-percussion"


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


@pytest.mark.parametrize(("kind", "name"), [("impact", DAMPED), ("response", EDGE)])
def test_a_problem_without_the_question_is_not_judged(kind: str, name: str) -> None:
    assert judged(name, kind, "x", "0").verdict is Verdict.UNDECIDED


# Impact in text


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("disc-against-a-step", ["theta' = omega*(1 - 2*h/(3*R))"], "equivalent"),
        ("disc-against-a-step", ["theta' = omega*(1 - h/R)"], "wrong"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict


def test_lines_that_state_the_energy_lost() -> None:
    lines = ["E_lost = m*v^2/4", "x' = v/2"]
    assert [lost for _, lost in with_losses([Fragment.of(t) for t in lines])] == [True, False]


@pytest.mark.parametrize(
    ("key", "stated", "verdict"),
    [
        ("x'", "1.5 m/s", Verdict.EQUIVALENT),
        ("x'", "150 cm/s", Verdict.EQUIVALENT),
        ("x'", "x' = 1.5", Verdict.EQUIVALENT),
        ("x'", "1.5 m", Verdict.WRONG),
        ("x'", "2.5 m/s", Verdict.WRONG),
        ("P", "4.5 N s", Verdict.EQUIVALENT),
        ("energy_lost", "6.75 J", Verdict.EQUIVALENT),
    ],
)
def test_results_with_units_where_letters_of_units_are_masses(key: str, stated: str, verdict: Verdict) -> None:
    """3 m/s shared by two equal masses of 3 kg, of which the second is called s."""
    problem = read_problem(
        Source(
            "cars.yaml",
            "title: Cars\ncoordinates: [x, y]\nparameters: {m: 3 kg, s: 3 kg, v: 3 m/s}\nfind: impact\n"
            "particles: {A: {mass: m, position: x*i}, B: {mass: s, position: y*i}}\n"
            "impact:\n  before: {x: 0, x': v, y: 0, y': 0}\n  constraints: {lock: {equation: y >= x, reaction: P}}\n",
        )
    )
    answers = read_answers(Source("answers", f'impact: {{"{key}": "{stated}"}}\n'), problem)
    [verdicts] = Examiner(problem, solve(problem)).check_answers(answers).others
    assert verdicts.verdict is verdict
