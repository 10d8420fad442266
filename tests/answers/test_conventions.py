"""Other conventions of signs and angles, and what they do not explain."""

from __future__ import annotations

from functools import cache

import pytest

from lagrange.answers.conventions import Turn, other_convention
from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.examiner import reference
from lagrange.answers.readings import read_answer
from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from tests.answers.test_diagnosis import SYSTEMS


@cache
def system(key: str) -> Reference:
    coordinates, parameters, equations = SYSTEMS[key]
    text = f"title: T\nparameters: [{parameters}]\ncoordinates: [{coordinates}]\nequations: {equations}\n"
    return reference(read_problem(Source("problem.yaml", text)))


@pytest.mark.parametrize(
    ("key", "equations", "coordinate", "turn"),
    [
        ("pendulum", ["l*theta'' = g*sin(theta)"], "theta", Turn.OPPOSITE),
        ("pendulum", ["l*theta'' + g*cos(theta) = 0"], "theta", Turn.RIGHT_ANGLE),
        ("pendulum", ["l*theta'' = g*cos(theta)"], "theta", Turn.RIGHT_ANGLE),
        ("atwoodI", ["(m1+m2+I/R^2)*x'' = (m2-m1)*g"], "x", Turn.REVERSED),
        (
            "cart",
            [
                "(M+m)*x'' - m*l*theta''*cos(theta) + m*l*theta'^2*sin(theta)=0",
                "l*theta'' - x''*cos(theta) + g*sin(theta) = 0",
            ],
            "x",
            Turn.REVERSED,
        ),
    ],
)
def test_other_conventions(key: str, equations: list[str], coordinate: str, turn: Turn) -> None:
    found = check_equations([Fragment.of(e) for e in equations], system(key))
    assert found.verdict is Verdict.WRONG
    assert f"It would be right if {coordinate} were measured {turn.value}" in found.equations[0].diagnosis
    [candidate] = system(key).candidates
    read = [candidate.read(read_answer(Fragment.of(e), system(key).scope).components[0]) for e in equations]
    convention = other_convention(read, candidate.residues)
    assert convention is not None
    assert convention.turn is turn


def test_no_convention_makes_up_for_a_slip() -> None:
    found = check_equations([Fragment.of("l*theta'' = 2*g*sin(theta)")], system("pendulum"))
    assert "measured" not in found.equations[0].diagnosis


UNITS = "{m: {unit: kg}, l: {unit: m}, g: {unit: m/s^2}}"


@cache
def measured(equations: str = "[\"m*l^2*theta'' + m*g*l*sin(theta) = 0\"]") -> Reference:
    text = f"title: T\nparameters: {UNITS}\ncoordinates: [theta]\nequations: {equations}\n"
    return reference(read_problem(Source("problem.yaml", text)))
