"""Purposes of paragraphs and of words in them."""

from __future__ import annotations

import pickle

from lagrange.document.builders import has_purpose, index_of, paragraph, prose
from lagrange.document.purposes import Phrase, Purpose


def test_words_with_a_role_are_a_text_like_any_other() -> None:
    words = Phrase("The accelerations are", Purpose.SUBJECT, "the accelerations")
    assert words == "The accelerations are"
    assert f"{words}." == "The accelerations are."
    again = pickle.loads(pickle.dumps(words))
    assert (again, again.purpose, again.instead) == (words, Purpose.SUBJECT, "the accelerations")
    assert Phrase("and").purpose is None


def test_a_role_is_no_part_of_what_a_paragraph_says() -> None:
    said = prose("It remains free.", purpose=Purpose.FREE)
    assert said == prose("It remains free.")
    assert has_purpose(said, Purpose.FREE)
    assert not has_purpose(said, Purpose.SOLVING)
    assert not has_purpose(None, Purpose.FREE)


def test_sentences_joined_have_the_role_of_the_first() -> None:
    assert paragraph(prose("a", purpose=Purpose.TIMELESS), prose("b", purpose=Purpose.FREE)).purpose is Purpose.TIMELESS


def test_words_are_found_by_their_role() -> None:
    parts = ("Solving, ", Phrase("where ", Purpose.WHERE), "x, gives", Phrase("where ", Purpose.WHERE))
    assert index_of(Purpose.WHERE, parts) == 1
    assert index_of(Purpose.VERB, parts) is None
