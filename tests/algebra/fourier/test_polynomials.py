"""Packed exponents, and what monomials have in common."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from lagrange.algebra.fourier.polynomials import (
    Polynomial,
    common,
    factorization,
    lowest,
    pack,
    part_at,
    shared,
    unpack,
    value_at_place,
)

l, m, M, a, omega = sp.symbols("l m M a omega", positive=True)
numbers = st.integers(-1000, 1000)


@given(st.lists(numbers, max_size=6), st.lists(numbers, max_size=6))
def test_packing(one: list[int], two: list[int]) -> None:
    p, q = pack(enumerate(one)), pack(enumerate(two))
    assert [value_at_place(p, i) for i in range(len(one))] == one
    assert dict(unpack(p)) == {i: n for i, n in enumerate(one) if n}
    width = max(len(one), len(two))
    padded = [v + [0] * (width - len(v)) for v in (one, two)]
    assert [value_at_place(p + q, i) for i in range(width)] == [a + b for a, b in zip(*padded, strict=True)]
    assert [value_at_place(lowest((p, q)), i) for i in range(width)] == [
        min(pair) for pair in zip(*padded, strict=True)
    ]


def test_common_monomials() -> None:
    def monomial(*exponents: int) -> int:
        return pack(enumerate(exponents))

    assert common((monomial(2, -1, 3), monomial(1, -2, 0))) == monomial(1, -1, 0)
    assert common((monomial(2, -1), monomial(-1, 1))) == 0
    assert shared(monomial(2, -1, 3), monomial(1, -2, 1)) == monomial(1, 0, 1)


def polynomial(*terms: tuple[tuple[int, ...], int]) -> Polynomial:
    return {pack(enumerate(exponents)): Fraction(c) for exponents, c in terms}


def test_known_factors_are_divided_out_as_often_as_they_divide() -> None:
    square, sum_ = polynomial(((2, 0), 1), ((1, 1), 2), ((0, 2), 1)), polynomial(((1, 0), 1), ((0, 1), 1))
    assert factorization(square, [sum_]) == (1, [(sum_, 2)])


def test_division_by_known_factors_comes_to_an_end() -> None:
    """A base with negative exponents, 1 + x²/y², divided without end, as any number would."""
    circle = polynomial(((2, 0), 1), ((0, 2), 1))
    for base in (polynomial(((0, 0), 1), ((2, -2), 1)), polynomial(((0, 0), 1)), polynomial(((0, 0), 2))):
        assert factorization(circle, [base]) == (1, [(circle, 1)])


@given(st.lists(numbers, min_size=1, max_size=6), st.sets(st.integers(0, 5)))
def test_values_at_some_places(values: list[int], places: set[int]) -> None:
    places = {i for i in places if i < len(values)}
    taken = part_at(places, len(values))(pack(enumerate(values)))
    assert taken == pack((i, n) for i, n in enumerate(values) if i in places)
