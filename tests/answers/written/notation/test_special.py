"""Notations that are rare in equations of motion and common in values."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.special import signs_as_indices, with_indices
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.edits import Draft
from tests.support.scopes import scope


@pytest.mark.parametrize(
    ("text", "written"),
    [("omega_+ = 2", "omega_plus = 2"), ("T_1/2 = 3", "T_half = 3"), ("x = omega_+", "x = omega_plus")],
)
def test_a_sign_is_an_index_on_the_left(text: str, written: str) -> None:
    draft = Draft(Fragment.of(text))
    signs_as_indices(draft)
    assert draft.text == written


def test_a_number_after_a_name_is_its_index_where_that_is_declared() -> None:
    declared = scope("x_1 x_2", "m")
    assert with_indices(Fragment.of("x1 = m"), declared).text.strip() == "x_1 = m"
    assert with_indices(Fragment.of("x3 = m"), declared).text == "x3 = m"
