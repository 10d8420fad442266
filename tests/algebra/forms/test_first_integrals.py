"""Combinations of functions that are constant under constraints."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.forms.first_integrals import combined, integral_candidates, is_variable, without_constants
from lagrange.core.symbols import Slots, t

x, y, theta = sp.symbols("x y theta", real=True)
R, b = sp.symbols("R b", positive=True)
SLOTS = Slots((x, y, theta))


def test_what_is_no_constant() -> None:
    assert is_variable(R * x, SLOTS)
    assert is_variable(t, SLOTS)
    assert not is_variable(R * b, SLOTS)
    assert without_constants(2 * R * x * sp.sin(theta), SLOTS) == x * sp.sin(theta)


def test_equal_coefficients_are_in_brackets() -> None:
    assert combined([x, y, theta], {0: R, 1: -R, 2: -2 * b}) == R * (x - y) - 2 * b * theta


def test_the_dictionary_has_what_rolling_needs() -> None:
    rolling = [[sp.S.One, sp.S.Zero, -R, sp.S.Zero]]  # dx − R dθ
    *_, all_of_them = integral_candidates(rolling, SLOTS, {})
    assert {x, theta} <= {*all_of_them}
