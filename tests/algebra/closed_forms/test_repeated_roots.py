"""Roots that are equal by a relation between roots or sines."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.repeated_roots import with_repeated_roots_apart
from lagrange.algebra.exact.zero_test import is_zero

w = sp.Symbol("w", real=True)
a, b, alpha = sp.symbols("a b alpha", positive=True)
root = sp.sqrt(14)
length = sp.sqrt(a**2 + b**2)


def same(f: sp.Expr, g: sp.Expr) -> bool:
    """Whether two polynomials have the same roots with the same multiplicities."""
    a, b = sp.Poly(f, w), sp.Poly(g, w)
    return a.degree() == b.degree() and is_zero(a.LC() * g - b.LC() * f) is True


@pytest.mark.parametrize(
    ("pieces", "wanted"),
    [
        ([(w**2 - 2 * root * w + 14, 1)], [(w - root, 2)]),
        ([(sp.expand((w - root) ** 3), 1)], [(w - root, 3)]),
        ([(sp.expand((w - root) ** 2 * (w - a)), 2)], [(w - a, 2), (w - root, 4)]),
        ([(w**2 - 2 * length * w + a**2 + b**2, 1)], [(w - length, 2)]),
        ([(w - sp.sin(alpha) ** 2, 1), (w - 1 + sp.cos(alpha) ** 2, 1)], [(w - sp.sin(alpha) ** 2, 2)]),
        ([(w**2 - 2 * root * w + 13, 1)], [(w**2 - 2 * root * w + 13, 1)]),  # √14 ± 1
        ([(w - root, 1), (w - a, 2)], [(w - root, 1), (w - a, 2)]),
    ],
)
def test_equal_roots_are_one(pieces: list[tuple[sp.Expr, int]], wanted: list[tuple[sp.Expr, int]]) -> None:
    found = with_repeated_roots_apart(pieces, w)
    assert len(found) == len(wanted)
    for f, n in wanted:
        assert any(n == m and same(f, g) for g, m in found)
