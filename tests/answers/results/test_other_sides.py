"""The right side of a wrong equation for an equilibrium, inverted or multiplied."""

from __future__ import annotations

import sympy as sp

from lagrange.answers.readings import read_answer
from lagrange.answers.results.other_sides import INVERTED, other_sides
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded


def test_the_inverted_side_comes_first_and_factors_follow() -> None:
    reading = read_answer(Fragment.of("cos(theta) = W*l/c"), loaded("inverted-pendulum-springs").scope)
    sentences = [sentence for sentence, _ in other_sides([[reading]])]
    assert sentences[0] == INVERTED
    assert "a factor 2 is missing on its right side" in sentences


def test_each_side_is_put_into_the_equation() -> None:
    reading = read_answer(Fragment.of("cos(theta) = W*l/c"), loaded("inverted-pendulum-springs").scope)
    W, l, c, theta = sp.symbols("W l c theta")
    plain = {s: sp.Symbol(s.name) for e in reading.components for s in e.free_symbols}
    _, [(changed,)] = next(other_sides([[reading]]))
    assert changed.components[0].xreplace(plain) == sp.cos(theta) - c / (W * l)
