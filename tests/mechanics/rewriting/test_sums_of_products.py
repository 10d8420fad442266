"""Polynomials as sums of products, compared with what they were."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.rewriting.sums_of_products import in_products

M, m1, m2, m3, I1, I2, R, r = sp.symbols("M m_1 m_2 m_3 I_1 I_2 R r", positive=True)


@pytest.mark.parametrize(
    ("short", "brackets"),
    [
        ((M - m1) * (m2 + m3) + 4 * m2 * m3, {M - m1, m2 + m3}),
        ((I1 + (M + m1) * R**2) * (I2 + (m2 + m3) * r**2) + 4 * m2 * m3 * r**2 * R**2, {M + m1, m2 + m3}),
        ((M + m1) * (m2 + m3), {M + m1, m2 + m3}),
    ],
)
def test_brackets_that_letters_share(short: sp.Expr, brackets: set[sp.Expr]) -> None:
    found = in_products(sp.expand(short))
    assert sp.expand(found - short) == 0
    assert sp.count_ops(found) <= sp.count_ops(short)
    assert all(found.has(b) or found.has(sp.expand(-b)) for b in brackets)


@pytest.mark.parametrize("e", [M + m1, M**2 + m1 * m2, M * m1 + m2 * m3, sp.sin(M) + m1, sp.Integer(3)])
def test_others_stay(e: sp.Expr) -> None:
    assert in_products(e) == e


def test_inside_of_a_quotient() -> None:
    e = 1 / sp.expand((M + m1) * (m2 + m3) + 4 * m2 * m3)
    found = in_products(e)
    assert sp.count_ops(found) < sp.count_ops(e)
    assert sp.cancel(found - e) == 0
