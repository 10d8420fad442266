"""Frequencies on the stable part of an equilibrium that a tangent gives."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.mechanics.equilibrium.stability import Stability, StabilityVerdict
from lagrange.mechanics.rewriting.stable_frequencies import square_where_stable, where_defined
from tests.support.shared import solved

a, g, l = sp.symbols("a g l", positive=True)
theta = sp.Symbol("theta", real=True)


def stable_where(lhs: sp.Expr, relation: str) -> Stability:
    return Stability(StabilityVerdict.CONDITIONAL, conditions=(SignCondition(lhs, relation, sp.S.Zero),))


@pytest.mark.parametrize(
    ("lhs", "relation", "tangent", "place"),
    [
        (sp.cos(theta), ">", a / g, 0.6),
        (sp.cos(theta), "<", a / g, 0.6),
        (sp.sin(theta), ">", a / g, 0.6),
        (sp.sin(theta), "<", -a / g, 0.6),
    ],
)
def test_the_square_is_its_value_at_the_stable_place(
    lhs: sp.Expr, relation: str, tangent: sp.Expr, place: float
) -> None:
    square = (a**2 + g**2) * sp.cos(theta) / (g * l)
    found = square_where_stable(square, Branch((Relation(sp.tan(theta), tangent),)), stable_where(lhs, relation))
    assert found is not None
    values = {a: 2.3, g: 9.81, l: place}
    at = float(sp.atan(tangent).subs(values))
    holds = (lambda x: x > 0) if relation == ">" else (lambda x: x < 0)
    [angle] = [x for x in (at, at + float(sp.pi)) if holds(float(lhs.subs(theta, x)))]
    assert float(found.subs(values)) == pytest.approx(float(square.subs(values).subs(theta, angle)))
    assert theta not in found.free_symbols


def test_without_a_condition_on_its_sine_or_cosine_it_stays() -> None:
    b = Branch((Relation(sp.tan(theta), a / g),))
    assert square_where_stable(sp.cos(theta) / l, b, stable_where(a - g, ">")) is None
    assert square_where_stable(g / l, b, stable_where(sp.cos(theta), ">")) is None
    unknown = sp.Symbol("u", real=True)
    b = Branch((Relation(sp.tan(theta), unknown),))
    assert square_where_stable(sp.cos(theta) / l, b, stable_where(sp.sin(theta), ">")) is None


def test_a_condition_without_which_there_is_no_place_is_not_repeated() -> None:
    """r = g/(φ'² sin α tan α) has a value only where φ' ≠ 0."""
    steady = solved("marble-in-a-cone").own.steady
    assert steady is not None
    [family] = steady.families
    [b], [s] = family.about.branches, family.about.at
    assert s is not None
    assert s.judgement.stability.presupposed
    assert not where_defined(s, b).judgement.stability.presupposed
