"""Whether a function is affine in the velocities."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.forms.affine import is_affine
from lagrange.core.symbols import Slots

x, y, a = sp.symbols("x y a", real=True)
slots = Slots((x, y))
u, v = slots.velocities

AFFINE = [
    a,
    u * sp.sin(x) + y * v - 1,
    (u + v) ** 2 - u**2 - 2 * u * v - v**2 + u,
    (u + 1) * (v + 1) - u * v,
    sp.sin(u) * (x + y) - x * sp.sin(u) - y * sp.sin(u) + v,
    (u + sp.sqrt(x) * v) * (u - sp.sqrt(x) * v) - u**2 + x * v**2 + v,
]
NOT_AFFINE = [u**2, u * v, sp.sin(u), u / (1 + v), sp.sqrt(u), sp.exp(u) + v, (u + v) ** 2 - u**2 - v**2, x**u, abs(u)]


@pytest.mark.parametrize("f", AFFINE, ids=str)
def test_affine(f: sp.Expr) -> None:
    assert is_affine(f, slots)


@pytest.mark.parametrize("f", NOT_AFFINE, ids=str)
def test_not_affine(f: sp.Expr) -> None:
    assert not is_affine(f, slots)


def test_nothing_is_multiplied_out() -> None:
    """Twenty factors of four terms have 4^20 terms; twenty functions inside one another have as long a derivative."""
    product = sp.Mul(*(sp.sin(n * x) + sp.cos(y + n) + a + n for n in range(20)), evaluate=False)
    assert is_affine(product * u + product * v, slots)
    assert not is_affine(product * u * v, slots)
    nested = u
    for _ in range(40):
        nested = sp.atan2(nested, v)
    assert not is_affine(nested + x, slots)
