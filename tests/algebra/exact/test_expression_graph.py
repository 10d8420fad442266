"""Expressions of a problem share their nodes, and what is too large or too deep is not evaluated."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import Surface, is_zero
from tests.algebra.exact.test_zero_test import chain

x, y, z, theta, phi, t = sp.symbols("x y z theta phi t", real=True)
sin, cos, tan, sqrt, pi = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi


def raw(function: type, *arguments: sp.Expr) -> sp.Expr:
    return function(*arguments, evaluate=False)


def test_all_expressions_of_a_problem_share_their_nodes() -> None:
    _, derived, textbook = chain(3)
    surface = Surface()
    surface.is_zero(derived[0] - textbook[0])
    nodes = len(surface.graph.operations)
    surface.is_zero(textbook[0] - derived[0] + derived[0] - textbook[0])
    surface.is_zero(derived[0] - textbook[0])
    assert len(surface.graph.operations) == nodes


def test_what_is_too_large_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    assert is_zero(sp.Add(*(sp.Symbol(f"s{i}") for i in range(1500)))) is None
    powers = sp.Add(*(x**i * y**j for i in range(30) for j in range(30)))
    assert is_zero(powers) is False
    monkeypatch.setattr("lagrange.algebra.exact.expression_graph.MOST_NODES", 500)
    assert is_zero(powers) is None


def test_what_is_too_deep_is_undecided() -> None:
    e = x
    for _ in range(3000):
        e = raw(sp.sin, raw(sp.Add, e, 1))
    assert is_zero(e) is None


def test_towers_of_exponentials_are_not_computed() -> None:
    tower = sp.exp(sp.exp(sp.exp(3)))
    assert is_zero(raw(sp.Add, tower, -1)) is None
    assert is_zero(raw(sp.sin, raw(sp.Add, raw(sp.sin, tower), 3))) is None
    assert is_zero(x ** (10**18) - x ** (10**18 + 1) / x) is True
    assert is_zero(raw(sp.Pow, 2, 20000 * x) - 1) in (None, False)


def test_products_in_angles_are_not_multiplied_out() -> None:
    product = sp.Mul(*(sp.Symbol(f"u{i}", real=True) + sp.Symbol(f"v{i}", real=True) for i in range(40)))
    assert is_zero(cos(2 * product) - 2 * cos(product) ** 2 + 1) is True
    assert is_zero(cos((x + y) ** 50) - cos(x)) is False
