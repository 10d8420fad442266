"""Formulas that stand unmarked in a sentence: where they begin and end."""

from __future__ import annotations

import pytest

from lagrange.expressions.formulas_in_text import formulas_in

NAMES = {"a", "c", "m", "p", "x", "y", "z", "theta", "I"}


@pytest.mark.parametrize(
    ("text", "formulas"),
    [
        ("the bowl z = c (x^2 + y^2) is smooth", ["z = c (x^2 + y^2)"]),
        ("a wire (y = x^2/(2 p)), smooth", ["y = x^2/(2 p)"]),
        ("along x = y = z.", ["x = y = z"]),
        ("where y = x (m is known)", ["y = x"]),
        ("f(x) = x^2", ["x^2"]),
        ("of a x^2, the x-axis, m's, a x-y plane", ["x^2"]),
        ("the force c*sin(theta) and -c*x", ["c*sin(theta)", "-c*x"]),
        ("m = 3 kg fall with 9.81 m/s^2 for 2 s", ["m = 3 kg", "9.81 m/s^2"]),
        ("y = 3 m", ["y = 3 m"]),  # m is a mass here
        ("x^2 + q y = 3, v = c x", ["x^2"]),  # q and v are not declared: a part would say something else
        ("((x, m or c, x -, = y", []),
        ("", []),
    ],
)
def test_where_formulas_are(text: str, formulas: list[str]) -> None:
    assert [text[start:end] for start, end in formulas_in(text, NAMES)] == formulas
