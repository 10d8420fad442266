"""Units and dimensions of the terms of an answer."""

from __future__ import annotations

from functools import cache

import pytest

from lagrange.answers.equations import check_equations
from lagrange.answers.examiner import reference
from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Fragment, Source
from lagrange.core.units import unit_of_dimension
from lagrange.problem.loader import read_problem
from lagrange.values.dimensions import dimension_of_unit
from tests.answers.test_diagnosis import SYSTEMS


@cache
def system(key: str) -> Reference:
    coordinates, parameters, equations = SYSTEMS[key]
    text = f"title: T\nparameters: [{parameters}]\ncoordinates: [{coordinates}]\nequations: {equations}\n"
    return reference(read_problem(Source("problem.yaml", text)))


UNITS = "{m: {unit: kg}, l: {unit: m}, g: {unit: m/s^2}}"


@cache
def measured(equations: str = "[\"m*l^2*theta'' + m*g*l*sin(theta) = 0\"]") -> Reference:
    text = f"title: T\nparameters: {UNITS}\ncoordinates: [theta]\nequations: {equations}\n"
    return reference(read_problem(Source("problem.yaml", text)))


@pytest.mark.parametrize(
    ("equation", "words"),
    [
        ("theta'' + g*sin(theta) = 0", "g*sin(theta) is in m/s^2, theta'' in 1/s^2"),
        ("m*l*theta'' + g*sin(theta) = 0", "m*l*theta'' is in kg m/s^2, g*sin(theta) in m/s^2"),
        ("theta'' + g/l*sin(l*theta) = 0", "l*theta is in m"),
    ],
)
def test_dimensions_are_named_first(equation: str, words: str) -> None:
    found = check_equations([Fragment.of(equation)], measured()).equations[0]
    assert words in found.diagnosis
    assert "One change" not in found.diagnosis or found.diagnosis.index(words) < found.diagnosis.index("One change")
    assert "dimension" in found.hints[1]
    assert "m/s" not in found.hints[1]


def test_nothing_is_said_of_dimensions_that_the_file_itself_gets_wrong() -> None:
    wrong = measured("[\"m*l*theta'' + m*g*l*sin(theta) = 0\"]")
    assert (
        "dimension" not in check_equations([Fragment.of("theta'' + g/l*sin(theta) = 0")], wrong).equations[0].diagnosis
    )


def test_nothing_is_said_where_a_unit_is_missing() -> None:
    assert (
        "dimension"
        not in check_equations([Fragment.of("theta'' + g*sin(theta) = 0")], system("pendulum")).equations[0].diagnosis
    )


@pytest.mark.parametrize(
    ("unit", "same"),
    [
        ("N", "kg m/s^2"), ("J", "N m"), ("W", "J/s"), ("N/m", "kg/s^2"), ("N s/m", "kg/s"), ("kg·m²", "kg m^2"),
        ("rad/s", "1/s"), ("Hz", "1/s"), ("m s^-2", "m/s^2"), ("kg*m", "kg m"), ("Pa", "N/m^2"), ("1/(s)", "1/s"),
    ],
)  # fmt: skip
def test_units(unit: str, same: str) -> None:
    assert dimension_of_unit(unit) is not None
    assert dimension_of_unit(unit) == dimension_of_unit(same)


@pytest.mark.parametrize("unit", ["furlong", "m/", "m//s", "kg^x", "m^"])
def test_what_is_no_unit_is_unknown(unit: str) -> None:
    assert dimension_of_unit(unit) is None


def test_units_are_written() -> None:
    assert [unit_of_dimension(dimension_of_unit(u)) for u in ("N", "1", "rad/s", "m/(s)", "N s/m")] == [
        "kg m/s^2",
        "1",
        "1/s",
        "m/s",
        "kg/s",
    ]
