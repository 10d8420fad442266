"""Degrees of freedom and classes of constraints in words."""

from __future__ import annotations

import pytest

from lagrange.answers.written.in_words import stated_in_words


@pytest.mark.parametrize(
    ("text", "freedom", "classes"),
    [
        ("Degrees of freedom: 6 - 1 = 5", 5, ()),
        ("x^2 + y^2 = l^2\nDOF = 1, holonomic", 1, ("holonomic",)),
        ("It has two degrees of freedom and is not holonomic", 2, ("nonholonomic",)),
        (r"\( f=6-1=5 \), scleronomic", 5, ("scleronomic",)),
        ("Zahl der Freiheitsgrade: 5, anholonom, rheonom", 5, ("nonholonomic", "rheonomic")),
        ("m x'' + k x = 0", None, ()),
    ],
)
def test_freedom_and_classes_in_words(text: str, freedom: int | None, classes: tuple[str, ...]) -> None:
    stated = stated_in_words(text)
    assert (stated.degrees_of_freedom, stated.classification) == (freedom, classes)
