"""Conditions of rest and rates as the head of a page has them, by hand."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition
from lagrange.mechanics.rewriting.cases_of_rest import rate_or_square, strictest_cases

g, a, d, h, mu = sp.symbols("g a d h mu", positive=True)
s, v = sp.Symbol("s", real=True), sp.Symbol("phi'", real=True)


def test_values_exclude_cases_and_the_weaker_of_two_bounds() -> None:
    """A bracket on a pipe: h/d ≤ μ, or d/2 ≤ s and h/(2 μ) ≤ s."""
    cases = [[RestCondition(h / d, mu)], [RestCondition(d / 2, s), RestCondition(h / (2 * mu), s)]]
    assert strictest_cases(cases, {}) == cases
    given = {d: sp.Integer(3), h: sp.Integer(6), mu: sp.Rational(1, 4)}
    assert strictest_cases(cases, given) == [[RestCondition(h / (2 * mu), s)]]
    assert strictest_cases([[RestCondition(h, mu)]], given) == [
        [RestCondition(h, mu)]
    ]  # nothing is left: the page says what fails


def test_values_exclude_what_is_strict_at_its_limit() -> None:
    given = {mu: sp.S.One}
    strict, other = RestCondition(sp.S.One, mu, "<"), RestCondition(h, s)
    assert strictest_cases([[strict], [other]], given) == [[other]]
    assert strictest_cases([[RestCondition(sp.S.One, mu)], [other]], given) == [[RestCondition(sp.S.One, mu)], [other]]


def test_a_rate_that_is_a_root_is_given_by_its_square() -> None:
    """A marble in z = a r² goes round at φ'² = 2 a g in either sense; a rate without a root stays as it is."""
    assert rate_or_square(v, sp.sqrt(2 * a * g)) == (v**2, 2 * a * g)
    assert rate_or_square(v, a / g) == (v, a / g)
    assert rate_or_square(v, g - sp.sqrt(a))[0] == v
