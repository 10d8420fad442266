"""A quantity determined by equations."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.mechanics.questions.elimination import eliminated

v, h = sp.symbols("v h", real=True)
m, g, length = sp.symbols("m g l", positive=True)


def test_the_speed_after_a_fall() -> None:
    found = eliminated([m * v**2 / 2 - m * g * h, h - length], v**2, [v, h], [v], sp.Symbol("q"))
    assert [b.values for b in found.branches] == [(2 * g * length,)]
    assert found.verified


def test_a_contradiction_is_never() -> None:
    assert eliminated([h**2 + length**2], h, [h], [], sp.Symbol("q")).never


def test_a_well_of_cosh_has_two_ends() -> None:
    """m v²/2 = U (1 − 1/cosh² (g h)) at h = ± asinh(v √(m/(2U − m v²)))/g."""
    u, speed = sp.symbols("U v_0", positive=True)
    energy = u * (1 - 1 / sp.cosh(g * h) ** 2) - m * speed**2 / 2
    found = eliminated([energy], h, [h], [], h)
    numbers = {m: 2, u: 5, g: 3, speed: 1}
    place = sp.asinh(sp.sqrt(sp.Rational(2, 8))) / 3
    values = sorted(float(value.xreplace(numbers)) for b in found.branches for value in b.values)
    assert values == [-float(place), float(place)]
    assert all(sign_of((c.lhs - c.rhs).xreplace(numbers)) == 1 for b in found.branches for c in b.conditions)
