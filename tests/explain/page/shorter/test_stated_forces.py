"""Reactions in the form of the answers, or by the quantities in which the motion is stated."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import DotProduct, VectorSymbol, prime
from lagrange.document.derivation import Display, Equation, Rule, Step
from lagrange.explain.page.shorter.stated_forces import with_stated_forces
from tests.support.shared import reported, solved

N, m, g, x = sp.symbols("N m g x", real=True)


@pytest.mark.parametrize(
    ("stated", "shown"),
    [(m * g * (3 * x - 2), m * g * (3 * x - 2)), (m * (3 * g * x - 2 * g), 3 * m * g * x - 2 * m * g)],
)
def test_a_shorter_form_is_taken(stated: sp.Expr, shown: sp.Expr) -> None:
    """Only one that is clearly shorter."""
    step = Step(Rule.SOLVED_REACTIONS, "", (Display((Equation((N, 3 * m * g * x - 2 * m * g)),), boxed=True),))
    [made] = with_stated_forces(solved("leaving-a-sphere", complete=False), [step], ((N, stated),), ())
    [box] = made.body
    assert isinstance(box, Display)
    assert box.equations[0].sides == (N, shown)


def test_a_rolling_ball_has_forces_by_its_spin() -> None:
    """By hand F₂ = (2/7) m (g − b φ' ω·out): m z'' = F₂ − m g with 7 z'' + 2 b φ' ω·out + 5 g = 0. It is not stated."""
    made = reported("ball-in-a-pipe", complete=False)
    lines = [
        e for s in made.derivation.page if s.rule is Rule.SOLVED_REACTIONS for b in s.body if isinstance(b, Display)
        for e in b.equations
    ]  # fmt: skip
    letters = {p.symbol.name: p.symbol for p in made.solution.problem.parameters}
    turning = prime(made.solution.problem.slots.coordinates[0])
    spin = DotProduct(VectorSymbol("omega_ball"), VectorSymbol("out"))
    upward = sp.Rational(2, 7) * letters["m"] * (letters["g"] - letters["b"] * turning * spin)
    assert any(sp.expand(e.sides[-1] - upward) == 0 for e in lines if isinstance(e.sides[-1], sp.Expr))
