"""Limits in words."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import prime
from lagrange.document.derivation import Prose
from lagrange.explain.page.conclusions.limiting import explain_limit, explain_massless, period_of
from lagrange.mechanics.consequences.limiting_cases import (
    LimitingCase,
    MasslessBodies,
    Named,
    NamedMotion,
    massless_bodies,
)
from lagrange.mechanics.rewriting.constant_accelerations import constant_accelerations
from tests.support.shared import solved

x, g, k, m = (sp.Symbol(n, positive=True) for n in ("x", "g", "k", "m"))


def words(block: object) -> str:
    assert isinstance(block, Prose)
    return "".join(p if isinstance(p, str) else "*" for p in block.parts)


@pytest.mark.parametrize(
    ("named", "value", "said"),
    [
        (Named.UNIFORM, sp.S.Zero, "* is constant"),
        (Named.CIRCLE, sp.S.Zero, "uniform motion in a circle, *"),
        (Named.ACCELERATED, g, " *: *."),
        (Named.OSCILLATION, k / m, "an oscillation with the period *"),
        (Named.PENDULUM, g, "the equation of a simple pendulum"),
        (Named.INVERSE_SQUARE, k, "Kepler's problem"),
    ],
)
def test_each_limit_has_a_name_or_a_solved_form(named: Named, value: sp.Expr, said: str) -> None:
    equation = prime(x, 2) + value * x
    block = explain_limit(LimitingCase(g, sp.S.Zero, (equation,), {}, (equation,), (NamedMotion(named, x, value),)))
    assert said in words(block)


def test_what_stays_is_counted() -> None:
    after, y = prime(x, 2), sp.Symbol("y", real=True)
    named = (NamedMotion(Named.UNIFORM, x, sp.S.Zero),)
    limit = LimitingCase(g, sp.S.Zero, (after, prime(y, 2)), {}, (after,), named)
    assert words(explain_limit(limit)).endswith("(the other equation unchanged).")


def test_bodies_without_inertia() -> None:
    [block] = explain_massless(MasslessBodies((m,), {prime(x, 2): g}))
    assert "of the bodies that turn" in words(block)
    assert not [*explain_massless(None)]


def test_a_period_is_a_product_with_one_root() -> None:
    assert sp.simplify(period_of(k / m) - 2 * sp.pi * sp.sqrt(m / k)) == 0


@pytest.mark.parametrize(("keeps_shape", "said"), [(False, "Without the inertia"), (True, "Limit")])
def test_a_light_cylinder_is_not_one_without_moment_of_inertia(keeps_shape: bool, said: str) -> None:
    """In ½ m R² the ratio to m R² stays for m → 0, and with it the ⅔ of s'' = ⅔ g sin α."""
    [block] = explain_massless(MasslessBodies((m,), {prime(x, 2): g}, keeps_shape))
    assert isinstance(block, Prose)
    assert said in str(block.parts[0])


def test_whether_a_moment_of_inertia_vanishes_with_a_mass() -> None:
    for name, keeps in (("cylinder-on-wedge", True), ("double-atwood", False)):
        solution = solved(name, complete=False)
        massless = massless_bodies(solution, solution.chosen, constant_accelerations(solution.chosen))
        assert massless is not None
        assert massless.keeps_shape is keeps
