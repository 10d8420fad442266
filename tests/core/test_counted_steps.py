"""Work in which SymPy puts no sums and products together."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import pytest
import sympy as sp

from lagrange.core.effort import GivenUpError, allowed

x, y = sp.symbols("x y", positive=True)


def twice(depth: int) -> sp.Expr:
    """An expression of few parts, of which each occurs twice in the next."""
    e = x
    for _ in range(depth):
        e = sp.Function("f")(e, e)
    return e


def units(work: Callable[[], object]) -> float:
    with allowed(10**9) as allowance:
        work()
    return allowance.units - allowance.left


def test_walks_are_counted_by_occurrences() -> None:
    small, large = (units(partial(twice(n).replace, sp.sin, sp.cos)) for n in (10, 12))
    assert 3 < large / small < 5
    assert large > 300
    with pytest.raises(GivenUpError), allowed(1_000):
        twice(40).replace(sp.sin, sp.cos)


def test_polynomials_are_counted() -> None:
    short, long = (sp.Poly((x + y + 1) ** n * (x - y) ** 3, x, y) for n in (1, 12))
    assert units(lambda: long.sqf_list()) > 4 * units(lambda: short.sqf_list()) > 100


def test_long_numbers_are_counted() -> None:
    ones = sp.Poly([1] * 200, x)
    short, long = (units(lambda a=a: ones.eval(a)) for a in (3, 2**4000))
    assert long > 10 * short


def test_signs_and_numbers_are_counted() -> None:
    a, b = sp.symbols("a b", real=True)
    assert units(lambda: [((a + n) ** 2 + b * n).is_positive for n in range(200)]) > 500
    number = sum(sp.sqrt(n) for n in range(2, 400))
    assert units(lambda: number.evalf(50)) > 300
