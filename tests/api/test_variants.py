"""Variants of a problem in Python."""

from __future__ import annotations

import pytest

from lagrange.api.variants import variant
from lagrange.core.diagnostics import ProblemError, Source
from tests.problem.variants.test_writing import REST, VARY, text

LOOP = """title: Loop
parameters: [m, R, g, h]
coordinates: [phi]
vary: {m: [1 kg], R: [1 m], g: [9.81 m/s^2], h: [0.5 m, 3 m]}
particles: {P: {mass: m, position: R*sin(phi)*i - R*cos(phi)*j}}
gravity: -g*j
initial: {phi: 0, phi': "sqrt(2*g*h)/R"}
ask: {top: {quantity: "R*phi'", when: phi = pi}}
"""


def test_a_variant_without_an_answer_is_refused() -> None:
    """With h = 3 m it reaches the top; with h = 0.5 m it does not, because 2 R > h."""
    assert "h = 3 m" in variant(Source("loop.yaml", LOOP), "a").text
    with pytest.raises(ProblemError, match=r"h = 0.5 m has no answer: the `when` of the question `top` never holds"):
        variant(Source("loop.yaml", LOOP), "d")


def test_stated_answers_of_other_values_are_found() -> None:
    stated = text(" [m, l, g]", VARY, REST + "answers: {equations: [\"theta'' + g/0.2*sin(theta) = 0\"]}\n")
    with pytest.raises(ProblemError, match="has no answer"):
        variant(Source("p.yaml", stated), "anna")
