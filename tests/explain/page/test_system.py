"""The system as a page introduces it."""

from __future__ import annotations

import sympy as sp

from lagrange.document.derivation import Display, Equation, Rule
from lagrange.explain.limits import SHORT_SIDE
from lagrange.explain.page.system import are_short
from tests.support.shared import reported

x = sp.Symbol("x")


def test_two_short_equations_share_a_line() -> None:
    assert are_short([Equation((x, sp.S.One)), Equation((x, sp.S.Zero))])
    long = sp.Add(*(sp.sin(k * x) for k in range(1, 4 * SHORT_SIDE)))
    assert not are_short([Equation((x, long)), Equation((x, long))])


def test_positions_and_forces_are_in_one_display() -> None:
    [step] = [s for s in reported("ex11-ideal-pendulum").derivation.page if s.rule is Rule.STATEMENT]
    assert len([b for b in step.body if isinstance(b, Display)]) == 1
