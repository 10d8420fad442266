"""The allowance of work."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import GaveUpError
from lagrange.core.effort import GivenUpError, allowed, allowed_for, spend, unlimited


def expanded(letters: str) -> sp.Expr:
    a, b, c = sp.symbols(letters)
    return sp.expand((a + b + c) ** 40)


def test_work_beyond_the_allowance_is_given_up() -> None:
    with pytest.raises(GivenUpError), allowed(10):
        [spend(n) for n in (6, 6)]


def test_what_sympy_does_is_counted() -> None:
    with allowed(10**6) as allowance:
        expanded("a0 b0 c0")
    assert 800 < allowance.units - allowance.left < 10**5
    with pytest.raises(GivenUpError), allowed(500):
        expanded("a1 b1 c1")


def test_nothing_takes_it_for_an_error_of_its_own() -> None:
    assert not issubclass(GivenUpError, Exception)


def test_without_an_allowance_nothing_is_counted() -> None:
    spend(1e12)
    expanded("a2 b2 c2")


def test_an_allowance_within_another_has_its_own_units() -> None:
    with allowed(10):
        with allowed(100):
            spend(50)
        spend(9)


def test_the_stage_is_named() -> None:
    with (
        pytest.raises(GaveUpError, match="given up at: the middle, the work allowed") as caught,
        allowed_for("the middle", 1),
    ):
        spend(2)
    assert caught.value.diagnostics[0].code == "given-up"
    with pytest.raises(GaveUpError, match="the end, there is not enough memory"), allowed_for("the end", 1):
        raise MemoryError


def test_allowances_can_be_lifted() -> None:
    with unlimited(), allowed(1):
        spend(1e12)
