"""Conditions in numbers."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.mechanics.equilibrium.in_numbers import condition_holds

a, b = sp.symbols("a b", positive=True)


@pytest.mark.parametrize(
    ("left", "relation", "right", "expected"),
    [(a, ">", 2 * a, False), (a, "<", 2 * a, True), (a, "≥", b, None), (2 * a, "≠", a, True)],
)
def test_a_condition_with_values(left: sp.Expr, relation: str, right: sp.Expr, expected: bool | None) -> None:
    assert (
        condition_holds(SignCondition(left, relation, right), lambda e: e.xreplace({a: sp.Float("1.5", 80)}))
        is expected
    )
