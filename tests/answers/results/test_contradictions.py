"""Contradictions between two equations of an answer about equilibrium."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved


def verdicts(problem: str, *equations: str) -> list[str]:
    judged = Examiner(loaded(problem), solved(problem)).check(tuple(map(Fragment.of, equations)))
    return [judged.verdict.value, *(e.verdict.value for e in judged.each)]


@pytest.mark.parametrize(
    ("problem", "right", "wrong"),
    [
        ("ladder", "P = W/2*tan(phi)", "P = W/2*cot(phi)"),
        ("inverted-pendulum-springs", "W*l*sin(theta) = c*b^2*sin(theta)*cos(theta)", "cos(theta) = c*b^2/(W*l)"),
    ],
)
def test_an_equation_that_is_true_at_no_equilibrium_is_wrong(problem: str, right: str, wrong: str) -> None:
    assert verdicts(problem, right, wrong) == ["wrong", "equivalent", "wrong"]


def test_one_of_many_positions_is_no_contradiction() -> None:
    whole, *each = verdicts("triatomic-molecule", "x2 = x1 + b", "x3 = x2 + b")
    assert (whole, "wrong" in each) == ("equivalent", False)


@pytest.mark.parametrize(
    ("equation", "verdict"),
    [
        ("c*b^2*sin(theta) = W*l*sin(theta)", "wrong"),
        ("2*W*l*sin(theta) = c*b^2*sin(theta)", "wrong"),
        ("(b + l)*sin(theta) = 0", "incomplete"),
        ("sin(theta) = 0", "incomplete"),
        ("(c*b^2*cos(theta) - W*l)*sin(theta) = 0", "equivalent"),
    ],
)
def test_a_factor_of_parameters_alone_is_no_condition_of_equilibrium(equation: str, verdict: str) -> None:
    """c b² = W l would let it rest at every inclination, and it does not."""
    assert verdicts("inverted-pendulum-springs", equation)[0] == verdict
