"""Inequalities that are linear in unknown forces, solved by elimination."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.equilibrium.friction.linear_inequalities import (
    Case,
    Inequality,
    NotEliminatedError,
    Signs,
    in_sines_and_cosines,
    shortest,
    solvable,
)

W, mu = sp.symbols("W mu", positive=True)
alpha = sp.Symbol("alpha", positive=True)
x = sp.Symbol("x", real=True)


@pytest.mark.parametrize(("e", "sign"), [(W + mu, 1), (-W * mu, -1), (W - mu, None), (sp.S.Zero, 0)])
def test_signs_of_parameters(e: sp.Expr, sign: int | None) -> None:
    assert Signs({W, mu}).of(e) == sign


def test_one_denominator_and_single_angles() -> None:
    assert sp.simplify(in_sines_and_cosines(sp.tan(alpha) + 1) - (sp.sin(alpha) + sp.cos(alpha)) / sp.cos(alpha)) == 0
    assert shortest(sp.sin(alpha) ** 2 * W + sp.cos(alpha) ** 2 * W) == W


def _rows(*rows: tuple[sp.Expr | int, ...]) -> list[Inequality]:
    """From the coefficients of the unknowns, the constant last."""
    return [Inequality(tuple(map(sp.sympify, row[:-1])), sp.sympify(row[-1])) for row in rows]


def _holds(case: Case, at: dict[sp.Symbol, sp.Expr]) -> bool:
    return (
        all(e.xreplace(at) >= 0 for e in case.slacks)
        and all(e.xreplace(at) > 0 for e in case.positive)
        and all(sp.simplify(e.xreplace(at)) == 0 for e in case.zero)
    )


ONE = [
    _rows((1, 0), (mu - 1, -W)),  # (μ − 1) s ≥ W: not at μ = 1
    _rows((1, 0), (mu - 1, W)),  # (μ − 1) s ≥ −W: everywhere
    _rows((1, x), (mu - 1, x - 1)),  # s ≥ −x, (μ − 1) s ≥ 1 − x: at μ = 1 where x ≥ 1
    _rows((1, 0), (-1, W), (mu - 1, x)),
    _rows((1, 0), (mu**2 - 2 * mu - 1, -W)),  # not at μ = 1 + √2
    _rows((1, 0), (mu**2 + W * mu - 1, x)),
]


@pytest.mark.parametrize("rows", ONE)
def test_limits_of_cases_are_exact(rows: list[Inequality]) -> None:
    """One unknown s, against the bounds of s in numbers: above all where a coefficient vanishes."""
    cases = solvable(rows, Signs(), 2)
    for there in (sp.Rational(1, 2), sp.S.One, sp.Integer(2), 1 + sp.sqrt(2), sp.sqrt(5) / 2 - sp.Rational(1, 2)):
        for value in (-2, 0, 1, 2):
            at = {mu: there, W: sp.S.One, x: sp.Integer(value)}
            bounds = [(sp.expand(i.coefficients[0].xreplace(at)), i.constant.xreplace(at)) for i in rows]
            low = max([-c / a for a, c in bounds if a > 0], default=-sp.oo)
            high = min([-c / a for a, c in bounds if a < 0], default=sp.oo)
            exists = bool(low <= high) and all(c >= 0 for a, c in bounds if a == 0)
            assert not any(case.unexamined for case in cases)
            assert any(_holds(case, at) for case in cases) is exists, at


def test_a_coefficient_whose_zeros_are_not_seen() -> None:
    """sin x − μ³ − μ − x: each case says that this was not examined."""
    coefficient = sp.sin(x) - mu**3 - mu - x
    cases = solvable(_rows((1, 0), (coefficient, -W)), Signs(), 1)
    assert [(c.positive, c.unexamined) for c in cases] == [((coefficient,), (coefficient,))]
    with pytest.raises(NotEliminatedError):
        solvable(_rows((1, 0), (coefficient, -W)), Signs())


def test_a_product_is_seen_where_all_terms_have_one_degree_in_sine_and_cosine() -> None:
    P, Q, m = sp.symbols("P Q m", positive=True)
    s, c = sp.sin(alpha), sp.cos(alpha)
    long = sp.expand((c - m * s) * (P * (c - m * s) - 2 * Q * (s + m * c)) * s)
    long = sp.expand(long.xreplace({2 * Q * s * c**2: 2 * Q * s * (1 - s**2)}))
    assert sp.Mul.make_args(shortest(long)).__len__() >= 3


def test_an_angle_and_its_half_are_written_in_the_half() -> None:
    theta = sp.Symbol("theta", real=True)
    half = theta / 2
    e = shortest(sp.sin(half) * sp.sin(theta) / ((1 + sp.cos(theta)) * sp.cos(half)))
    assert e == sp.sin(half) ** 2 / sp.cos(half) ** 2
    assert Signs({half}).of(sp.tan(half)) == 1


def test_cases_that_differ_by_a_sign_alone_are_one() -> None:
    """s ≥ 0, (1 − m) s ≤ 1 + m: where m ≥ 1 always, and where m < 1 as well, since s = 0 will do; with s ≥ q it is
    (1 − m) q ≤ 1 + m in both."""
    q, m = sp.symbols("q m", positive=True)
    bounds = [Inequality((sp.S.One,), -q), Inequality((m - 1,), 1 + m)]
    cases = solvable(bounds, Signs(), 1)
    assert all(not c.positive and not c.zero for c in cases)
    assert [[sp.factor(e) for e in c.slacks] for c in cases] == [[sp.factor(1 + m - q * (1 - m))]]
