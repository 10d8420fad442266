"""A derivation as data."""

from __future__ import annotations

import sympy as sp

from lagrange.document.derivation import Detail, Equation, Prose, Rule, Table
from tests.support.shared import reported

x = sp.Symbol("x")


def test_levels_of_detail_are_in_order() -> None:
    assert Detail.BRIEF < Detail.STEPS
    assert Prose(("a",)).detail is Detail.STEPS
    assert Table(("a",), ()).detail is Detail.STEPS
    assert Equation((x, x)).relation == "="


def test_the_steps_of_a_derivation_are_in_the_order_of_the_rules() -> None:
    order = list(Rule)
    own = [s.rule for s in reported("ex05-ice-skate").derivation.steps]
    assert [order.index(r) for r in own] == sorted(order.index(r) for r in own)
