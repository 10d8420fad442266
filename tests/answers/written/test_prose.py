"""Sentences around an equation."""

from __future__ import annotations

import pytest

from lagrange.answers.written.prose import is_condition, without_prose, words_known
from lagrange.core.diagnostics import Fragment
from tests.support.scopes import PLANE


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
