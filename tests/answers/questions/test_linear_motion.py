"""Stated matrices of a linear motion."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from lagrange.answers.questions import linear_motion as answers_about
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.mechanics.nearby.test_linear_motion import bicycle, published


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ([published(0), published(1)], Verdict.EQUIVALENT),
        ([published(1)], Verdict.INCOMPLETE),
        ([published(0, 33.87), published(1)], Verdict.EQUIVALENT),
        ([published(0, 33.88), published(1)], Verdict.WRONG),
        ([Fragment.of("sin(phi) + phi'' = 0")], Verdict.WRONG),
        ([Fragment.of("psi'' = 0")], Verdict.UNDECIDED),
    ],
)
def test_published_matrices_as_an_answer(
    answer: list[Fragment], verdict: Verdict, monkeypatch: pytest.MonkeyPatch
) -> None:
    problem, _, found = bicycle()
    reference = SimpleNamespace(scope=problem.scope, declared=problem.scope.names(), values={})
    monkeypatch.setattr(answers_about, "reference_of_solution", lambda _: reference)
    assert answers_about.check_linear_motion_answers(answer, SimpleNamespace(linear_motion=found)).verdict is verdict
