"""Constraints that are seen to be finite relations share a section; others keep theirs."""

from __future__ import annotations

import pytest

from lagrange.explain.page.shorter.at_sight import explain_at_sight, integrates_at_sight
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("name", "at_sight"),
    [
        ("cylinder-on-rough-incline", True),  # exact
        ("cylinder-on-wedge", True),  # exact where h = R
        ("turning-parabola", True),  # two geometric ones, with time
        ("sleigh", False),  # not integrable
        ("ex17-spherical-pendulum", False),  # one with time, whose sections show what it changes
        ("towed-blade", False),  # about nothing but the constraints
    ],
)
def test_which_are_seen(name: str, at_sight: bool) -> None:
    assert integrates_at_sight(solved(name, complete=False)) is at_sight


@pytest.mark.parametrize("name", ["cylinder-on-wedge"])
def test_the_relation_of_rolling_is_in_the_section_and_right(name: str) -> None:
    solution = solved(name, complete=False)
    said = str(explain_at_sight(solution).body)
    assert "Where " in said
    assert "integrates to" in said
    [rolling] = [c for c in solution.classification.constraints if c.row.finite is None]
    slots = solution.problem.slots
    names = {s.name: s for s in rolling.constraint.function.free_symbols | rolling.integral.free_symbols}
    held = {names["h"]: names["R"]}
    rate = slots.time_derivative(rolling.integral)
    assert (rate - rolling.constraint.function.xreplace(held)).expand() == 0
