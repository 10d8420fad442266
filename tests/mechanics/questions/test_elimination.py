"""A quantity determined by equations."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.questions.elimination import eliminated

v, h = sp.symbols("v h", real=True)
m, g, length = sp.symbols("m g l", positive=True)


def test_the_speed_after_a_fall() -> None:
    found = eliminated([m * v**2 / 2 - m * g * h, h - length], v**2, [v, h], [v], sp.Symbol("q"))
    assert [b.values for b in found.branches] == [(2 * g * length,)]
    assert found.verified


def test_a_contradiction_is_never() -> None:
    assert eliminated([h**2 + length**2], h, [h], [], sp.Symbol("q")).never
