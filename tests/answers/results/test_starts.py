"""Wrong accelerations and reactions at the start."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

WRONG: list[Row] = [
    ("rear-wheel-drive", "ask", {"behind": "m*g*c/(b + c)"}, "without the force `drive`"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_values_at_the_start(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
