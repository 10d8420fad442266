"""Kinetic energies, generalized forces, first integrals, virtual displacements; rows in the file beside this one.

Verdicts on stated Hamilton's functions.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Submission
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Source
from lagrange.problem.stated_answers import read_answers
from tests.answers.test_student_answers import grader_of, in_file
from tests.support.paths import PROBLEMS
from tests.support.shared import loaded, reported

ROWS = [row[1:] for row in in_file(Path(__file__).with_name("stated_quantities.txt"))]


@pytest.mark.parametrize(("problem", "verdict", "ending", "text"), ROWS)
def test_verdict(problem: str, verdict: str, ending: str, text: str) -> None:
    graded = grader_of(problem).grade(Submission("a", ((f"a{ending}", text.encode()),)))
    assert graded.verdict.value == verdict, [graded.headline, *graded.messages, *graded.others]


def test_a_remark_says_what_is_wrong() -> None:
    text = b'conserved: ["m*l^2*theta\' = const"]'
    graded = grader_of("ex11-ideal-pendulum").grade(Submission("a", (("a.yaml", text),)))
    [answer] = graded.others
    assert answer.diagnosis == "it is not constant: its rate does not vanish along every motion"


# Hamiltonian


ROUTH, TUBE = "spherical-pendulum-by-routh", "bead-in-a-turning-tube"
CASES = [
    (ROUTH, "H = (p_theta^2 + p_phi^2/sin(theta)^2)/(2*m*l^2) - m*g*l*cos(theta)", Verdict.EQUIVALENT, ""),
    (
        ROUTH,
        "p_theta^2/(2 m l^2) + p_phi^2/(2 m l^2 sin(theta)^2) + m g l (1 - cos(theta))",
        Verdict.EQUIVALENT,
        "constant",
    ),
    (
        ROUTH,
        r"\\frac{p_\\theta^2}{2ml^2} + \\frac{p_\\phi^2}{2ml^2\\sin^2\\theta} - mgl\\cos\\theta",
        Verdict.EQUIVALENT,
        "",
    ),
    (ROUTH, "p_theta^2/(2*m*l^2) + p_phi^2/(2*m*l^2*sin(theta)^2) + m*g*l*cos(theta)", Verdict.WRONG, ""),
    (ROUTH, "m*l^2*theta'^2/2 + m*l^2*phi'^2*sin(theta)^2/2 - m*g*l*cos(theta)", Verdict.WRONG, "velocities"),
    (ROUTH, "p_theta^2/(2*m*l^2", Verdict.UNREADABLE, ""),
    (ROUTH, "p_psi^2/(2*m*l^2)", Verdict.UNREADABLE, "p_psi"),
    (TUBE, "p_r^2/(2*m) + k*(r - a)^2/2 - m*r^2*Omega^2/2 + Omega*t", Verdict.EQUIVALENT, "function of time"),
    (TUBE, "p_r^2/(2*m) + k*(r - a)^2/2 + m*r^2*Omega^2/2", Verdict.WRONG, ""),
    (TUBE, "p_r^2/(m - m)", Verdict.UNREADABLE, "zero"),
]


@pytest.mark.parametrize(("name", "answer", "verdict", "said"), CASES)
def test_the_verdict_on_a_function(name: str, answer: str, verdict: Verdict, said: str) -> None:
    path = PROBLEMS / "motion" / f"{name}.yaml"
    answers = read_answers(Source("answers", f'hamiltonian: "{answer}"\n'), loaded(path))
    judged = Examiner(loaded(path), reported(path).solution).check_answers(answers)
    [other] = judged.others
    assert (other.name, other.verdict) == ("hamiltonian", verdict)
    [part] = other.equations
    assert said in " ".join((part.diagnosis, *part.remarks, *(d.message for d in other.unreadable)))


def test_a_problem_without_the_question_is_not_judged() -> None:
    path = PROBLEMS / "motion" / "bead-on-rotating-hoop.yaml"
    answers = read_answers(Source("answers", "hamiltonian: 0\n"), loaded(path))
    [other] = Examiner(loaded(path), reported(path).solution).check_answers(answers).others
    assert other.verdict is Verdict.UNDECIDED
