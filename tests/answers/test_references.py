"""What answers are compared with: the equations derived are an equivalent answer, whatever is given for parameters."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import check_answer
from lagrange.core.diagnostics import Fragment, Source
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from tests.answers.test_equations import EQUIVALENT, SOLVED, UNREADABLE, WRONG, fragments

VALUES = SOLVED["pendulum"].replace(
    "parameters: [m, l, g]", "parameters: {m: {value: 2}, l: {value: 0.5}, g: {assume: positive}}"
)


THIRD = SOLVED["pendulum"].replace("parameters: [m, l, g]", "parameters: {m: {value: 2}, l: {value: 3}, g: {value: 1}}")


@pytest.mark.parametrize(
    ("text", "answer", "expected"),
    [
        (VALUES, "theta'' + g/l*sin(theta) = 0", EQUIVALENT),
        (VALUES, "theta'' + 2*g*sin(theta) = 0", EQUIVALENT),
        (VALUES, "0.5*theta'' + g*sin(theta) = 0", EQUIVALENT),
        (VALUES, "m*theta'' + 4*g*sin(theta) = 0", EQUIVALENT),
        (VALUES, "theta'' + 0.5*g*sin(theta) = 0", WRONG),
        (VALUES, "x*(y'' - g) - y*x'' = 0 ; x^2 + y^2 = 0.25", EQUIVALENT),
        (VALUES, "y''/4 + y*y'^2/(1 - 4*y^2) = g*(1/4 - y^2)", EQUIVALENT),
        (THIRD, "theta'' + sin(theta)/3 = 0", EQUIVALENT),
        (THIRD, "theta'' + 0.33*sin(theta) = 0", EQUIVALENT),
        (THIRD, "theta'' + 0.34*sin(theta) = 0", WRONG),
        (THIRD, "theta''/(l - 3) = 0", UNREADABLE),
    ],
)
def test_values_of_parameters(text: str, answer: str, expected: str) -> None:
    assert check_answer(read_problem(Source("values", text)), fragments(answer)).verdict.value == expected


@pytest.mark.parametrize("system", SOLVED)
def test_the_equations_derived_are_an_equivalent_answer(system: str) -> None:
    problem = read_problem(Source(system, SOLVED[system]))
    found = report(problem).solution
    motions = [found.own.motion, *(c.motion for c in found.choices)]
    for motion in motions:
        lines = [str(e).replace("**", "^") + " = 0" for e in motion.expressions]
        checked = check_answer(problem, tuple(Fragment.of(e) for e in lines))
        assert checked.verdict.value == EQUIVALENT, lines
