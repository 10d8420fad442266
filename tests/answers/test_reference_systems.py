"""Systems given outright under `equations`: answers to them, and what is refused as a system."""

from __future__ import annotations

import pytest

from lagrange.answers.equations import AnswerVerdict, check_equations
from lagrange.answers.examiner import check_answers, reference
from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Answers, Problem
from lagsolve.exit_statuses import status_of_verdict

EQUIVALENT, WRONG, INCOMPLETE, UNREADABLE = "equivalent", "wrong", "incomplete", "unreadable"

PENDULUM = """
title: A pendulum in x and y
parameters: [m, l, g]
coordinates: [x, y]
constraints: {rod: x^2 + y^2 = l^2}
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}
  depth: {coordinates: [y]}
"""
WITH = PENDULUM + "equations: [\"m*x'' = 2*x*lambda_rod\", \"m*y'' = m*g + 2*y*lambda_rod\"]\n"
WITHOUT = PENDULUM + "equations: [\"x*(y'' - g) - y*x'' = 0\"]\n"
ATWOOD = """
title: Atwood
parameters: [m1, m2, g]
unknowns: [T]
coordinates: [x]
equations: ["m1*g - T = m1*x''", "T - m2*g = m2*x''"]
"""
SKATE = """
title: A skate
parameters: [m, I]
coordinates: [x, y, theta]
constraints: {blade: "x'*sin(theta) = y'*cos(theta)"}
equations: ["x''*cos(theta) + y''*sin(theta) = 0", "I*theta'' = 0"]
"""
NUMBERS = """
title: With numbers
parameters: {m: {value: 2}, l: {value: 0.5}, g: positive}
coordinates: [theta]
equations: ["m*l^2*theta'' + m*g*l*sin(theta) = 0"]
"""
DRIVEN = """
title: A driven oscillator
parameters: [m, k, c]
functions: {u: [t], F: [x, x', t]}
coordinates: [x]
equations: ["m*x'' + c*(x' - u') + k*(x - u) = F"]
"""

ANSWERS = [
    (WITH, "m*x'' = 2*x*lambda_rod ; m*y'' = m*g + 2*y*lambda_rod", EQUIVALENT),
    (WITH, "x*(y'' - g) - y*x'' = 0", EQUIVALENT),
    (WITH, "theta'' = -g/l*sin(theta)", EQUIVALENT),
    (WITH, "m*x'' = 2*x*lambda_rod", INCOMPLETE),
    (WITH, "m*x'' = -2*x*lambda_rod ; m*y'' = m*g - 2*y*lambda_rod", WRONG),
    (WITH, "l*theta'' + g*sin(theta) = 0 ; 2*l*lambda_rod = -m*g*cos(theta) - m*l*theta'^2", EQUIVALENT),
    (WITH, "l*theta'' + g*sin(theta) = 0 ; 2*l*lambda_rod = m*g*cos(theta) + m*l*theta'^2", WRONG),
    (WITHOUT, "x*(y'' - g) - y*x'' = 0 ; x*x' + y*y' = 0", EQUIVALENT),
    (WITHOUT, "m*x'' = 2*x*lambda_rod ; m*y'' = m*g + 2*y*lambda_rod", EQUIVALENT),
    (WITHOUT, "m*x'' = 2*x*lambda_rod ; m*y'' = -m*g + 2*y*lambda_rod", WRONG),
    (WITHOUT, "theta'' = -g/l*sin(theta)", EQUIVALENT),
    (WITHOUT, "theta'' = g/l*sin(theta)", WRONG),
    (WITHOUT, "theta'' = -g*x/l^2", EQUIVALENT),
    (WITHOUT, "l^2*y'' = g*(l^2 - y^2) - l^2*y*y'^2/(l^2 - y^2)", EQUIVALENT),
    (WITHOUT, "x = l*sin(theta)", INCOMPLETE),
    (WITHOUT, "x = l*cos(theta)", WRONG),
    (ATWOOD, "m1*g - T = m1*x'' ; T - m2*g = m2*x''", EQUIVALENT),
    (ATWOOD, "(m1 + m2)*x'' = (m1 - m2)*g", EQUIVALENT),
    (ATWOOD, "(m1 + m2)*x'' = (m1 - m2)*g ; T = 2*m1*m2*g/(m1 + m2)", EQUIVALENT),
    (ATWOOD, "T = 2*m1*m2*g/(m1 + m2)", INCOMPLETE),
    (ATWOOD, "T = m1*m2*g/(m1 + m2)", WRONG),
    (SKATE, "x'' = -theta'*y' ; theta'' = 0", EQUIVALENT),
    (SKATE, "x'' = 0 ; theta'' = 0", WRONG),
    (SKATE, "theta'' = 0 ; y'*cos(theta) = x'*sin(theta)", INCOMPLETE),
    (SKATE, "m*x'' = lambda_blade*sin(theta) ; m*y'' = -lambda_blade*cos(theta) ; theta'' = 0", EQUIVALENT),
    (NUMBERS, "theta'' + 2*g*sin(theta) = 0", EQUIVALENT),
    (NUMBERS, "theta'' + g/l*sin(theta) = 0", EQUIVALENT),
    (NUMBERS, "theta'' + g/0.5*sin(theta) = 0", EQUIVALENT),
    (NUMBERS, "theta'' + 0.5*g*sin(theta) = 0", WRONG),
    (NUMBERS, "theta'' + 1.9999999999*g*sin(theta) = 0", WRONG),
    (DRIVEN, "x'' = F/m + c/m*(u' - x') + k/m*(u - x)", EQUIVALENT),
    (DRIVEN, "x'' = F/m + c/m*(u' - x') + k/m*u", WRONG),
    (DRIVEN, "m*x'' + c*x' + k*x = F + diff(c*u, t) + k*u", EQUIVALENT),
    (DRIVEN, "u'*(m*x'' + c*(x' - u') + k*(x - u) - F) = 0", EQUIVALENT),
    (DRIVEN, "z'' = 0", UNREADABLE),
]  # fmt: skip


def problem(text: str) -> Problem:
    return read_problem(Source("r.yaml", text))


def verdict_on(text: str, answer: str) -> AnswerVerdict:
    return check_equations([Fragment.of(e.strip()) for e in answer.split(";")], reference(problem(text)))


@pytest.mark.parametrize(("text", "answer", "expected"), ANSWERS)
def test_answers_to_a_system_given_outright(text: str, answer: str, expected: str) -> None:
    assert verdict_on(text, answer).verdict.value == expected


def test_the_choice_that_an_answer_is_compared_in() -> None:
    assert verdict_on(WITHOUT, "theta'' = -g/l*sin(theta)").choice == "angle"
    assert verdict_on(WITHOUT, "x*(y'' - g) - y*x'' = 0").choice == ""


@pytest.mark.parametrize(
    ("equations", "code", "place"),
    [
        ("[\"x''^2 = 1\"]", "reference-not-linear", "x''^2 = 1"),
        ('["x\'\' = y", "y\' = x", "y\'\' = 1"]', "reference-not-linear", "y' = x"),
        ('["0 = 0"]', "reference-not-linear", "0 = 0"),
        ("[\"x'' = 1\", \"x'' = 2\"]", "reference-contradictory", "x'' = 1"),
        ("[\"x'' = 1\", \"x'' + 0*y'' = 1 + x\"]", "reference-contradictory", "x'' = 1"),
        ("[\"x''/(sin(x)^2 + cos(x)^2 - 1) = 0\"]", "division-by-zero", "x''/"),
        ("[\"theta'' = 0\"]", "reference-coordinates", "theta'' = 0"),
    ],
)
def test_what_is_no_system_is_refused(equations: str, code: str, place: str) -> None:
    """It would make every answer right, or none."""
    choice = "generalized_coordinates: {a: {coordinates: [theta, y], substitute: {x: 2*theta}}}\n"
    text = f"title: r\ncoordinates: [x, y]\n{choice}equations: {equations}\n"
    with pytest.raises(ProblemError) as caught:
        reference(problem(text))
    found = caught.value.diagnostics[0]
    assert found.code == code
    assert found.span is not None
    assert found.span.source.text[found.span.start : found.span.end].strip('"').startswith(place)


def test_a_system_that_contradicts_its_constraints() -> None:
    text = "title: r\ncoordinates: [x, y]\nconstraints: {c: x = y}\nequations: [\"x'' = 1\", \"y'' = 2\"]\n"
    with pytest.raises(ProblemError, match="contradict"):
        reference(problem(text))


def test_other_answers_cannot_be_compared_with_equations() -> None:
    answers = Answers(degrees_of_freedom=1, equations=(Fragment.of("theta'' + 2*g*sin(theta) = 0"),))
    found = check_answers(problem(NUMBERS), answers)
    assert [(a.name, a.verdict.value) for a in found.others] == [("degrees_of_freedom", "undecided")]
    assert found.equations.verdict.value == EQUIVALENT
    assert status_of_verdict(found.verdict) == 3
