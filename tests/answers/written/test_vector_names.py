"""A vector and its magnitude under one letter."""

from __future__ import annotations

from lagrange.answers.written.vector_names import with_names_of_vectors
from lagrange.core.diagnostics import Fragment
from tests.support.scopes import PLANE


def renamed(*texts: str) -> list[str]:
    return [f.text for f in with_names_of_vectors([Fragment.of(t) for t in texts], PLANE)]


def test_a_letter_that_is_both_gets_two_names() -> None:
    assert renamed(r"\vec r = x \vec i", r"\vec F = - k \vec r/r^3")[1] == r"\vec F = - k \vec{r}_{vec}/r^3"


def test_a_letter_that_is_always_a_vector_keeps_its_name() -> None:
    assert renamed(r"\vec r = x \vec i", r"\vec F = - k \vec r") == [r"\vec r = x \vec i", r"\vec F = - k \vec r"]
    assert renamed("r = x", "F = - k/r^3") == ["r = x", "F = - k/r^3"]
