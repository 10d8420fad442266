"""What is judged of an answer with its working."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.verdicts import Verdict
from lagrange.answers.written.judging import is_of_motion
from lagrange.answers.written.working import understood
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, reference_of, solved

PENDULUM = "ex11-ideal-pendulum"


@pytest.mark.parametrize(
    ("text", "motion"), [("theta'' = 0", True), ("theta'^2 = 2*g/l*cos(theta)", False), ("T_rod = m*g", True)]
)
def test_an_equation_of_motion_has_an_acceleration_or_a_reaction(text: str, motion: bool) -> None:
    reference = reference_of(PENDULUM)
    [judged] = understood([Fragment.of(text)], reference).judged
    assert is_of_motion(judged, reference) is motion


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("theta'' = -g/l*sin(theta); theta'^2 = 2*theta^2", Verdict.EQUIVALENT),  # no equation of motion: in a note
        ("theta'' = -g/l*sin(theta); theta'' = ???", Verdict.EQUIVALENT),
        ("theta'' = g/l*sin(theta); theta'' = ???", Verdict.WRONG),
        ("theta'' = ???", Verdict.UNREADABLE),
    ],
)
def test_what_cannot_be_judged_leaves_the_verdict_as_it_is(answer: str, verdict: Verdict) -> None:
    examiner = Examiner(loaded(PENDULUM), solved(PENDULUM))
    assert examiner.check(tuple(map(Fragment.of, answer.split("; ")))).verdict is verdict
