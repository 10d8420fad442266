"""Mistakes in the meaning of letters are named.

Quasi-velocities taken for velocities of coordinates: the mistake is named.

Mistakes in how fast a body turns are named.
"""

from __future__ import annotations

import pytest

from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, name_of


@pytest.mark.parametrize("answer", answers_by("kinematics"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)
