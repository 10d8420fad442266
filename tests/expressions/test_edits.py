"""Texts rewritten, with places in the text as it was written."""

from __future__ import annotations

import re

from lagrange.core.diagnostics import Fragment
from lagrange.expressions.edits import Draft, closings, cut, cuts


def test_places_are_those_of_the_text_as_written() -> None:
    draft = Draft(Fragment.of("ab + cd"))
    draft.replace(re.compile("ab"), "long_name")
    made = draft.finished()
    assert made.text == "long_name + cd"
    span = made.span(made.text.index("cd"), len(made.text))
    assert (span.start, span.end) == (5, 7)


def test_parts_outside_brackets() -> None:
    text = "f(a, b), c"
    assert [text[a:b] for a, b in cuts(text, re.compile(","))] == ["f(a, b)", " c"]
    assert closings("f(a[0])") == {1: 6, 3: 5}
    assert cut(Fragment.of(text), 0, 7).text == "f(a, b)"


def test_what_is_kept() -> None:
    draft = Draft(Fragment.of("so x = 1."))
    draft.keep(3, 8)
    assert draft.text == "x = 1"
