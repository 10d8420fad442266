"""Coordinates that the constraints give in terms of the others."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.questions.dependent import completed, dependent, reduced
from tests.support.shared import solved

x, y = sp.symbols("x y", real=True)


def test_what_a_rule_makes_of_equations_and_states() -> None:
    assert reduced([x - y, x + y], {x: y}) == [2 * y]
    assert completed({y: sp.Integer(3)}, {x: 2 * y}, [x, y]) == {x: 6, y: 3}


def test_free_coordinates_depend_on_nothing() -> None:
    assert dependent(solved("ex11-ideal-pendulum").choices[0].configuration) == {}
