"""Equations that are linear in powers of the unknowns, and forms that vanish at the origin alone."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.linear_in_powers import (
    solved_for_powers,
    vanish_at_origin_alone,
    zeros_of_even_sum,
)

x, y, z = sp.symbols("x y z", real=True)
a, b, c = sp.symbols("a b c", positive=True)


@pytest.mark.parametrize(
    ("sum_of_powers", "zero"),
    [
        (2 * x**2 + y**2, True),
        (-3 * x**4 - x**2 * y**2 - y**6, True),
        (x**2 - y**2, False),
        (x**2 + x**2 * y**2, False),  # y has no power of its own
        (x**2 + y**3, False),
    ],
)
def test_a_sum_of_even_powers_vanishes_where_all_unknowns_do(sum_of_powers: sp.Expr, zero: bool) -> None:
    assert zeros_of_even_sum(sum_of_powers, (x, y)) == ((x, y) if zero else ())


def test_equations_linear_in_squares_are_solved_for_them() -> None:
    assert solved_for_powers([2 * x**2 - 3 * y**2, 3 * x**2 - 2 * y**2], [x, y]) == (x**2, y**2)
    assert solved_for_powers([2 * x**2 + y**2 - a, x**2 + 2 * y**2 - b], [x, y]) == (
        3 * x**2 - 2 * a + b,
        3 * y**2 + a - 2 * b,
    )
    assert solved_for_powers([2 * x**2 - 3 * y**2, 4 * x**2 - 6 * y**2], [x, y]) is None  # one line
    assert solved_for_powers([x**2 - y**2, x * y - z], [x, y, z]) is None  # more monomials than equations
    assert solved_for_powers([x * y - a, x * z - b], [x, y, z]) is None  # of products: a skate, λ sin θ and λ cos θ
    assert solved_for_powers([x**2 - a, y**2 - b], [x, y]) is None  # solved already


@pytest.mark.parametrize(
    ("forms", "alone"),
    [
        ([2 * x**2 - 3 * y**2, 3 * x**2 - 2 * y**2], True),
        ([c * (2 * x**2 + 3 * x * y + 8 * y**2)], True),
        ([x**2 + 3 * x * y + 2 * y**2], False),
        ([4 * x**3 + y**3, x**2 - y**2], True),
        ([x * y, y**2], False),  # y = 0
        ([x * y, x**2], False),
        ([x**2 - y**2, x**3 - y**3], False),  # x = y
        ([x**2 + y], False),  # of no one degree
        ([a * x**2 + b * y**2 - c * x * y], False),  # it depends on the letters
    ],
)
def test_forms_in_two_unknowns(forms: list[sp.Expr], alone: bool) -> None:
    assert vanish_at_origin_alone(forms, [x, y]) is alone


@pytest.mark.parametrize(
    ("potential", "points"),
    [
        (c * (x**4 + y**4 - 3 * x**2 * y**2), 1),
        (x**4 + x * y**3 + 2 * y**4 + x**2 * y**2, 1),
        (x**4 + y**4 + z**4 - 3 * x**2 * y**2 - 5 * y**2 * z**2 - x**2 * z**2, 1),
        (x**6 + y**6 - 3 * x**2 * y**2, 5),  # and |x| = |y| = 1
    ],
)
def test_no_branch_that_is_only_the_origin_is_left_as_equations(potential: sp.Expr, points: int) -> None:
    unknowns = sorted(potential.free_symbols - {c}, key=str)
    found = solutions([potential.diff(u) for u in unknowns], unknowns)
    assert found.solved
    assert sum(len(b.points) for b in found.branches) == points
    assert not any(b.left for b in found.branches)


def test_equations_linear_in_cosines() -> None:
    """2 cos φ + 1 = 3 cos θ and 2 cos θ + 1 = 3 cos φ hold where both cosines are 1."""
    found = solutions([1 - 3 * sp.cos(x) + 2 * sp.cos(y), 1 - 3 * sp.cos(y) + 2 * sp.cos(x)], [x, y])
    assert [{r.lhs: r.rhs for r in branch.relations} for branch in found.branches] == [{x: 0, y: 0}]


def test_squares_that_exist_under_conditions() -> None:
    """V = x⁴ + y⁴ + x² y² − a x² − b y² has x² = (2a − b)/3, y² = (2b − a)/3 where neither is negative."""
    v = x**4 + y**4 + x**2 * y**2 - a * x**2 - b * y**2
    found = solutions([v.diff(x), v.diff(y)], [x, y])
    both = [branch for branch in found.branches if branch.conditions]
    assert len(both) == 4
    assert len(found.branches) == 9
    for branch in both:
        values = {r.lhs: r.rhs for r in branch.relations}
        assert sp.expand(values[x] ** 2 - (2 * a - b) / 3) == 0
        assert sp.expand(values[y] ** 2 - (2 * b - a) / 3) == 0
        assert {(k.lhs, k.rhs) for k in branch.conditions} == {(2 * b, a), (2 * a, b)}
