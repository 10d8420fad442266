"""How a motion goes on, in words."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import prime
from lagrange.document.derivation import Math, Prose
from lagrange.explain.page.conclusions.course import explain_released, explain_sense, explain_swinging
from lagrange.mechanics.consequences.course import Released, Sense, SwingingRate

q, W, mu, alpha = (sp.Symbol(n, real=True) for n in ("q", "W", "mu", "alpha"))
start = sp.Symbol("q_0", real=True)


def sides(block: object) -> list[tuple[object, ...]]:
    assert isinstance(block, Prose)
    return [p.sides for p in block.parts if isinstance(p, Math)]


def test_speed() -> None:
    [block] = explain_sense(Sense(prime(q), sp.tan(alpha), mu))
    assert sides(block)[1:] == [(sp.tan(alpha), mu), (sp.tan(alpha), mu)]
    assert not [*explain_sense(None)]


def test_contact_ends() -> None:
    place = Released(W, q, start, sp.sin(q), 2 * sp.sin(start) / 3, None)
    [known] = explain_released((place,))
    assert sides(known) == [(q, start), (W, 0), (sp.sin(q), 2 * sp.sin(start) / 3)]
    [provided] = explain_released((Released(W, q, start, sp.sin(q), sp.sin(start) / 2, sp.sin(start)),))
    assert (sp.sin(start), 0) in sides(provided)


def test_rates_that_swing() -> None:
    [block] = explain_swinging(SwingingRate(prime(q), sp.Rational(2, 7), ()))
    assert (prime(q, 3) + sp.Rational(2, 7) * prime(q), 0) in sides(block)
    assert not [*explain_swinging(None)]
