"""Several contacts with one coefficient of friction: which of them is wrong?"""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

WRONG: list[Row] = [
    ("cylinder-in-a-corner", "equilibrium", [["M = mu*W*r"]], "this is the limit without the friction `rub_B`"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_contacts(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
