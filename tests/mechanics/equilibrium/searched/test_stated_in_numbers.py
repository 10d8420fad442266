"""Points of a surface in numbers, at which one of several systems has to hold."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.core.symbols import Decimal, Unspecified
from lagrange.mechanics.equilibrium.searched.stated_in_numbers import are_covered

THETA = sp.Symbol("theta", real=True)
A, B = sp.symbols("a b", positive=True)
CUT = A * sp.sin(THETA) - B * THETA


@pytest.mark.parametrize(
    ("systems", "covered"),
    [
        ([[sp.sin(THETA) / THETA - B / A]], True),
        ([[sp.sin(THETA) / THETA - A / B]], False),
        ([[THETA - 1], [A / B - THETA / sp.sin(THETA)]], True),
        ([[CUT, THETA - 1]], False),
        ([[1 / (CUT * 0 + sp.cos(THETA) ** 2 + sp.sin(THETA) ** 2 - 1)]], False),
        ([[THETA - Decimal("1.25", "1:1")]], None),
    ],
)
def test_transcendental_equilibria(systems: list[list[sp.Expr]], covered: bool | None) -> None:
    """a sin θ = b θ where θ ≠ 0, in other forms. A decimal stands for many numbers, and is not tried."""
    conditions = [SignCondition(THETA, "≠", sp.S.Zero)]
    assert are_covered([CUT], conditions, [THETA], [THETA], systems) is covered


def test_nothing_found_is_undecided() -> None:
    """a sin θ = b θ + 9 a has no root with b small, and cos θ = 2 none at all."""
    assert are_covered([sp.cos(THETA) - 2], [], [THETA], [THETA], [[THETA]]) is None


def test_conditions_are_met() -> None:
    """θ² = a²; θ > 0 leaves θ = a."""
    both, positive = [THETA**2 - A**2], [SignCondition(THETA, ">", sp.S.Zero)]
    assert are_covered(both, positive, [THETA], [], [[THETA - A]]) is True
    assert are_covered(both, [], [THETA], [], [[THETA - A]]) is False


def test_an_undefined_function() -> None:
    """a f'(θ) = b θ, the same function on both sides."""
    slope = Unspecified.of("f", ["X"], THETA).partial(0)
    assert are_covered([A * slope - B * THETA], [], [THETA], [], [[slope / THETA - B / A]]) is True
    assert are_covered([A * slope - B * THETA], [], [THETA], [], [[slope / THETA - A / B]]) is False
