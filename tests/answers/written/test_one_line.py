"""The equations of one line.

Sentences around an equation.
"""

from __future__ import annotations

import pytest

from lagrange.answers.written.one_line import (
    each_equation_of_motion,
    is_condition,
    lines_of,
    without_integrals,
    without_order_term,
    without_prose,
    words_known,
)
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.latex_layout import OneEquation
from tests.support.scopes import PLANE


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        ("m x'' = -k x   (2)", ["m x'' = -k x"]),
        ("N = m g = 4", ["N = m g", "N  =  4"]),
        (r"\text{radial: } m x'' = F", ["m x'' = F"]),
        ("[x'' = g]", ["x'' = g"]),
        ("(a) x'' = g", ["x'' = g"]),
        ("cos(theta) = 2/3 ≈ 0.67", ["cos(theta) = 2/3"]),
        ("theta = 0 or theta = pi", ["theta = 0 or theta = pi"]),
    ],
)
def test_what_stands_around_equations_is_left_out(text: str, equations: list[str]) -> None:
    assert [line.fragment.text.strip() for line in lines_of(Fragment.of(text), ())] == equations


# Prose


@pytest.mark.parametrize(
    ("text", "equation"),
    [
        ("let x be the elongation, so x = a + y", "x = a + y"),
        ("Newton's second law gives m*x'' = -k*x", "m*x'' = -k*x"),
        ("x'' = -k/m*x, thus the motion is harmonic", "x'' = -k/m*x"),
        ("m*x'' = -k*x", "m*x'' = -k*x"),
        ("weight x = a", "weight x = a"),  # one unknown word may be a factor
    ],
)
def test_the_equation_in_a_sentence(text: str, equation: str) -> None:
    assert without_prose(Fragment.of(text), words_known(PLANE, [text])).text.strip() == equation


@pytest.mark.parametrize(
    ("words", "condition"), [("slack when", True), ("slack when:", False), ("we find", False), ("", False)]
)
def test_what_follows_when_is_a_condition(words: str, condition: bool) -> None:
    assert is_condition(words) is condition


@pytest.mark.parametrize(
    ("text", "kept", "approximate"),
    [
        ("x'' = -k*x + O(x^3)", "x'' = -k*x", True),
        ("x'' = -sin(x) = -x + o(x^2)", "x'' = -sin(x)", False),
        ("x'' = -k*x + O*x", "x'' = -k*x + O*x", False),
    ],
)
def test_terms_of_higher_order_are_left_out(text: str, kept: str, approximate: bool) -> None:
    made = without_order_term(OneEquation.of(text), ())
    assert made.text == kept
    assert ("approx" in getattr(made, "beside", "")) is approximate


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        ("t = ∫_a^b f dx = c", "t = c"),
        (r"\int_0^t F\,dt = m v = p", r" m v = p"),
        ("t = ∫_a^b f dx", "t = ∫_a^b f dx"),
        ("q = ∫ i dt = c", "q = ∫ i dt = c"),
    ],
)
def test_integrals_with_limits_are_left_out_of_chains(text: str, kept: str) -> None:
    assert without_integrals(Fragment.of(text)).text.split() == kept.split()


def test_alternatives_of_motion_are_equations() -> None:
    assert [f.text.strip() for f in each_equation_of_motion(Fragment.of("x'' = a or x'' = b"))] == [
        "x'' = a",
        "x'' = b",
    ]
    assert len(each_equation_of_motion(Fragment.of("x = a or x = b"))) == 1
