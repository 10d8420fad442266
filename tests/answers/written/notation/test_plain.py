"""Plain text in other notations."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.plain import cleaned, is_rate, is_velocity, rewritten
from lagrange.answers.written.reading import read_as_written
from lagrange.core.diagnostics import Fragment
from tests.support.scopes import PLANE


@pytest.mark.parametrize(
    "text",
    [
        "m*xddot = -k*x",
        "m x_dd = -k x",
        "m*diff(x(t), t, t) = -k*x(t)",
        "m*d^2x/dt^2 == -k*x",
        "m·ẍ = −k·x",
        "m*x\u2062'' = -k*x",  # an invisible times
    ],
)
def test_the_meaning_is_that_of_the_language(text: str) -> None:
    assert (
        read_as_written(Fragment.of(text), PLANE).components
        == read_as_written(Fragment.of("m*x'' = -k*x"), PLANE).components
    )


def test_what_is_in_the_language_stays() -> None:
    fragment = Fragment.of("m*x'' = -k*x")
    assert rewritten(fragment, PLANE) is fragment
    assert cleaned(fragment) is fragment


@pytest.mark.parametrize(
    ("name", "rate"), [("xddot", True), ("x_dd", True), ("ddx", True), ("x_d", False), ("q", False)]
)
def test_names_of_rates(name: str, rate: bool) -> None:
    assert is_rate(name, PLANE) is rate


def test_a_velocity_by_its_name() -> None:
    assert is_velocity("x", "'", PLANE)
    assert not is_velocity("k", "", PLANE)


@pytest.mark.parametrize(
    "text",
    ["m*x'' = k*cos 20° - k", "m*x'' = k cos20° - k", "m*x'' = k*cos 20 deg - k", "m*x'' = k*cos(20 degrees) - k"],
)
def test_the_degrees_belong_to_the_angle(text: str) -> None:
    """cos 20° is cos(π/9), and not (cos 20)°."""
    expected = read_as_written(Fragment.of("m*x'' = k*cos(pi/9) - k"), PLANE)
    assert read_as_written(Fragment.of(text), PLANE).components == expected.components
