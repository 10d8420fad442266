"""Chains of values."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.texts.chains import sides_agree
from lagrange.core.diagnostics import Fragment
from tests.support.shared import reference_of


@pytest.mark.parametrize(
    ("text", "agree"),
    [
        ("v = sqrt(2*g*l) = sqrt(g*l*2)", True),
        ("v = 2*g*l = 3*g*l", False),
        ("v = sqrt(2*4.5) = 3.00", True),
        ("v = sqrt(2*4.5) = 3.10", False),
        ("v = g*l", None),
    ],
)
def test_sides_that_are_values(text: str, agree: bool | None) -> None:
    assert sides_agree(Fragment.of(text), reference_of("ex11-ideal-pendulum")) is agree
