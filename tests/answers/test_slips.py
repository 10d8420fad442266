"""Slips in a term of an equation, and the terms that may have been meant."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.slips import cleared, is_decimal, is_divided, terms_of, variants
from lagrange.core.symbols import Slots

x = sp.Symbol("x", real=True)
m, g, k = sp.symbols("m g k", positive=True)
SLOTS = Slots((x,))
[a] = SLOTS.accelerations


def test_terms() -> None:
    assert set(terms_of(m * (a + g) - k * x) or ()) == {m * a, m * g, -k * x}
    assert cleared(a + g / (1 + x)) is not None
    assert cleared(a + g) is None
    assert is_divided(g / (1 + x))
    assert not is_divided(g / 2)


@pytest.mark.parametrize("meant", [m * x, g * x, k * a])
def test_another_letter_is_among_the_slips(meant: sp.Expr) -> None:
    assert meant in {e for _, e in variants(k * x, SLOTS, (m, g, k), ())}


@pytest.mark.parametrize(("term", "measured"), [(sp.Rational(981, 100) * m, True), (m / 2, False), (10 * m, True)])
def test_numbers_that_look_measured(term: sp.Expr, measured: bool) -> None:
    assert is_decimal(term) is measured
