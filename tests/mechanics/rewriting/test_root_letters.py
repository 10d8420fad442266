"""Long roots by letters, and only these."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.rewriting.root_letters import is_root_of, roots_by_letters

a, l, c, d = sp.symbols("a l c d", positive=True)
u, v = sp.symbols("u v", real=True)
RADICAND = a**2 - 2 * a * l * (sp.sin(u) - sp.sin(v)) + 2 * l**2 * (1 - sp.cos(u - v))


def test_the_root_its_inverse_and_that_of_a_multiple() -> None:
    e = c * sp.sqrt(RADICAND) + a / sp.sqrt(sp.expand(2 * RADICAND)) + RADICAND ** sp.Rational(3, 2)
    assert roots_by_letters(e, {RADICAND: d}) == c * d + a / (sp.sqrt(2) * d) + d**3


def test_what_a_damper_divides_by() -> None:
    assert roots_by_letters(c * l / RADICAND, {RADICAND: d}) == c * l / d**2


def test_other_roots_stay() -> None:
    e = sp.sqrt(RADICAND) + sp.sqrt(RADICAND + a * l)
    assert roots_by_letters(e, {RADICAND: d}) == d + sp.sqrt(RADICAND + a * l)


def test_a_root_in_another_form() -> None:
    other = sp.sqrt((a - l * sp.sin(u) + l * sp.sin(v)) ** 2 + l**2 * (sp.cos(v) - sp.cos(u)) ** 2)
    assert is_root_of(other, RADICAND)
    assert not is_root_of(other + a, RADICAND)
