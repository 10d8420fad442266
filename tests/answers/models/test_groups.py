"""Wrong answers of two causes, in one equation alone, or of none that is known."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, name_of


@pytest.mark.parametrize("answer", answers_by(""), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)
