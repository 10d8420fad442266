"""Equations in abbreviations."""

from __future__ import annotations

from dataclasses import replace

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.mechanics.nearby.long_equations import check_long_equations, long_equations
from tests.mechanics.nearby.test_linear_motion import bicycle


def test_the_equations_of_the_bicycle_in_abbreviations() -> None:
    problem, configuration, _ = bicycle()
    found = long_equations(problem, configuration)
    [check] = check_long_equations(found, configuration)
    assert check.passed
    wrong = replace(found, whole=(*found.whole[:-1], found.whole[-1] + problem.slots.accelerations[0]))
    assert not check_long_equations(wrong, configuration)[0].passed
    z = next(iter(found.definitions))
    # Written out again, an equation is what it was before, whatever the abbreviations are.
    whole = found.left[-2]
    for name, e in reversed(found.definitions.items()):
        whole = whole.xreplace({name: e})
    assert z.name == "Z_1"
    assert is_zero(whole - found.whole[-2]) is True
