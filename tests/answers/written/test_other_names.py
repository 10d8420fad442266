"""Names that a problem does not declare, and everybody understands."""

from __future__ import annotations

import pytest

from lagrange.answers.written.other_names import (
    as_virtual,
    coordinates_at_rest,
    other_names,
    rates_without_bar,
    without_arguments,
)
from lagrange.core.diagnostics import Fragment
from tests.answers.test_equations import given_reference
from tests.support.scopes import PENDULUM, PLANE


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
