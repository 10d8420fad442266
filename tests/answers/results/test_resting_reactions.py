"""Wrong reactions of a system at rest, as functions of the position."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import assert_explained


@pytest.mark.parametrize(
    ("stated", "said"), [("W*z/l", "the term F*x/l is missing"), ("(W*z - F*x)/l", "for F with the opposite sign")]
)
def test_a_letter_or_a_term(stated: str, said: str) -> None:
    assert_explained("pendulum-in-wind", "reactions", {"rod": stated}, said)
