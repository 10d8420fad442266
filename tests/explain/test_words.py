"""Numbers and lists in words."""

from __future__ import annotations

import pytest

from lagrange.core.called import Called
from lagrange.explain.words import bare, in_words, introduced, spoken, the


def test_numbers_and_names_in_words() -> None:
    assert [in_words(n, "relation") for n in (0, 1, 2, 13)] == [
        "no relation", "one relation", "two relations", "13 relations",
    ]  # fmt: skip
    assert spoken("upper_rod") == "upper rod"
    assert spoken("no_slip.2") == "no slip 2"


@pytest.mark.parametrize(
    ("name", "words", "noun", "first"),
    [
        ("P1", "upper particle", "the upper particle", "the upper particle P1"),
        ("w", "a driving wheel", "the driving wheel", "the driving wheel w"),
        ("left", "left wheel", "the left wheel", "the left wheel"),
        ("T", "T-shaped rod", "the T-shaped rod", "the T-shaped rod T"),
        ("E", "Earth", "Earth", "Earth"),
        ("E", "the Earth", "the Earth", "the Earth E"),
        ("B", "Foucault's bob", "Foucault's bob", "Foucault's bob"),
        ("A", "body A", "body A", "body A"),
        ("P", "", "P", "P"),
    ],
)
def test_the_words_for_a_body_with_their_article(name: str, words: str, noun: str, first: str) -> None:
    called = Called(name, words)
    assert (the(called), introduced(called), bare(called)) == (noun, first, words or name)
