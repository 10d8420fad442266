"""Polynomials in the velocities: squares, and where they vanish.

The records of how a constraint is reduced.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.forms.velocity_polynomials import (
    Alternative,
    Alternatives,
    Reduction,
    Why,
    degree,
    is_affine,
    is_definite,
    polynomial,
    polynomial_as_sum,
    squares,
    without_content,
)
from lagrange.core.symbols import Slots

u, v, w = sp.symbols("x' y' z'", real=True)
x, r = sp.Symbol("x", real=True), sp.Symbol("r", positive=True)


def is_zero(e: sp.Expr) -> bool:
    return sp.expand(e) == 0


def test_exponents_and_coefficients() -> None:
    p = polynomial(x * u**2 - 2 * u * v + 3, (u, v), is_zero)
    assert p == {(2, 0): x, (1, 1): -2, (0, 0): 3}
    assert degree(p) == 2
    assert sp.expand(polynomial_as_sum(p, (u, v)) - (x * u**2 - 2 * u * v + 3)) == 0
    assert polynomial(sp.sin(u), (u,), is_zero) is None


@pytest.mark.parametrize(
    ("form", "definite"),
    [(u**2 + v**2, True), (u**2 - v**2, False), (u**2 + u * v + v**2, True), (u**2 + 2 * u * v + v**2, False)],
)
def test_a_definite_form_is_zero_at_zero_only(form: sp.Expr, definite: bool) -> None:
    p = polynomial(form, (u, v), is_zero)
    assert p is not None
    assert is_definite(p) is definite


@pytest.mark.parametrize("form", [u**2 + v**2 - 2 * u * v, u * v, u**2 + 4 * u * v + v**2 + w**2, x * u**2 + u])
def test_a_sum_of_squares_is_the_same_polynomial(form: sp.Expr) -> None:
    p = polynomial(form, (u, v, w), is_zero)
    assert p is not None
    found = squares(p, (u, v, w), is_zero)
    if found is not None:
        assert sp.expand(sum(s.factor * s.form**2 for s in found) - form) == 0


def test_rank_one_is_one_square_and_common_denominators_go() -> None:
    p = polynomial(u**2 + v**2 - 2 * u * v, (u, v), is_zero)
    assert p is not None
    assert len(squares(p, (u, v), is_zero) or ()) == 1
    assert without_content(u / r + v / r) == u + v


# -- Whether a function is affine in the velocities --------------------------------------------------------------------


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


# Reductions


x_reductions, y_reductions = sp.symbols("x' y'", real=True)


def test_nothing_satisfies_a_constraint_without_alternatives() -> None:
    assert Alternatives(()).members == ()
    step = Reduction((x_reductions - y_reductions) ** 2, next(iter(Why)), (x_reductions - y_reductions,))
    assert Alternatives((Alternative(step.forms, (step,)),)).members[0].forms == (x_reductions - y_reductions,)
    assert (step.conditions, step.excluded) == ((), ())
    assert len({w.value for w in Why}) == len(Why)
