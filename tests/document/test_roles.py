"""Roles of paragraphs and of words in them."""

from __future__ import annotations

import pickle

from lagrange.document.builders import has_role, paragraph, place_of, prose
from lagrange.document.roles import Phrase, Role


def test_words_with_a_role_are_a_text_like_any_other() -> None:
    words = Phrase("The accelerations are", Role.SUBJECT, "the accelerations")
    assert words == "The accelerations are"
    assert f"{words}." == "The accelerations are."
    again = pickle.loads(pickle.dumps(words))
    assert (again, again.role, again.instead) == (words, Role.SUBJECT, "the accelerations")
    assert Phrase("and").role is None


def test_a_role_is_no_part_of_what_a_paragraph_says() -> None:
    said = prose("It remains free.", role=Role.FREE)
    assert said == prose("It remains free.")
    assert has_role(said, Role.FREE)
    assert not has_role(said, Role.SOLVING)
    assert not has_role(None, Role.FREE)


def test_sentences_joined_have_the_role_of_the_first() -> None:
    assert paragraph(prose("a", role=Role.TIMELESS), prose("b", role=Role.FREE)).role is Role.TIMELESS


def test_words_are_found_by_their_role() -> None:
    parts = ("Solving, ", Phrase("where ", Role.WHERE), "x, gives", Phrase("where ", Role.WHERE))
    assert place_of(Role.WHERE, parts) == 1
    assert place_of(Role.VERB, parts) is None
