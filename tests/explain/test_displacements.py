"""What is said where nothing can move."""

from __future__ import annotations

from lagrange.document.derivation import Rule
from tests.support.derivation_text import words
from tests.support.shared import reported


def test_where_nothing_is_free() -> None:
    steps = reported("constraints/servo").derivation.steps
    [freedom] = [s for s in steps if s.rule is Rule.DEGREES_OF_FREEDOM]
    assert "the constraints alone determine the position" in words(freedom)
