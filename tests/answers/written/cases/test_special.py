"""What is said of special cases beside the equations."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Grader, Submission
from lagrange.core.diagnostics import Source
from lagrange.problem.loader import read_problem

ATWOOD = """
title: Atwood
coordinates: [a]
parameters: [m, M, g, l]
unknowns: [T]
equations: ["m*a'' = m*g - T", "M*a'' = T - M*g"]
"""
EQUATIONS = "m a'' = m g - T\nM a'' = T - M g\n"


@pytest.mark.parametrize(
    ("beside", "expected"),
    [
        ("so, if M = 3m, then a'' = -g/2", "equivalent"),
        ("a'' = -g/2 if M = 3m", "equivalent"),
        ("For M = 3m we find a'' = -g/2", "equivalent"),
        ("in the special case M = m we have a'' = 0 and T = m g", "equivalent"),
        ("a'' = -g/2", "wrong"),
    ],
)
def test_special_cases_are_not_judged(beside: str, expected: str) -> None:
    grader = Grader.of(Examiner.of(read_problem(Source("atwood", ATWOOD))))
    graded = grader.grade(Submission("x", (("answer.txt", f"{EQUATIONS}{beside}\n".encode()),)))
    assert graded.verdict.value == expected, graded.equations


def test_a_constraint_is_no_special_case() -> None:
    text = "title: p\ncoordinates: [theta]\nparameters: [g, l]\nequations: [\"l*theta'' + g*sin(theta) = 0\"]\n"
    grader = Grader.of(Examiner.of(read_problem(Source("p", text))))
    wrong = "l theta'' + g sin(theta) = 0\nfor theta = theta: l theta'' = 0\n"
    assert grader.grade(Submission("x", (("a.txt", wrong.encode()),))).verdict.value == "wrong"
