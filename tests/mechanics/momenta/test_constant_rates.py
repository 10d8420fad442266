"""A constant rate from the conditions of a steady motion."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.momenta.constant_rates import condition_for_rate, have_several

a, g, r, l, k = sp.symbols("a g r l k", positive=True)
phi, psi = sp.symbols("phi' psi'", real=True)


def test_a_condition_linear_in_a_rate_gives_it() -> None:
    condition, solved = condition_for_rate([a * phi * psi - g], [phi, psi], complete=True)
    assert condition == a * phi * psi - g
    assert solved == {phi: g / (a * psi)}


def test_the_square_of_a_rate_is_used_where_the_position_is_not_found() -> None:
    condition = a * phi**2 - g
    assert condition_for_rate([condition], [phi], complete=True)[1] is None
    assert condition_for_rate([condition], [phi], complete=False)[1] == {phi: sp.sqrt(g / a)}


def test_one_of_several_conditions_gives_a_rate_that_no_other_contains() -> None:
    with_rate, other = r * phi**2 - k, r - l
    assert condition_for_rate([other, with_rate], [phi], complete=False) == (with_rate, {phi: sp.sqrt(k / r)})
    assert condition_for_rate([with_rate, with_rate + g], [phi], complete=False) == (0, None)


def test_several_rates() -> None:
    assert have_several([a * phi * psi - g], [phi, psi])
    assert not have_several([a * phi**2 - g], [phi, psi])
