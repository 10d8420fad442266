"""Branches that the values of a problem exclude."""

from __future__ import annotations

from lagrange.mechanics.questions.in_numbers import branches_with
from lagrange.mechanics.valued import values_in
from tests.support.shared import SHIPPED, solved

NAME = next(n for n in ("block-pulled-up-a-slope", "released-pendulum", "ball-thrown-up") if n in SHIPPED)


def test_no_branch_is_left_out_that_the_values_permit() -> None:
    solution = solved(NAME)
    values = values_in(solution)
    for asked in solution.asked:
        if values is not None:
            assert set(branches_with(asked, values)) <= set(asked.branches)
        assert asked.branches
