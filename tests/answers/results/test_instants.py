"""Wrong times, places and motions: what happens then and there instead."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

WRONG: list[Row] = [
    ("weight-let-go-on-a-spring", "ask", {"lowest": "m*g/k"}, "the middle of the oscillation"),
    ("weight-let-go-on-a-spring", "ask", {"time": "2*pi*sqrt(m/k)"}, "it is a whole period"),
    (
        "weight-let-go-on-a-spring",
        "ask",
        {"motion": "m*g/k*cos(sqrt(k/m)*t)"},
        "at t = 0 this gives x = m*g/k and not 0",
    ),
    ("thrown-stone", "ask", {"time": "v*sin(alpha)/g"}, "then y' = 0"),
    ("thrown-stone", "ask", {"range": "v^2*sin(2*alpha)/(2*g)"}, "there y' = 0"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_times_places_and_motions(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
