"""Factors in front of sums."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.mechanics.rewriting.factors import (
    has_common_factor,
    has_one_sign,
    in_cotangents,
    in_factors,
    in_factors_where,
    letter_for,
    vector_with_factor,
    with_common_factor,
    with_factor,
    with_like_terms,
    with_signs,
    with_terms_added,
    with_turned_sum,
    without_constant_factors,
    without_shared_constant,
)

a, b, J = sp.symbols("a b J", positive=True)
x, y = sp.symbols("x y", real=True)


def test_the_shorter_form() -> None:
    assert in_factors(a * x + a * y) == a * (x + y)
    assert in_factors(x**2 + y) == x**2 + y


def test_factors_in_front() -> None:
    assert with_common_factor(a * x + a * y) == a * (x + y)
    assert with_factor(J * x + J * y, J) == J * (x + y)
    assert vector_with_factor(Vector((J * x, J * y, sp.S.Zero)), J) == J * Vector((x, y, sp.S.Zero)).as_sum()
    assert (has_common_factor(a * x + a * y), has_common_factor(x + y)) == (True, False)
    assert in_factors_where(x**2 - y**2, {y: x + a}) == -a * (a + 2 * x)


@pytest.mark.parametrize(
    ("e", "left"),
    [(a * x + a * y, x + y), (x * y + x, x * y + x), ((a - b) * x + (a - b) * y, (a - b) * (x + y)), (a * x, x)],
)
def test_only_constants_that_differ_from_zero_are_dropped(e: sp.Expr, left: sp.Expr) -> None:
    """a may be dropped from a x + a y = 0, but not a − b, which may be zero."""
    assert sp.expand(without_constant_factors(e, {x, y}) - left) == 0


def test_signs() -> None:
    assert letter_for(a * (a + b), "D").is_positive
    assert letter_for(a - b, "D").is_positive is None
    assert has_one_sign(-a - x**2)
    assert not has_one_sign(x)


def test_forms_without_shared_constants() -> None:
    """−l sin ψ dx − l² cos²ψ dψ = 0 is sin ψ dx + l cos²ψ dψ = 0; signs that differ stay."""
    k, psi = sp.Symbol("k", positive=True), sp.Symbol("psi", real=True)
    form = (-k * sp.sin(psi), -(k**2) * sp.cos(psi) ** 2, sp.S.Zero)
    assert without_shared_constant(form) == (sp.sin(psi), k * sp.cos(psi) ** 2, 0)
    mixed = (-sp.sin(psi), k * sp.cos(psi))
    assert without_shared_constant(mixed) == mixed


def test_a_sum_takes_the_sign_of_its_product() -> None:
    a, b, c, W = sp.symbols("a b c W", positive=True)
    pairs = {
        -W * (a - b): W * (b - a),
        -c - W * (a - b): -c + W * (b - a),
        -W / (a - b): W / (b - a),
        W / (a - b - c): -W / (b + c - a),
    }
    for before, after in pairs.items():
        turned = with_turned_sum(before)
        assert turned == after
        assert sp.cancel(turned - before) == 0
    assert str(with_turned_sum(-sp.sin(a - b) * W)) == "W*sin(-a + b)"
    for kept in (-W * (a + b), -W * (a + b - c), -W * (a - b) ** 2, W * (a - b), -W / (a + b), a - b, c - W * (a - b)):
        assert with_turned_sum(kept) is kept


def test_nothing_is_multiplied_out() -> None:
    a, b = sp.symbols("a b", positive=True)
    assert with_turned_sum(sp.Mul(-2, a - b, evaluate=False)).args == (2, b - a)
    assert with_turned_sum(sp.Mul(-2, a, a - b, evaluate=False)).args == (2, a, b - a)


def test_terms_that_differ_in_a_letter_are_one() -> None:
    M, m, g, c, l, x = sp.symbols("M m g c l x", positive=True)
    letters = {M, m, g, c, l}
    root = sp.sqrt((M * g + m * g + c * l) ** 2 - 4 * M * c * g * l)
    assert with_like_terms(M * g + m * g + c * l - root, letters) == (M + m) * g + c * l - sp.sqrt(
        ((M + m) * g + c * l) ** 2 - 4 * M * c * g * l
    )
    for kept in (M + m, M * g + 2 * m * g * l, M * x + M * x**2, M * g + c * l):
        assert with_like_terms(kept, letters) == kept
    assert sp.expand(with_like_terms(M * g * l - m * g * l + c, letters) - (M * g * l - m * g * l + c)) == 0


def test_cotangents() -> None:
    theta, n, w = sp.symbols("theta N W", real=True)
    cot = sp.cot(theta)
    assert in_cotangents(w / 2 - n * sp.cos(theta) / sp.sin(theta)) == w / 2 - n * cot
    for other in (sp.cos(theta) ** 2 / sp.sin(theta), sp.cos(theta) / sp.sin(2 * theta), sp.cos(theta) * sp.sin(theta)):
        assert in_cotangents(other) == other


def test_the_sign_of_what_is_divided_by() -> None:
    s, m = sp.symbols("s m", real=True)
    e = m * sp.Abs(sp.cos(s)) / sp.cos(s)
    found, nonzero = with_signs(e)
    assert nonzero == (sp.cos(s),)
    assert found == m * sp.sign(sp.cos(s))
    for other in (m * sp.Abs(sp.cos(s)), sp.Abs(sp.sin(s)) / sp.cos(s), m + s):
        assert with_signs(other) == (other, ())


def test_like_terms_of_products_are_added_and_other_products_stay() -> None:
    A, B, x, y, z = sp.symbols("A B x y z", real=True)
    assert with_terms_added(A * (x + y) + A * y - B * z) == A * x + 2 * A * y - B * z
    kept = A * (x + y) + B * (x + z)
    assert with_terms_added(kept) == kept
