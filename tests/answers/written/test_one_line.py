"""The equations of one line.

Numbers of equations, which are no factors.

Sentences around an equation.
"""

from __future__ import annotations

import pytest

from lagrange.answers.written.one_line import is_condition, lines_of, number_at_the_end, without_prose, words_known
from lagrange.core.diagnostics import Fragment
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


# Numbering


@pytest.mark.parametrize(
    ("text", "equation", "number"),
    [
        ("m x'' + k x = 0   (2)", "m x'' + k x = 0", "(2)"),
        (r"m \ddot x = 0\;(2a)", r"m \ddot x = 0", "(2a)"),
        ("x'' = g  [3]", "x'' = g", "[3]"),
        ("x'' = g (Ans.)", "x'' = g", "(Ans.)"),
        ("x'' = -(g)(2)", "x'' = -(g)(2)", ""),  # a factor
        ("x'' = a  (b)", "x'' = a", "(b)"),
        ("x'' = a (b)", "x'' = a (b)", ""),  # a name, unless the space is wide
        ("see (2)", "see (2)", ""),
    ],
)
def test_a_number_ends_an_equation(text: str, equation: str, number: str) -> None:
    end, found = number_at_the_end(text)
    assert (text[:end].rstrip(), found) == (equation, number)


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
