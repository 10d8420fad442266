"""Inequalities that are linear in unknown forces, solved by elimination."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.equilibrium.friction.linear_inequalities import Signs, in_sines_and_cosines, shortest

W, mu = sp.symbols("W mu", positive=True)
alpha = sp.Symbol("alpha", positive=True)
x = sp.Symbol("x", real=True)


@pytest.mark.parametrize(("e", "sign"), [(W + mu, 1), (-W * mu, -1), (W - mu, None), (sp.S.Zero, 0)])
def test_signs_of_parameters(e: sp.Expr, sign: int | None) -> None:
    assert Signs({W, mu}).of(e) == sign


def test_one_denominator_and_single_angles() -> None:
    assert sp.simplify(in_sines_and_cosines(sp.tan(alpha) + 1) - (sp.sin(alpha) + sp.cos(alpha)) / sp.cos(alpha)) == 0
    assert shortest(sp.sin(alpha) ** 2 * W + sp.cos(alpha) ** 2 * W) == W
