"""Wrong equations for constraints: the change that makes them right."""

from __future__ import annotations

import pytest

from tests.answers.test_student_answers import verdict_on


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        ("x' cosθ - y' sinθ = 0", "sine and cosine of theta exchanged"),
        ("x' sinθ + y' cosθ = 0", "the sign of the term"),
        ("y' sinθ - x' cosθ = 0", "exchanged"),
        ("2 x' sinθ - y' cosθ = 0", "in place of"),
        ("x' = y'", "the constraints do not require it"),
    ],
)
def test_one_change_is_named(stated: str, said: str) -> None:
    verdict, details = verdict_on("ex05-ice-skate", ".txt", stated)
    assert verdict == "wrong"
    assert any(said in line for line in details), details
