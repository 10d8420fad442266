"""Sizes of expressions, against their trees; shared parts are not walked twice.

Operations, against SymPy's count.
"""

from __future__ import annotations

import time

import pytest
import sympy as sp

from lagrange.core.expression_size import Sizes, count_operations

x, y = sp.symbols("x y", positive=True)


def depth(e: sp.Basic) -> int:
    return 1 + max(map(depth, e.args), default=0)


@pytest.mark.parametrize(
    "e", [x, x + 2 * y, sp.sin(x * y) ** 3, (x + y) ** 2 / 7 - sp.sqrt(x), sp.exp(x) * (y - 1)], ids=str
)
def test_size_and_layers_are_those_of_the_tree(e: sp.Expr) -> None:
    found = Sizes().of(e)
    assert found.size == sum(1 for _ in sp.preorder_traversal(e))
    assert found.layers == depth(e)


@pytest.mark.parametrize(
    "e", [(x + y) ** 3, (x + y) * (x - y), (1 + x) ** 2 * (y + 2), x * y, sp.sin(x) * (x + 1)], ids=str
)
def test_terms_are_not_fewer_than_there_are(e: sp.Expr) -> None:
    assert Sizes().of(e).terms >= len(sp.Add.make_args(sp.expand(e)))


def test_what_an_expression_is() -> None:
    of = Sizes().of
    assert of(sp.Integer(7) ** sp.Rational(1, 2)).is_constant
    assert not of(x + 1).is_constant
    assert of(x**2 + x).symbol == x
    assert of(x**2 + x).degree == 2
    assert of(sp.Integer(2**100)).bits == 101
    assert not of(sp.zoo).is_finite
    assert not of(x + sp.nan).is_finite


def test_shared_parts_cost_nothing_again() -> None:
    e = x
    for n in range(60):
        e = sp.Mul(sp.Add(e, sp.Symbol(f"a{n}")), sp.sin(e), evaluate=False)
    before = time.process_time()
    size = Sizes().of(e).size  # 2^60 nodes, which are not counted further than a thousand million
    assert size >= 10**9
    assert time.process_time() - before < 5


# Operations


a, b, x_operations = sp.symbols("a b x", positive=True)
F = sp.Function("F")


@pytest.mark.parametrize(
    "expression",
    [
        *(
            x_operations,
            sp.S.Zero,
            sp.S.One,
            sp.Rational(-3, 2),
            sp.pi,
            sp.E,
            -x_operations,
            2 * x_operations,
            -x_operations / 2,
            x_operations**2,
            1 / x_operations,
            -1 / x_operations,
            sp.sqrt(x_operations),
        ),
        *(a + b, a - b, -a - b, b - a, -a - b - x_operations, 2 * (a + b), -(a + b), sp.Mul(-1, a + b, evaluate=False)),
        sp.Mul(2, a + b, evaluate=False) / x_operations,
        sp.Mul(-3, a + b, evaluate=False) / (2 * x_operations * (a - b)),
        *(
            a * b / x_operations,
            a / (b * x_operations),
            (a + b) / (a - b),
            3 / (2 * sp.sqrt(x_operations)),
            -sp.sqrt(6) * x_operations / 4,
            (a + b) ** -2,
        ),
        *(
            sp.exp(-x_operations),
            x_operations * sp.exp(-a * x_operations),
            a**x_operations / b,
            a ** (-x_operations) * b,
            sp.E * x_operations,
            1.5 * x_operations,
            x_operations ** sp.Rational(-3, 2),
        ),
        *(
            sp.sin(x_operations) ** 2 * sp.cos(a - b),
            F(x_operations, a) + F(x_operations, a).diff(x_operations),
            sp.Abs(x_operations - a) / a,
            sp.atan2(x_operations, -a),
        ),
        *(sp.oo, sp.nan, sp.I * x_operations, sp.Symbol("m", commutative=False) * x_operations),
    ],
    ids=str,
)
def test_as_many_as_sympy_counts(expression: sp.Expr) -> None:
    assert count_operations(expression) == expression.count_ops()
