"""Equations in the names that the file gives."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import prime
from lagrange.mechanics.rewriting.stated_names import in_names
from tests.support.shared import solved


def test_a_quasi_velocity_stands_for_its_definition() -> None:
    solution = solved("snakeboard")
    speed = next(u for u in solution.problem.speeds if u.definition.is_Add)
    rate = solution.problem.slots.time_derivative(speed.definition)
    ((left, right),) = in_names(solution, ((speed.definition, rate),))
    assert left == speed.symbol
    assert right == prime(speed.symbol)


def test_without_names_nothing_changes() -> None:
    stated = ((sp.Symbol("x"), sp.S.Zero),)
    assert in_names(solved("ex11-ideal-pendulum"), stated) == stated
