"""Frequencies that an answer states."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import compared_answers
from lagrange.core.diagnostics import ProblemError
from tests.support.linearized_systems import COUPLED, DAMPED, DOUBLE, HOOP, MOLECULE, PENDULUM, solved

PASS = """
parameters: [m, c, f]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {saddle: {potential: c*x^2/2 - f*y^2/2}}
"""


@pytest.mark.parametrize(
    ("text", "stated", "verdict"),
    [
        (PENDULUM, "[sqrt(g/l)]", "equivalent"),
        (PENDULUM, "[-sqrt(g/l)]", "equivalent"),
        (PENDULUM, "[sqrt(l/g)]", "wrong"),
        (PENDULUM, "[g*i]", "unreadable"),
        (DOUBLE, "[sqrt(g/l1)]", "wrong"),
        (COUPLED, '[sqrt(g/l), "sqrt(g/l + 2*c/m)"]', "equivalent"),
        (COUPLED, '["sqrt(g/l + 2*c/m)"]', "incomplete"),
        (COUPLED, '["sqrt(g/l + 2*c/m)", "-sqrt(g/l + 2*c/m)"]', "incomplete"),
        (COUPLED, '[sqrt(g/l), "sqrt(g/l + c/m)"]', "wrong"),
        (MOLECULE, '[0, sqrt(c/m), "sqrt(c/m*(1 + 2*m/M))"]', "equivalent"),
        (MOLECULE, '[sqrt(c/m), "sqrt(c/m*(1 + 2*m/M))"]', "equivalent"),
        (HOOP, '[["sqrt(g/R - Omega^2)"], ["sqrt(Omega^2 - g^2/(Omega^2*R^2))"]]', "equivalent"),
        (HOOP, '[["sqrt(g/R - Omega^2)"], ["sqrt(g/R + Omega^2)"]]', "wrong"),
        (DAMPED, "[sqrt(c/m)]", "undecided"),
        (PASS, "[sqrt(c/m)]", "equivalent"),  # ω² = −f/m grows, and is no frequency
        (PASS, "[sqrt(f/m)]", "wrong"),
    ],
)
def test_stated_frequencies(text: str, stated: str, verdict: str) -> None:
    solution = solved(text, f"find: linearization\nanswers: {{frequencies: {stated}}}")
    [answer] = compared_answers(solution)
    assert answer.name == "frequencies"
    assert answer.verdict.value == verdict


def test_an_imaginary_frequency_cannot_be_stated() -> None:
    with pytest.raises(ProblemError, match="state the real frequencies only") as caught:
        solved(PASS, 'find: linearization\nanswers: {frequencies: [sqrt(c/m), "sqrt(-f/m)"]}')
    assert [d.code for d in caught.value.diagnostics] == ["not-real"]


def test_equilibria_of_the_motion_in_answers() -> None:
    stated = '[["theta = 0"], ["theta = pi"], ["cos(theta) = g/(Omega^2*R)"]]'
    for wrong in (False, True):
        text = stated.replace("Omega^2", "Omega") if wrong else stated
        [answer] = compared_answers(solved(HOOP, f"find: linearization\nanswers: {{equilibrium: {text}}}"))
        assert (answer.verdict.value == "equivalent") != wrong
