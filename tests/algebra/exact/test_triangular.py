"""Constraints in an order in which they can be solved: folding linkages, contradictions, few draws."""

from __future__ import annotations

from itertools import pairwise

import pytest
import sympy as sp

from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.solved_blocks import SolvedBlock
from lagrange.algebra.exact.zero_test import Fields, Surface, has_real_point
from tests.algebra.exact.test_sampler import (
    alpha,
    cos,
    l,
    phi,
    psi,
    sin,
    theta,
    u,
    x,
    y,
    z,
)


def test_more_equations_than_unknowns() -> None:
    """Newton's iteration finds the point that two unknowns have in common in forty equations, and none in forty-one."""
    lines = [n * (sp.exp(x) - 2) + (n**2 - 5) * (sp.exp(y) - x - 3) for n in range(40)]
    common, none = Surface(lines, [x, y]), Surface([*lines, sp.exp(x + y) + 1], [x, y])
    assert has_real_point(common)
    point = common.real_point()
    assert point.arithmetic.vanishes(point.value(sp.exp(x) - 2))
    assert not has_real_point(none)


@pytest.mark.parametrize(
    ("constraints", "expected"),
    [
        ([x, x - 1], (0, 1)),
        ([y, x, x - 1], (1, 2)),
        ([x**2 + y**2 - l**2, z, x**2 + y**2 - 2 * l**2], (0, 2)),
        ([x - y, y - z, x - z - 1], (0, 1, 2)),
        ([x - u, x - u - 1], (0, 1)),
        ([x, x - alpha], (0, 1)),
        ([y, sp.Integer(1)], (1,)),
        ([x**2 + y**2 - l**2, x - l], ()),
        ([x + sin(x) - y - cos(y)], ()),
    ],
)
def test_contradictions_are_named(constraints: list[sp.Expr], expected: tuple[int, ...]) -> None:
    assert Surface(constraints, [x, y, z]).contradictory() == expected


def test_points_need_no_more_draws_than_constraints() -> None:
    """Each circle halves the points; drawing all of them again would take 2^12 attempts."""
    qs = [sp.symbols(f"a{n} b{n}", real=True) for n in range(12)]
    ends = [(sp.S.Zero, sp.S.Zero), *qs]
    rods = [(a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 - l**2 for a, b in pairwise(ends)]
    surface = Surface(rods, [q for pair in qs for q in pair])
    assert surface.point().values(rods) == [0] * 12
    assert surface.rank([[e.diff(q) for pair in qs for q in pair] for e in rods]) == 12


def test_a_linkage_that_folds() -> None:
    """In a parallelogram on a side of 3, α = γ is one component; the other one, crossed, has sin(α − γ) ≠ 0."""
    bars = [cos(theta) + 3 * cos(phi) - cos(psi) - 3, sin(theta) + 3 * sin(phi) - sin(psi)]
    for seed in range(20):
        surface = Surface(bars, [theta, phi, psi], fields=Fields(seed))
        assert surface.is_zero(sin(theta - phi) / sin(theta - psi)) is False


@pytest.mark.parametrize(("number", "exact"), [(2, True), (6, False)])
def test_many_lengths_of_the_same_coordinates_have_real_points(number: int, exact: bool) -> None:
    """In a field six roots exist at one of 64 points, each drawn as a whole: a platform on six legs took minutes."""
    lengths = sp.symbols(f"s:{number}", positive=True)
    legs = [s - sp.sqrt((x - n) ** 2 + (y + n**2) ** 2 + l**2) for n, s in enumerate(lengths)]
    surface = Surface(legs, [x, y, *lengths], fields=Fields(1))
    assert surface.exact is exact
    assert all(surface.is_zero(s**2 - (x - n) ** 2 - (y + n**2) ** 2 - l**2) for n, s in enumerate(lengths))
    assert surface.rank([[sp.diff(f, q) for q in (x, y, *lengths)] for f in legs]) == number
    assert surface.contradictory() == ()


def test_a_block_that_is_never_solved_is_given_up_early(monkeypatch: pytest.MonkeyPatch) -> None:
    """x = R + a and x = 0 for positive R and a: each draw already tries R = −a a hundred times."""
    tries = 0
    solve = SolvedBlock.solve

    def counted(block: SolvedBlock, point: Point) -> int:
        nonlocal tries
        tries += 1
        return solve(block, point)

    monkeypatch.setattr(SolvedBlock, "solve", counted)
    a, r = sp.symbols("a R", positive=True)
    assert not has_real_point(Surface([x - r - a, x], [x, y]))
    assert 1000 < tries < 10_000
