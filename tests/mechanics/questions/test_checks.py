"""Answers to questions satisfy their equations, by another route."""

from __future__ import annotations

import pytest

from tests.support.shared import solved


@pytest.mark.parametrize("name", ["leaving-a-sphere", "thrown-stone", "released-pendulum"])
def test_there_is_a_check_and_it_holds(name: str) -> None:
    solution = solved(name)
    found = [c for c in solution.checks if any(a.question.name in c.name or "answer" in c.name for a in solution.asked)]
    assert found
    assert all(c.passed for c in found)
