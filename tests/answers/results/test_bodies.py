"""Values and conditions that are right for bodies with other moments of inertia."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

ROLLING = "cylinder-on-rough-incline"

WRONG: list[Row] = [
    (ROLLING, "rest", ["tan(alpha) <= 2*mu_s"], "with the moment of inertia m*R^2 for `cylinder`, which a hoop has"),
    ("bowling-ball", "ask", {"speed": "2*v/3"}, "which a disc or solid cylinder has"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_results_for_other_bodies(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
