"""Both sides of where a sign changes."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import Fields, Point, Surface, agreed, is_zero

x, y, z, theta, phi, t = sp.symbols("x y z theta phi t", real=True)
m, l, g, k, omega = sp.symbols("m l g k omega", positive=True)
sin, cos, tan, sqrt, pi = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi


@pytest.mark.parametrize("count", [2, 10])
def test_many_roots_need_few_draws(count: int) -> None:
    ys = sp.symbols(f"y:{count}", real=True)
    roots = [sqrt(l**2 - v**2) for v in ys]
    total = sp.Add(*roots)
    assert is_zero(total - sp.Add(*((l - v) * (l + v) / r for v, r in zip(ys, roots, strict=True)))) is True
    assert is_zero(total - l) is False
    assert is_zero(sp.Mul(*roots) - sqrt(sp.Mul(*(l**2 - v**2 for v in ys)))) is True


def test_many_absolute_values() -> None:
    factors = [v + 1 for v in sp.symbols("y:5", real=True)]
    product = sp.Mul(*factors)
    assert is_zero(sp.Mul(*map(sp.Abs, factors)) - sp.Abs(product)) is True
    assert is_zero(sp.Abs(product) - product) is False


def test_what_holds_on_one_branch_only_is_never_agreed_upon() -> None:
    """Each sign must have been met: a few points, half of which are on the right branch, agree now and then."""
    wrong = abs(x) - x
    for seed in range(600):
        assert agreed(Surface(fields=Fields(seed)), lambda p: p.is_zero(wrong), [wrong], lambda zero: not zero) is False


def test_the_signs_that_count_are_those_of_the_points_evaluated() -> None:
    wrong = abs(x) - x
    for seed in range(150):
        surface = Surface(fields=Fields(seed))

        def redrawn(p: Point) -> Point:
            return p.redrawn([x])

        assert agreed(surface, lambda p: p.is_zero(wrong), [wrong], lambda zero: not zero, redrawn) is False


def test_many_signs_are_each_met_both_ways_in_few_points() -> None:
    """All 2^9 patterns would take hundreds of points; a term depends on its own sign."""
    letters = sp.symbols("a1:10", real=True)
    right, wrong = sp.Add(*map(abs, letters)), letters[4] - abs(letters[4])
    for seed in range(40):
        number = 0

        def vanishes(p: Point) -> bool:
            nonlocal number
            number += 1
            return p.is_zero(wrong)

        surface = Surface(fields=Fields(seed))
        assert agreed(surface, vanishes, [right, wrong], lambda zero: not zero) is False
        assert agreed(surface, lambda p: p.is_zero(sp.S.Zero), [right]) is True
        assert number <= 40
