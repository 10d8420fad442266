"""The file's own answers, compared with the derivation."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import ProblemError, Source
from lagrange.problem.loader import read_problem
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


def test_a_file_may_state_some_of_the_first_integrals() -> None:
    """Of two masses joined by a spring the momentum alone, as a book does; a wrong one is found all the same."""
    text = """title: Two masses
parameters: [m, k]
coordinates: [x, y]
particles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}}
forces: {spring: {potential: k*(y - x)^2/2}}
answers: {conserved: ["m*x' SIGN m*y' = const"]}
"""
    for sign, verdict in (("+", Verdict.EQUIVALENT), ("-", Verdict.WRONG)):
        judged = Examiner.of(read_problem(Source("p", text.replace("SIGN", sign)))).check_own()
        assert judged.verdict is verdict
