"""Proportions, tuples, and the greatest of several values, as equations."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.ratios import extremes, name_of_extreme, ratios_of, tuples_of
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.edits import Draft


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        ("h : R = 5 : 2", ["(h)/(R) = (5)/(2)"]),
        ("ratio: x : y = -1 : 1", ["(x)/(y) = (-1)/(1)"]),
        ("A:B:C = 1:2:1", ["(A)/(B) = (1)/(2)", "(B)/(C) = (2)/(1)"]),
        ("P/W = 3 : tan(theta)", ["P/W = (3)/(tan(theta))"]),
        ("theta = 0: omega = 3", []),
        ("Equation: x = 2", []),
    ],
)
def test_ratios(text: str, equations: list[str]) -> None:
    assert ratios_of(text) == equations


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        ("(x, y) = (1, 2)", ["x = 1", "y = 2"]),
        ("(x, y) = (0, 0), (0, pi)", ["[x, y] = [0, 0]", "[x, y] = [0, pi]"]),
        ("(x, y) = (0, 0, 1)", []),
        ("(x + y) = (a)", []),
    ],
)
def test_tuples(text: str, equations: list[str]) -> None:
    assert tuples_of(text) == equations


def test_the_greatest_of_several_values() -> None:
    draft = Draft(Fragment.of("min(a, b)"))
    draft.apply(extremes(draft.text))
    assert draft.text == "(((a)+( b)-abs((a)-( b)))/2)"
    assert name_of_extreme("max(T) = 3 m g") == "T_max = 3 m g"
