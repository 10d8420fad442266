"""Rank, kernel and solutions of linear systems, in residues and in reals."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.algebra.exact.zero_test import InadmissibleError, Point
from tests.support.chance import examples
from tests.support.points import close, field_point, real_point


def test_linear_algebra(point: Point) -> None:
    n = point.number
    rows = [[n(1), n(2), n(3)], [n(2), n(4), n(6)], [n(0), n(1), n(1, 3)]]
    assert point.rank(rows) == 2
    reduced, pivots = point.row_reduced(rows)
    assert pivots == [0, 1]
    assert len(reduced) == 2
    [kernel] = point.nullspace(rows, 3)
    assert all(close(point, sum(a * k for a, k in zip(row, kernel, strict=True)), n(0)) for row in rows)
    found = point.solution(rows, [n(1), n(2), n(5)], [n(7), n(8), n(9)])
    assert found is not None
    assert found[2] == n(9)
    residual = [sum(a * k for a, k in zip(row, found, strict=True)) for row in rows]
    assert all(close(point, r, n(b)) for r, b in zip(residual, (1, 2, 5), strict=True))
    assert point.solution(rows, [n(1), n(3), n(5)]) is None
    assert point.nullspace([], 2) == [[n(1), n(0)], [n(0), n(1)]]


def test_reals_do_not_guess_a_rank() -> None:
    point = real_point()
    nearly = [[point.number(1), point.number(1)], [point.number(1), 1 + point.number(1, 10**50)]]
    with pytest.raises(InadmissibleError):
        point.rank(nearly)
    nearly[1][1] = 1 + point.number(1, 10**30)
    assert point.rank(nearly) == 2
    nearly[1][1] = 1 + point.number(1, 10**70)
    assert point.rank(nearly) == 1


@settings(deadline=None, max_examples=examples(50))
@given(st.lists(st.lists(st.integers(-4, 4), min_size=4, max_size=4), min_size=1, max_size=5))
def test_kernel_and_rank_of_integer_matrices(rows: list[list[int]]) -> None:
    point = field_point()
    values = [[point.number(k) for k in row] for row in rows]
    assert point.rank(values) == sp.Matrix(rows).rank()
    kernel = point.nullspace(values, 4)
    assert len(kernel) == 4 - point.rank(values)
    for vector in kernel:
        assert all(point.arithmetic.reduce(sum(a * k for a, k in zip(r, vector, strict=True))) == 0 for r in values)
