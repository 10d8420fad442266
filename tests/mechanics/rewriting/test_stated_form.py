"""Equations of motion in the form of the answers: the same equations, whose factors follow."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.rewriting.stated_form import in_stated_form, substituted_at_once
from tests.mechanics.rewriting.test_combinations import symbol, view_of


@pytest.mark.parametrize("times", ["2 l**2", "-1/l", "1 + sin(theta)**2"])
def test_what_is_divided_out_follows_the_form(times: str) -> None:
    view = view_of("ex11-ideal-pendulum")
    motion = view.motion
    assert motion is not None
    l, theta = symbol(view, "l"), symbol(view, "theta")
    c = {"2 l**2": 2 * l**2, "-1/l": -1 / l, "1 + sin(theta)**2": 1 + sp.sin(theta) ** 2}[times]
    [old] = motion.final
    restated = in_stated_form(view, ((sp.expand(c * old.expression), sp.S.Zero),))
    assert restated is not None
    assert restated.motion is not None
    assert restated.conserved is not None
    [new] = restated.motion.final

    def coefficient(e: object) -> sp.Expr:
        return e.expression * e.factor.expression * (-1 if e.reversed else 1)  # type: ignore[attr-defined, no-any-return]

    assert is_zero(coefficient(new) - coefficient(old)) is True
    assert view.conserved is not None
    for after, before in zip(restated.conserved.integrals, view.conserved.integrals, strict=True):
        assert is_zero(after.multipliers[0] * new.expression - before.multipliers[0] * old.expression) is True


def _none(view: InCoordinates, e: sp.Expr) -> bool:
    return in_stated_form(view, ((e, sp.S.Zero),)) is None


def test_nothing_else_is_taken() -> None:
    """Another equation, one times what may vanish, and too many."""
    view = view_of("ex11-ideal-pendulum")
    assert view.motion is not None
    [e] = view.motion.expressions
    g, theta = symbol(view, "g"), symbol(view, "theta")
    assert _none(view, e + g)
    assert _none(view, sp.expand(e * sp.cos(theta)))
    assert in_stated_form(view, ((e, sp.S.Zero), (e, sp.S.Zero))) is None


def test_sides_stay_as_they_are_stated() -> None:
    view = view_of("bead-in-a-turning-tube")
    assert view.motion is not None
    [e] = view.motion.expressions
    left = e.coeff(symbol(view, "r''")) * symbol(view, "r''")
    restated = in_stated_form(view, ((left, left - e),))
    assert restated is not None
    assert restated.motion is not None
    assert restated.motion.final[0].sides == (left, left - e)


@pytest.mark.parametrize("name", ["cylinder-on-wedge", "cylinder-on-rough-incline"])
def test_rates_of_rolling_put_in_at_once(name: str) -> None:
    """The coefficients of the displacements with the rates in them; integrals are multiples of the new equations."""
    view = view_of(name)
    short = substituted_at_once(view)
    assert short is not None
    assert short.motion is not None
    assert short.conserved is not None
    slots = view.configuration.slots
    closed = short.motion.closed
    assert closed is not None
    assert closed.at_once
    for integral in short.conserved.integrals:
        total = sum(m * e.expression for m, e in zip(integral.multipliers, closed.equations, strict=True))
        rate = slots.time_derivative(integral.expression).xreplace(dict(closed.rates))
        assert is_zero(sp.expand(total.xreplace(dict(closed.rates)) - rate)) is True


def test_without_rates_there_is_nothing_to_put_in() -> None:
    assert substituted_at_once(view_of("ex11-ideal-pendulum")) is None
