"""Grading one answer from Python."""

from __future__ import annotations

import pytest

from lagrange.api.classroom import grade, variant
from lagrange.core.diagnostics import ProblemError, Source
from tests.problem.variants.test_writing import REST, VARY, text

RIGHT, WRONG = "theta'' = -g/l*sin(theta)", "theta'' = g/l*sin(theta)"


def test_points() -> None:
    right, wrong = grade("ex11-ideal-pendulum", RIGHT), grade("ex11-ideal-pendulum", WRONG)
    assert (right.verdict, wrong.verdict) == ("equivalent", "wrong")
    assert right.points(5) == 5
    assert wrong.points(5) == 0
    right.require()
    with pytest.raises(AssertionError, match="wrong"):
        wrong.require()
    assert RIGHT not in wrong.feedback  # the expected equation is not given away


# -- Variants of a problem in Python -----------------------------------------------------------------------------------


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
