"""How much a hint reveals about a wrong equation.

Other conventions of signs and angles, and what they do not explain.
"""

from __future__ import annotations

import json
import re
from functools import cache

import pytest
from click.testing import CliRunner

from lagrange.answers.equations import check_equations
from lagrange.answers.examiner import reference
from lagrange.answers.hints import Turn, other_convention
from lagrange.answers.readings import read_answer
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from lagsolve.main import main
from tests.answers.models.slips import feedback_on
from tests.answers.test_diagnosis import SYSTEMS


def said(*arguments: str) -> str:
    """What is printed, its long lines put together again."""
    shown = CliRunner().invoke(main, ["check", "ex11-ideal-pendulum", *arguments], env={"COLUMNS": "200"}).stdout
    return re.sub(r"\n {6}(?! )", " ", shown)


def test_hints_go_from_the_vague_to_the_frank() -> None:
    one, two, three = (said("-e", "theta'' = 0", "--hint", str(n)) for n in (1, 2, 3))
    assert "force" not in one
    assert "A force term" in two
    assert "sin(" not in two
    assert "g*sin(theta)/l is missing" in three
    assert three == said("-e", "theta'' = 0")


@pytest.mark.parametrize("arguments", [("--hint", "1"), ("--hint", "2"), (), ("--format", "json")])
@pytest.mark.parametrize("equation", ["theta'' = 0", "theta''^2 = 3", "x'' = 0", "theta'' = g*sin(theta)", "1 = 0"])
def test_the_equation_asked_for_is_never_shown_unasked(equation: str, arguments: tuple[str, ...]) -> None:
    shown = said("-e", equation, *arguments)
    assert "l*theta'' + g*sin(theta)" not in shown
    assert "x*y''" not in shown


def test_it_is_shown_when_asked_for() -> None:
    assert "the derived equations:\n  l*theta'' + g*sin(theta) = 0\n" in said("-e", "theta'' = 0", "--reveal")
    assert '"reference": [\n  "l*theta\'\' + g*sin(theta) = 0"\n ]' in said(
        "-e", "theta'' = 0", "--reveal", "--format", "json"
    )


def test_json_names_the_cause_only_where_all_may_be_said() -> None:
    def first(*more: str) -> dict[str, str]:
        found = json.loads(said("-e", "theta'' = 0", "--format", "json", *more))
        equation: dict[str, str] = found["equations"][0]
        return equation

    assert first()["model"] == "gravity left out"
    assert first()["cause"] == "without gravity"
    assert not {"cause", "model"} & first("--hint", "2").keys()
    right = json.loads(said("-e", "l*theta'' + g*sin(theta) = 0", "--format", "json"))
    assert right["equations"][0].keys() == {"text", "verdict", "diagnosis", "remarks"}


@pytest.mark.parametrize(
    ("equation", "sentences"),
    [
        (
            "theta'' = g/l*sin(theta)",
            "This is the equation for gravity that acts the other way, or for theta measured from the opposite "
            "direction. One change makes it right: the sign of the term g*sin(theta)/l.",
        ),
        (
            "theta'' = 0",
            "This is the equation without gravity. One change makes it right: g*sin(theta)/l is missing on its left "
            "side.",
        ),
    ],
)
def test_at_most_the_cause_and_the_place_are_said(equation: str, sentences: str) -> None:
    assert said("-e", equation).endswith(f" {sentences}\n")


# Conventions


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
            "theta",  # as well as x: a reader takes an angle the other way sooner than a distance
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


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (
            "spring-pendulum",
            "diff(m*r^2*phi', t) = m*r^2*phi'' + m*r*r'*phi'",
            "m*r*r'*phi' is left: is the derivative carried out rightly?",
        ),
        (
            "ex17-spherical-pendulum",
            "r*theta'' + 2*r'*theta' - r*phi'^2*sin(theta)*cos(theta) + g*sin(theta) = 0",
            "gravity that acts the other way, or for theta measured from the opposite direction",
        ),
        (
            "two-body-problem",
            "u'' = -G*m1*u/(u^2 + v^2)^(3/2)",
            "m2*G*u/(u^2 + v^2)^(3/2) is missing on its left side",
        ),
        (
            "door-closer",
            "J*theta'' + b*theta' + c*a*h*sin(theta)*(1 - l/d) = 0",
            "J*theta'' in kg m^2/s^2. This is the equation for the damper `oil` with b*theta' as its moment",
        ),
    ],
)
def test_what_is_said(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
