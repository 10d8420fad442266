"""The numbers of points keep the relations that the arguments for them need."""

from __future__ import annotations

from lagrange.algebra.exact import points_needed as n


def test_more_doubt_asks_for_more_points() -> None:
    assert 1 < n.ZERO_POINTS < n.ZERO_POINTS_AFTER_ROOTS
    assert n.AGREEMENT_POINTS < n.AGREEMENT_POINTS_WITH_SIGNS
    assert n.FLAG_POINTS < n.FLAG_POINTS_AFTER_ROOTS < n.FLAG_POINTS_WITH_SIGNS
    assert n.NONZERO_DIGITS < n.ZERO_DIGITS < n.REAL_DIGITS  # a zero leaves twenty digits for rounding


def test_few_signs_are_all_tried() -> None:
    assert 2**n.FEW_SIGNS * n.AGREEMENT_POINTS_WITH_SIGNS <= n.MOST_POINTS_FOR_FEW_SIGNS
