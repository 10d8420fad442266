"""Why an equation cannot be read."""

from __future__ import annotations

import pytest

from lagrange.answers.written.reading import read_as_written
from lagrange.answers.written.unread import is_name, quotes_the_method, undeclared
from lagrange.core.diagnostics import Fragment
from tests.support.scopes import PLANE


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
