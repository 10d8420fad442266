"""Packed exponents, and what monomials have in common."""

from __future__ import annotations

import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from lagrange.algebra.fourier.polynomials import common, lowest, pack, place, shared, unpack

l, m, M, a, omega = sp.symbols("l m M a omega", positive=True)
numbers = st.integers(-1000, 1000)


@given(st.lists(numbers, max_size=6), st.lists(numbers, max_size=6))
def test_packing(one: list[int], two: list[int]) -> None:
    p, q = pack(enumerate(one)), pack(enumerate(two))
    assert [place(p, i) for i in range(len(one))] == one
    assert dict(unpack(p)) == {i: n for i, n in enumerate(one) if n}
    width = max(len(one), len(two))
    padded = [v + [0] * (width - len(v)) for v in (one, two)]
    assert [place(p + q, i) for i in range(width)] == [a + b for a, b in zip(*padded, strict=True)]
    assert [place(lowest((p, q)), i) for i in range(width)] == [min(pair) for pair in zip(*padded, strict=True)]


def test_common_monomials() -> None:
    def monomial(*exponents: int) -> int:
        return pack(enumerate(exponents))

    assert common((monomial(2, -1, 3), monomial(1, -2, 0))) == monomial(1, -1, 0)
    assert common((monomial(2, -1), monomial(-1, 1))) == 0
    assert shared(monomial(2, -1, 3), monomial(1, -2, 1)) == monomial(1, 0, 1)
