"""Exterior products against determinants."""

from __future__ import annotations

from itertools import combinations

import sympy as sp

from lagrange.algebra.forms.exact_forms import one_form, wedge


def test_a_product_of_one_forms_has_the_minors_as_coefficients() -> None:
    rows = sp.Matrix(3, 4, lambda i, j: sp.Symbol(f"a{i}{j}"))
    a, b, c = (one_form(list(rows.row(k))) for k in range(3))
    product = wedge(wedge(a, b), c)
    assert set(product) == set(combinations(range(4), 3))
    for columns, coefficient in product.items():
        assert sp.expand(coefficient - rows.extract([0, 1, 2], list(columns)).det()) == 0


def test_a_form_times_itself_is_zero() -> None:
    a = one_form(sp.symbols("x y z"))
    assert all(sp.expand(c) == 0 for c in wedge(a, a).values())


def test_zero_coefficients_are_left_out() -> None:
    assert one_form([sp.S.Zero, sp.S.One]) == {(1,): 1}
