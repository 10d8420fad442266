"""One equation in whatever notation it is written.

Why an equation cannot be read.
"""

from __future__ import annotations

import pytest

from lagrange.answers.written.reading import (
    is_name,
    quotes_the_method,
    read_as_written,
    too_long,
    tried,
    undeclared,
    without_braces,
)
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.expressions.edits import Draft
from lagrange.expressions.reader import read_value
from tests.support.scopes import PENDULUM, PLANE


@pytest.mark.parametrize(
    "text",
    [
        "l*theta'' = -g*sin(theta)",
        r"l\ddot\theta = -g\sin\theta",
        "l*thetaddot == -g*Sin[theta]",
        "l θ̈ + g sin θ = 0",
        "l*diff(theta, t, 2) + g*sin(theta) = 0",
    ],
)
def test_every_notation_means_the_same(text: str) -> None:
    [component] = read_as_written(Fragment.of(text), PENDULUM).components
    [expected] = read_as_written(Fragment.of("l*theta'' + g*sin(theta) = 0"), PENDULUM).components
    assert component == expected


def test_the_first_error_is_that_of_the_text_as_it_is_written() -> None:
    reading = read_as_written(Fragment.of("l*theta'' = -g*sinn(theta)"), PENDULUM)
    assert reading.error is not None
    assert "sinn" in reading.error.diagnostics[0].message
    with pytest.raises(ProblemError, match="qq"):
        tried(Fragment.of("qq"), PENDULUM, lambda f: read_value(f, PENDULUM, []))


def test_limits_and_braces() -> None:
    assert too_long(Fragment.of("x" * 30)).diagnostics[0].code == "expression-too-long"
    for text, inside in (("{x = 1}", "x = 1"), ("{x} = {1}", "{x} = {1}")):
        draft = Draft(Fragment.of(text))
        without_braces(draft)
        assert draft.text == inside


# Unread


@pytest.mark.parametrize(
    ("text", "names", "quoted"),
    [
        ("m*x'' = F - N", ["F", "N"], False),
        ("m*x'' = F(2)", [], False),  # applied to a number: a function, and no factor
        ("m*x'' = ", [], False),
        ("m*x'' = -k*x", [], False),
        ("d/dt(dL/dx') - dL/dx = 0", [], True),
    ],
)
def test_undeclared_names_and_the_quoted_method(text: str, names: list[str], quoted: bool) -> None:
    reading = read_as_written(Fragment.of(text), PLANE)
    assert quotes_the_method(reading, text, PLANE) is quoted
    if not quoted:
        assert undeclared(reading, text) == names


@pytest.mark.parametrize(("text", "name"), [("T_1", True), ("theta", True), ("2x", False), ("", False), ("x+y", False)])
def test_a_name_begins_with_a_letter(text: str, name: bool) -> None:
    assert is_name(text) is name
