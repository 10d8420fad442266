"""Wrong speeds, times and distances of a motion with a constant acceleration."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import assert_explained


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        ({"distance": "v^2/(2*g*sin(alpha))"}, "this is the answer without the friction `rub`"),
        ({"time": "v/(g*(sin(alpha) - mu*cos(alpha)))"}, "the friction `rub` acting the other way"),
        ({"time": "v/(g*(sin(alpha) + mu))"}, "the normal force m*g, the whole weight"),
    ],
)
def test_a_stopping_sledge(stated: object, said: str) -> None:
    assert_explained("sledge-up-a-slope", "ask", stated, said)
