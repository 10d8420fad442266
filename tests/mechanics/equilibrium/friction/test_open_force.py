"""The bounds of the only open force: tried in numbers against the condition that the page states."""

from __future__ import annotations

import random

import pytest
import sympy as sp

from lagrange.document.derivation import Detail
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Inequality, Signs
from lagrange.mechanics.equilibrium.friction.open_force import always, bounds_of
from lagrange.render import terminal
from tests.support.shared import reported

NAME = "ladder-on-rough-ground"


def test_a_force_within_the_bounds_exists_where_rest_is_possible() -> None:
    rest = reported(NAME).solution.chosen.at_rest
    assert rest is not None
    [force] = rest.open
    assert len(rest.bounds) == 3
    chance = random.Random(5)
    seen = set()
    for _ in range(300):
        names = sorted({s for c in rest.bounds for s in c.left.free_symbols | c.right.free_symbols} - {force}, key=str)
        values = {s: chance.uniform(0.05, 1.5) for s in names}
        low, high = 0.0, float("inf")
        for c in rest.bounds:
            e = sp.expand((c.right - c.left).subs(values))
            rate, constant = float(e.coeff(force, 1)), float(e.coeff(force, 0))
            low, high = (max(low, -constant / rate), high) if rate > 0 else (low, min(high, -constant / rate))
        [[condition]] = rest.cases
        holds = bool((condition.right - condition.left).subs(values) >= 0)
        assert holds == (low <= high)
        seen.add(holds)
    assert seen == {True, False}


def test_the_page_says_where_it_always_stands() -> None:
    r = reported(NAME)
    page = " ".join(terminal.text(r.derivation, r.notation, 200, Detail.STEPS).split())
    assert "tan θ = 2μ/(1 − μ ν) at the limit, for μ ν < 1" in page
    assert "(ν + cot θ) N_B ≥ W/2" in page
    assert "Such a force N_B exists, and so the system can be at rest, if and only if" in page
    assert "It holds in every position if μ ν ≥ 1." in page


def test_without_a_force_of_known_sign_nothing_is_left_out() -> None:
    a, s = sp.Symbol("a", positive=True), sp.Symbol("s", real=True)
    assert bounds_of([Inequality((sp.S.One,), a), Inequality((-sp.S.One,), a)], [s], Signs()) == ()


@pytest.mark.parametrize("right", [1, -1])
def test_a_condition_holds_always_only_with_a_positive_right_side(right: int) -> None:
    m, theta = sp.Symbol("m", positive=True), sp.Symbol("theta", real=True)
    case = (RestCondition((1 - m) * sp.tan(theta), right * m),)
    found = always([case], {theta}, Signs({theta}))
    assert found == (RestCondition(sp.S.One, m) if right == 1 else None)
