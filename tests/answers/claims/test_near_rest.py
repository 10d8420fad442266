"""States of rest in numbers, and the exponents of small motions about them."""

from __future__ import annotations

import math

import pytest

from lagrange.answers.claims.near_rest import near_rest
from tests.support.shared import solved


def test_a_bead_in_a_turning_tube() -> None:
    """r = k a/(k − m Ω²), and ω² = k/m − Ω²."""
    system = near_rest(solved("bead-in-a-turning-tube"))
    assert system is not None
    values = {"m": 1.3, "k": 5.0, "a": 0.7, "Omega": 1.1}
    known = {s: values[s.name] for e in system.balance for s in e.free_symbols if s.name in values}
    known |= {s: values[s.name] for m in system.matrices for e in m for s in e.free_symbols if s.name in values}
    [state] = system.states(known, [])
    [r] = system.unknown
    assert state[r] == pytest.approx(5 * 0.7 / (5 - 1.3 * 1.21))
    assert max(p.imag for p in system.exponents(state) or []) == pytest.approx(math.sqrt(5 / 1.3 - 1.21))
    assert system.is_stable(state) is True


def test_a_pole_on_a_cart_falls_and_hangs() -> None:
    """x is cyclic; its exponent 0 decides nothing."""
    system = near_rest(solved("pole-on-cart"))
    assert system is not None
    theta = next(q for q in system.unknown if q.name == "theta")
    symbols = {s for m in system.matrices for e in m for s in e.free_symbols} - {*system.unknown}
    states = [*system.states(dict.fromkeys(symbols, 1.0), [])]
    assert {round(abs(s[theta]), 6): system.is_stable(s) for s in states} == {0: False, round(math.pi, 6): True}


def test_statics_has_its_second_variation() -> None:
    system = near_rest(solved("inverted-pendulum-springs"))
    assert system is not None
    assert system.statics


@pytest.mark.parametrize("name", ["ball-with-backspin", "parallel-skates"])
def test_what_has_no_free_coordinates_is_not_linearized(name: str) -> None:
    assert near_rest(solved(name)) is None
