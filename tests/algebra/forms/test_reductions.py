"""The records of how a constraint is reduced."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.forms.reductions import Alternative, Alternatives, Reduction, Why

x, y = sp.symbols("x' y'", real=True)


def test_nothing_satisfies_a_constraint_without_alternatives() -> None:
    assert Alternatives(()).members == ()
    step = Reduction((x - y) ** 2, next(iter(Why)), (x - y,))
    assert Alternatives((Alternative(step.forms, (step,)),)).members[0].forms == (x - y,)
    assert (step.conditions, step.excluded) == ((), ())
    assert len({w.value for w in Why}) == len(Why)
