"""Where an impulse vanishes, and that the place exists."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.momenta.vanishing_impulses import Vanishing, vanishings

a, b, l, h, R, J = sp.symbols("a b l h R J", positive=True)


def test_the_centre_of_percussion() -> None:
    assert [*vanishings(J * (3 * a - 2 * l) / (2 * l), [sp.S.One, l / 2])] == [Vanishing(3 * a, 2 * l, turns=True)]


def test_an_even_power_keeps_the_sense() -> None:
    [found] = vanishings(J * (a - l) ** 2 / l**2, [])
    assert not found.turns


def test_what_cannot_vanish_or_would_need_an_imaginary_position_is_not_a_place() -> None:
    assert not [*vanishings(J * (a + l) / l, [])]
    assert [*vanishings(J * (2 * h - 3 * R) / R, [sp.sqrt(2 * h * R - h**2)])]
    assert not [*vanishings(J * (2 * h - 5 * R) / R, [sp.sqrt(2 * h * R - h**2)])]
