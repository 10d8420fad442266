"""Units and dimensions of the terms of an answer.

Dimensions that follow because equations are homogeneous.
"""

from __future__ import annotations

from functools import cache

import pytest
import sympy as sp

from lagrange.answers.equations import check_equations
from lagrange.answers.examiner import reference
from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Fragment, Source
from lagrange.core.symbols import Unspecified, prime, t
from lagrange.core.units import unit_called, unit_of, unit_of_dimension
from lagrange.problem.loader import read_problem
from lagrange.values.dimensions import Homogeneity, dimension_of_unit, dimensions_needed
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


# Homogeneity


m, g, x, y, phi, k, c = sp.symbols("m g x y phi k c", real=True)


def known(**units: str) -> Homogeneity:
    read = {name: unit_of(unit) for name, unit in units.items()}
    return Homogeneity({sp.Symbol(n, real=True): u.dimension for n, u in read.items() if u is not None})


def called(found: Homogeneity, e: sp.Expr) -> str | None:
    dimension = found.dimension(e)
    return None if dimension is None else unit_called(dimension) or "1"


def test_terms_of_a_sum_have_one_dimension() -> None:
    found = known(m="kg", x="m")
    assert found.dimension(k) is None
    found.exponents(m * prime(x, 2) + k * x + c * prime(x) + m * g)
    assert [called(found, e) for e in (k, c, g, k * x**2)] == ["N/m", "N s/m", "m/s^2", "N m"]


def test_what_is_learned_later_completes_what_was_read_before() -> None:
    found = known(x="m")
    found.equal(k * y, x)
    assert found.dimension(y) is None
    found.equal(k, sp.sqrt(x))
    assert found.dimension(y) == (0, sp.Rational(1, 2), 0, 0, 0)


def test_arguments_of_waves_are_numbers() -> None:
    found = known(x="m")
    found.exponents(sp.sin(k * x - c * t) + sp.cos(phi))
    assert [called(found, e) for e in (k, c, phi, prime(phi))] == ["m^-1", "s^-1", "1", "s^-1"]


def test_a_function_of_which_nothing_is_known_and_its_slope() -> None:
    found = known(x="m", y="m", m="kg")
    f = Unspecified.of("f", ("x",), x)
    found.equal(y, f)
    slope = Unspecified(*f.args[:2], sp.Tuple(1), x)
    assert [called(found, e) for e in (f, slope, m * slope)] == ["m", "1", "kg"]


def test_a_large_number_may_hide_a_unit() -> None:
    found = known(m="kg", x="m")
    found.exponents(10 * m + k)  # 10 m/s^2: k is a force
    assert found.dimension(k) is None


def test_contradictory_terms_have_no_dimension() -> None:
    found = known(m="kg", x="m")
    assert found.dimension(m + x) is None
    assert called(found, m) == "kg"


def test_the_dimension_that_a_factor_of_a_root_of_a_velocity_needs() -> None:
    """c √x' is a force: c is kg m^(1/2) s^(-3/2)."""
    of = {n: tuple(int(k) for k in dimension_of_unit(n)) for n in ("m", "N")}
    needed = dimensions_needed([(k * sp.sqrt(prime(x)), of["N"])], {x: of["m"]})
    assert needed is not None
    assert needed[k] == tuple(a - sp.Rational(b, 2) for a, b in zip(of["N"], velocity(), strict=True))


def velocity() -> tuple[int, ...]:
    return tuple(int(n) for n in dimension_of_unit("m/s"))
