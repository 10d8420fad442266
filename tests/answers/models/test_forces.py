"""Mistakes in the applied forces are named."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, name_of


@pytest.mark.parametrize("answer", answers_by("forces"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)
