"""Names that a problem does not declare, and everybody understands.

Short names of reactions in an answer.

A vector and its magnitude under one letter.

Coordinates of the answer's own.
"""

from __future__ import annotations

import pytest

from lagrange.answers.written.names import (
    as_virtual,
    coordinates_at_rest,
    defined_coordinate,
    lines_with,
    may_be_force,
    other_names,
    printed_names,
    rates_without_bar,
    spelled_out,
    with_names_of_vectors,
    without_arguments,
)
from lagrange.core.diagnostics import Fragment
from tests.answers.test_equations import given_reference
from tests.support.scopes import PENDULUM, PLANE
from tests.support.shared import reference_of


def test_short_names() -> None:
    reference = given_reference("pendulum")
    names, _ = other_names(["l*thdd = -g*sin(th)"], reference.scope, reference)
    assert names["th"] == reference.scope.slots.coordinates[0]
    assert other_names(["theta'' = 0"], reference.scope, reference)[0] == {}


def test_rates() -> None:
    assert rates_without_bar(["ddx = -k*x", "dx = 0"], PLANE) == {"x"}
    assert rates_without_bar(["dx = 0"], PLANE) == frozenset()


def test_a_coordinate_at_rest_has_an_index() -> None:
    assert {n: str(e) for n, e in coordinates_at_rest(["sin(theta_0) = 1/2"], PENDULUM).items()} == {"theta_0": "theta"}
    assert coordinates_at_rest(["sin(theta_1) = 1/2"], PENDULUM) == {}


@pytest.mark.parametrize(
    ("text", "written"), [("m(theta) = 1", "m = 1"), ("m(l) = 1", "m(l) = 1"), ("N(theta) = m*g", "N(theta) = m*g")]
)
def test_what_a_quantity_depends_on(text: str, written: str) -> None:
    assert without_arguments(Fragment.of(text), PENDULUM).text == written


def test_a_stationary_height() -> None:
    assert as_virtual(Fragment.of("dy/dx = 0"), PLANE).text == "δy = 0"
    assert as_virtual(Fragment.of("dy/da = 0"), PLANE).text == "dy/da = 0"  # a is no coordinate


# Printed names


def test_the_reaction_of_the_rod_is_t() -> None:
    assert {short: symbol.name for short, symbol in printed_names(reference_of("ex11-ideal-pendulum")).items()} == {
        "T": "T_rod",
        "lambda": "lambda_rod",
    }


def test_other_names_of_the_only_tension() -> None:
    pendulum = reference_of("ex11-ideal-pendulum")
    names = [printed_names(pendulum, [text]) for text in ("S = m*g*y/l", "F_T = 2", "F_x = 2", "S + 1 = 2", "m = S")]
    assert [sorted({*n} - {"T", "lambda"}) for n in names] == [["S"], ["F_T"], [], [], []]
    force, length = (pendulum.scope.scalars[p] for p in ("m", "l"))
    assert may_be_force("S", force * pendulum.scope.scalars["g"], [], pendulum)
    assert not may_be_force("S", length, [], pendulum)  # an arc


def test_friction_is_not_the_normal_force() -> None:
    incline = reference_of("ex15-rough-incline")
    assert "R" in printed_names(incline, ["R = m*g*cos(alpha)", "m*x'' = -mu*R"])
    assert "R" not in printed_names(incline, ["R = mu*N", "N = m*g*cos(alpha)"])
    assert "R" not in printed_names(incline, ["R = mu*m*g"], "Reibkraft R = mu*m*g")


def test_a_name_by_itself() -> None:
    assert lines_with("T", ["T = m g", "T_rod = 0", "mT", "2 T + 1"]) == [0, 3]
    assert lines_with("theta", [r"\\theta = 0", "θ = 0", "theta_1 = 0"]) == [0, 1]
    assert spelled_out("θ₁") == " theta_1"


@pytest.mark.parametrize(
    ("texts", "force"), [(["L = T - V"], False), (["the period is T"], False), (["T = m g"], True)]
)
def test_beside_energies_and_periods_t_is_no_force(texts: list[str], force: bool) -> None:
    assert may_be_force("T", None, texts, reference_of("ex11-ideal-pendulum")) is force


# Vector names


def renamed(*texts: str) -> list[str]:
    return [f.text for f in with_names_of_vectors([Fragment.of(t) for t in texts], PLANE)]


def test_a_letter_that_is_both_gets_two_names() -> None:
    assert renamed(r"\vec r = x \vec i", r"\vec F = - k \vec r/r^3")[1] == r"\vec F = - k \vec{r}_{vec}/r^3"


def test_a_letter_that_is_always_a_vector_keeps_its_name() -> None:
    assert renamed(r"\vec r = x \vec i", r"\vec F = - k \vec r") == [r"\vec r = x \vec i", r"\vec F = - k \vec r"]
    assert renamed("r = x", "F = - k/r^3") == ["r = x", "F = - k/r^3"]


# New coordinates


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("x = a + s", "-a + x"),
        ("x = b*s", "x/b"),
        ("x' = b*s'", "x/b"),
        ("x = s^2", "None"),  # not linear
        ("x' = x*s'", "None"),  # not to be integrated
    ],
)
def test_a_coordinate_in_terms_of_those_of_the_problem(text: str, meaning: str) -> None:
    assert str(defined_coordinate(Fragment.of(text), "s", PLANE)) == meaning
