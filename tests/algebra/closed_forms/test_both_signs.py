"""Whether an expression takes both signs, seen at points."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.closed_forms.both_signs import takes_both_signs
from lagrange.algebra.closed_forms.signs import (
    sign_of,
)
from tests.algebra.closed_forms.test_signs import a, b, c, x


def test_both_signs_are_seen_at_points_and_one_sign_is_not() -> None:
    long = (a + b) * (a + c) * (b + c) + a * b
    assert takes_both_signs(sp.expand(long - 3 * a * b * c * x)) is True
    assert takes_both_signs(sp.expand(long)) is False
    # where x > 0 it is positive, and points outside are not looked at
    assert takes_both_signs(sp.expand(long * x), (x,)) is False
    assert sign_of(sp.expand(long * x), (x,)) == 1
