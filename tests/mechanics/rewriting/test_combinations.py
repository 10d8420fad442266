"""Stated equations as sums of multiples of the equations of motion, tried in numbers."""

from __future__ import annotations

from functools import cache

import pytest
import sympy as sp

from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.rewriting.combinations import combinations
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load
from tests.support.shared import SHIPPED


@cache
def view_of(name: str) -> InCoordinates:
    return solve(load(str(SHIPPED[name]))).chosen


def symbol(view: InCoordinates, name: str) -> sp.Symbol:
    assert view.motion is not None
    return next(s for e in view.motion.final for s in e.expression.free_symbols if s.name == name)


def test_the_machine_of_appell_and_hamel() -> None:
    """z'' = −g/(1 + a²) is ẏ/(ẋ ż) (13) + (1/ẋ) (14) − (1/(2ż)) d/dt(ẋ² + ẏ² − a² ż²), over 1 + a²; in numbers."""
    view = view_of("appell-hamel")
    a, g = (symbol(view, n) for n in ("a", "g"))
    stated = ((symbol(view, "z''"), -g / (1 + a**2)),)
    [found] = combinations(stated, view)
    x, y, z = (symbol(view, n) for n in ("x'", "y'", "z'"))
    state = {x: sp.Rational(3, 5), y: sp.Rational(6, 5), a: sp.Rational(1, 2), g: 10}
    state[z] = sp.sqrt(state[x] ** 2 + state[y] ** 2) / state[a]
    values = [float(m.xreplace(state)) for m in (*found.equations, *found.constraints)]
    over = 1 + 0.25
    expected = [float(state[y] / (state[x] * state[z])) / over, 1 / 0.6 / over, -1 / (2 * float(state[z])) / over]
    assert values == pytest.approx(expected)
    assert found.with_constraints


def test_a_multiple_of_the_only_equation() -> None:
    view = view_of("bead-on-lemniscate")
    assert view.motion is not None
    [equation] = view.motion.expressions
    s = symbol(view, "s")
    [found] = combinations((((1 + sp.sin(s) ** 2) * equation, sp.S.Zero),), view)
    assert sp.simplify(found.equations[0] - 1 - sp.sin(s) ** 2) == 0
    assert not found.is_one


def test_what_does_not_follow_is_no_combination() -> None:
    view = view_of("bead-on-lemniscate")
    assert view.motion is not None
    [equation] = view.motion.expressions
    assert combinations(((equation + symbol(view, "g"), sp.S.Zero),), view) == ()
