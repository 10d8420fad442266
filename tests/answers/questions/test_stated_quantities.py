"""Kinetic energies, generalized forces, first integrals, virtual displacements; rows in the file beside this one."""

from __future__ import annotations

from pathlib import Path

import pytest

from lagrange.answers.submissions import Submission
from tests.answers.test_student_answers import grader_of, in_file

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
