"""Candidates for the factors of an integrating factor."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.forms.factor_candidates import (
    FactorCandidate,
    OneForm,
    common_divisor,
    factor_candidates,
    factored,
)
from lagrange.core.symbols import Slots

x, y, z = sp.symbols("x y z", real=True)
a = sp.Symbol("a", positive=True)


def form(*coefficients: sp.Expr) -> OneForm:
    variables = (x, y, z)[: len(coefficients)]
    return OneForm.of(coefficients, variables, Slots(variables))


def test_variables_that_do_not_occur_are_left_out() -> None:
    omega = form(x, sp.S.Zero, -z)
    assert omega.variables == (x, z)
    assert form(y, -x).curl(0, 1) in (2, -2)  # ∂a_j/∂q_i − ∂a_i/∂q_j of y dx − x dy
    assert omega.coefficients == (x, -z)


def test_a_common_divisor_without_numbers_and_parameters() -> None:
    assert common_divisor(form(2 * a * y * (x + y), -2 * a * x * (x + y))) in (x + y, -x - y)


def test_the_factor_of_polar_angles_is_a_product_of_candidates() -> None:
    functions = {c.function for c in factor_candidates(form(y, -x)) if not c.in_exponent}
    assert {x, y} <= functions  # 1/x², 1/y², 1/(x y) make y dx − x dy exact


def test_powers() -> None:
    assert FactorCandidate(x).power(sp.Integer(-2)) == x**-2
    assert FactorCandidate(x, in_exponent=True).power(sp.Integer(3)) == sp.exp(3 * x)
    assert factored(x**2 - y**2) == (x - y) * (x + y)
