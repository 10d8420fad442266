"""The file's own answers, compared with the derivation."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import ProblemError
from tests.support.linearized_systems import HOOP, PENDULUM, solved


def test_what_cannot_be_read_is_named() -> None:
    solution = solved(PENDULUM, "find: linearization\nanswers: {frequencies: [g*i]}")
    with pytest.raises(ProblemError, match="a frequency is a number, not a vector"):
        list(compared_answers(solution))


def test_equilibria_of_the_motion_in_answers() -> None:
    stated = '[["theta = 0"], ["theta = pi"], ["cos(theta) = g/(Omega^2*R)"]]'
    for wrong in (False, True):
        text = stated.replace("Omega^2", "Omega") if wrong else stated
        [answer] = compared_answers(solved(HOOP, f"find: linearization\nanswers: {{equilibrium: {text}}}"))
        assert (answer.verdict.value == "equivalent") != wrong
