"""Reactions as one vector, on pages and at their heads."""

from __future__ import annotations

import sympy as sp

from lagrange.document.derivation import Display, Equation, Rule
from tests.support.shared import reported


def _lines(name: str, rule: Rule) -> list[Equation]:
    steps = reported(name, complete=False).derivation.page
    return [
        e for s in steps if s.rule is rule for b in s.body if isinstance(b, Display) and b.boxed for e in b.equations
    ]


def test_a_coin_has_one_term_along_each_of_its_axes() -> None:
    """R = m (R θ' ψ' + g sin α sin θ) axle − m C g sin α cos θ/(m R² + C) ahead, from Newton's law by hand."""
    [vector] = [e for e in _lines("coin-on-incline", Rule.RESULT) if str(e.sides[0]) == "R_coin"]
    total = vector.sides[1]
    assert isinstance(total, sp.Expr)
    names = {s.name: s for s in total.free_symbols}
    m, R, C, g = (names[n] for n in ("m", "R", "C", "g"))
    sa, th = sp.sin(names["alpha"]), names["theta"]
    along = total.expand().coeff(names["axle"])
    ahead = total.expand().coeff(names["ahead"])
    assert sp.simplify(along - m * (R * names["theta'"] * names["psi'"] + g * sa * sp.sin(th))) == 0
    assert sp.simplify(ahead + m * C * g * sa * sp.cos(th) / (m * R**2 + C)) == 0


def test_the_couple_on_a_skewed_disc() -> None:
    """Along the second axis of the disc it is I_xz φ'², whatever the motor does."""
    [vector] = [e for e in _lines("skewed-disc", Rule.RESULT) if str(e.sides[0]) == "Gamma_disc"]
    total = vector.sides[1]
    assert isinstance(total, sp.Expr)
    names = {s.name: s for s in total.free_symbols}
    second = total.expand().coeff(names["e2_disc"])
    beta, m, R = (names[n] for n in ("beta", "m", "R"))
    assert sp.simplify(second - m * R**2 * sp.sin(beta) * sp.cos(beta) * names["phi'"] ** 2 / 4) == 0


def test_a_page_without_several_reactions_has_none() -> None:
    assert not [e for e in _lines("ex11-ideal-pendulum", Rule.SOLVED_REACTIONS) if (e.label or "").startswith("along")]
