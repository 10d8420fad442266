"""The step to the equations at the head of the page."""

from __future__ import annotations

import sympy as sp

from lagrange.explain.page.conclusions.combined import explain_combined
from lagrange.mechanics.rewriting.combinations import Combination, combinations
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load
from tests.support.shared import SHIPPED


def test_the_sum_is_said_with_the_constraints_that_it_needs() -> None:
    view = solve(load(str(SHIPPED["appell-hamel"]))).chosen
    motion = view.motion
    assert motion is not None
    both = Combination((sp.Integer(2), sp.Integer(3)), (sp.Integer(5),), with_constraints=True)
    words = "".join(p if isinstance(p, str) else "*" for p in explain_combined((both,), motion))
    assert words == " it is the sum of * times *, * times * and * times the time derivative of *, by *."
    first = tuple((e.expression, sp.S.Zero) for e in motion.equations[:1])
    assert explain_combined(combinations(first, view), motion) == ()  # it is (13) itself
