"""Wrong values whose dimensions betray them."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

WRONG: list[Row] = [
    ("damped-oscillator", "response", {"x": "F/sqrt((c - m*w^2)^2 + b^2)"}, "its terms have different dimensions"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_dimensions(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
