"""Two mistakes at once are named together."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, name_of


@pytest.mark.parametrize("answer", answers_by("pairs"), ids=name_of)
def test_both_are_named(answer: WrongAnswer) -> None:
    assert_named(answer)
