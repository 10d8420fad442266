"""Positions that a branch states, in any form: they balance if it is right, and do not if it is wrong.

Points of a surface in numbers, at which one of several systems has to hold.
"""

from __future__ import annotations

from itertools import islice

import mpmath
import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.symbols import Decimal, Unspecified
from lagrange.mechanics.equilibrium.searched.stated_places import (
    StatedPlaces,
    are_covered,
    holds_in_numbers,
    without_functions,
)
from tests.mechanics.equilibrium.test_stated_equilibria import found
from tests.support.statics_texts import BEAD, PENDULUM, SKATE

A, B = sp.symbols("a b", positive=True)
THETA, X, Y = sp.symbols("theta x y", real=True)


@pytest.mark.parametrize(
    ("text", "relations", "holds"),
    [
        (BEAD, {sp.cos(THETA) ** 3: B**3 / A**3}, True),
        (BEAD, {sp.cos(THETA) ** 3: B**3 / (8 * A**3)}, False),
        (PENDULUM, {X**3: sp.S.Zero}, True),
        (PENDULUM, {Y: sp.S.Zero}, False),
        (SKATE, {X * sp.cos(THETA): -Y * sp.sin(THETA)}, True),
        (SKATE, {X * sp.cos(THETA): Y * sp.sin(THETA)}, False),
    ],
)
def test_the_forces_balance_where_a_branch_is_right(text: str, relations: dict[sp.Expr, sp.Expr], holds: bool) -> None:
    """Of x³ = 0, a triple root, no position is confirmed: nothing is claimed."""
    triple = X**3 in relations
    branch = Branch(tuple(Relation(lhs, rhs) for lhs, rhs in relations.items()))
    assert holds_in_numbers(found(text), branch) is (None if triple else holds)


def test_the_conditions_of_a_branch_are_met() -> None:
    places = list(islice(StatedPlaces([sp.cos(THETA) - B / A], [SignCondition(A, ">", B)], [THETA], [THETA]), 4))
    assert len(places) == 4
    for theta, a, b in places:
        assert a > b
        assert abs(mpmath.cos(theta) - b / a) < mpmath.mpf(10) ** -40
    assert not list(StatedPlaces([sp.cos(THETA) - B / A], [SignCondition(-A, ">", B)], [THETA], [THETA]))


def test_the_polynomial_of_a_function_has_its_derivatives() -> None:
    f = Unspecified.of("f", ["X", "Y"], X, Y)
    value, slope = without_functions([f, f.partial(1)])
    assert sp.expand(value.diff(Y) - slope) == 0
    assert value.has(X, Y)


# Stated in numbers


THETA_STATED_IN_NUMBERS = sp.Symbol("theta", real=True)
A_STATED_IN_NUMBERS, B_STATED_IN_NUMBERS = sp.symbols("a b", positive=True)
CUT = A_STATED_IN_NUMBERS * sp.sin(THETA_STATED_IN_NUMBERS) - B_STATED_IN_NUMBERS * THETA_STATED_IN_NUMBERS


@pytest.mark.parametrize(
    ("systems", "covered"),
    [
        (
            [[sp.sin(THETA_STATED_IN_NUMBERS) / THETA_STATED_IN_NUMBERS - B_STATED_IN_NUMBERS / A_STATED_IN_NUMBERS]],
            True,
        ),
        (
            [[sp.sin(THETA_STATED_IN_NUMBERS) / THETA_STATED_IN_NUMBERS - A_STATED_IN_NUMBERS / B_STATED_IN_NUMBERS]],
            False,
        ),
        (
            [
                [THETA_STATED_IN_NUMBERS - 1],
                [A_STATED_IN_NUMBERS / B_STATED_IN_NUMBERS - THETA_STATED_IN_NUMBERS / sp.sin(THETA_STATED_IN_NUMBERS)],
            ],
            True,
        ),
        ([[CUT, THETA_STATED_IN_NUMBERS - 1]], False),
        ([[1 / (CUT * 0 + sp.cos(THETA_STATED_IN_NUMBERS) ** 2 + sp.sin(THETA_STATED_IN_NUMBERS) ** 2 - 1)]], False),
        ([[THETA_STATED_IN_NUMBERS - Decimal("1.25", "1:1")]], None),
    ],
)
def test_transcendental_equilibria(systems: list[list[sp.Expr]], covered: bool | None) -> None:
    """a sin θ = b θ where θ ≠ 0, in other forms. A decimal stands for many numbers, and is not tried."""
    conditions = [SignCondition(THETA_STATED_IN_NUMBERS, "≠", sp.S.Zero)]
    assert are_covered([CUT], conditions, [THETA_STATED_IN_NUMBERS], [THETA_STATED_IN_NUMBERS], systems) is covered


def test_nothing_found_is_undecided() -> None:
    """a sin θ = b θ + 9 a has no root with b small, and cos θ = 2 none at all."""
    assert (
        are_covered(
            [sp.cos(THETA_STATED_IN_NUMBERS) - 2],
            [],
            [THETA_STATED_IN_NUMBERS],
            [THETA_STATED_IN_NUMBERS],
            [[THETA_STATED_IN_NUMBERS]],
        )
        is None
    )


def test_conditions_are_met() -> None:
    """θ² = a²; θ > 0 leaves θ = a."""
    both, positive = (
        [THETA_STATED_IN_NUMBERS**2 - A_STATED_IN_NUMBERS**2],
        [SignCondition(THETA_STATED_IN_NUMBERS, ">", sp.S.Zero)],
    )
    assert (
        are_covered(both, positive, [THETA_STATED_IN_NUMBERS], [], [[THETA_STATED_IN_NUMBERS - A_STATED_IN_NUMBERS]])
        is True
    )
    assert (
        are_covered(both, [], [THETA_STATED_IN_NUMBERS], [], [[THETA_STATED_IN_NUMBERS - A_STATED_IN_NUMBERS]]) is False
    )


def test_an_undefined_function() -> None:
    """a f'(θ) = b θ, the same function on both sides."""
    slope = Unspecified.of("f", ["X"], THETA_STATED_IN_NUMBERS).partial(0)
    assert (
        are_covered(
            [A_STATED_IN_NUMBERS * slope - B_STATED_IN_NUMBERS * THETA_STATED_IN_NUMBERS],
            [],
            [THETA_STATED_IN_NUMBERS],
            [],
            [[slope / THETA_STATED_IN_NUMBERS - B_STATED_IN_NUMBERS / A_STATED_IN_NUMBERS]],
        )
        is True
    )
    assert (
        are_covered(
            [A_STATED_IN_NUMBERS * slope - B_STATED_IN_NUMBERS * THETA_STATED_IN_NUMBERS],
            [],
            [THETA_STATED_IN_NUMBERS],
            [],
            [[slope / THETA_STATED_IN_NUMBERS - A_STATED_IN_NUMBERS / B_STATED_IN_NUMBERS]],
        )
        is False
    )
