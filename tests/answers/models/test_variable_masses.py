"""Mistakes with a mass that varies are named."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, feedback_on, name_of


@pytest.mark.parametrize("answer", answers_by("variable_masses"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)


def test_a_constant_mass_is_named() -> None:
    said = feedback_on("rocket", "m_0*y'' = q*u - m_0*g")
    assert "for a constant mass m_0 of `rocket`, that at the start" in said
    assert "constant mass" not in feedback_on("rocket", "m_1*y'' = q*u - m_1*g")
