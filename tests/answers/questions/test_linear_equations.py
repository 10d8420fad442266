"""Stated matrices of a linear motion.

Equations of small oscillations as an answer.
"""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions import linear_equations as answers_about
from lagrange.answers.questions.linear_equations import check_linearized
from lagrange.answers.submissions import Grader, Submission
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.mechanics.nearby.test_linear_motion import bicycle, published
from tests.support.shared import loaded, solved


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


# Linearized


FIRST = "m*l*theta1'' + m*g*theta1 + c*l*(theta1 - theta2) = 0"


@pytest.mark.parametrize(
    ("second", "verdict"),
    [
        ("m*l*theta2'' + m*g*theta2 + c*l*(theta2 - theta1) = 0", Verdict.EQUIVALENT),
        ("m*l*(theta1'' + theta2'') + m*g*(theta1 + theta2) = 0", Verdict.EQUIVALENT),  # their sum
        ("m*l*theta2'' + m*g*theta2 + c*l*(theta2 + theta1) = 0", Verdict.WRONG),
        ("m*l*theta2'' - m*g*theta2 + c*l*(theta2 - theta1) = 0", Verdict.WRONG),
    ],
)
def test_coupled_pendulums(second: str, verdict: Verdict) -> None:
    lines = [Fragment.of(f"for small angles: {e}") for e in (FIRST, second)]
    answer = check_linearized(lines, solved("coupled-pendulums"))
    assert answer is not None
    assert [e.verdict for e in answer.equations] == [Verdict.EQUIVALENT, verdict]


def test_equations_that_are_not_marked_are_those_of_the_motion() -> None:
    assert check_linearized([Fragment.of(FIRST)], solved("coupled-pendulums")) is None


SECOND = "m*l*theta2'' + m*g*theta2 + c*l*(theta2 - theta1) = 0"


@pytest.mark.parametrize(
    ("lines", "verdict"),
    [
        ([f"For small angles: {FIRST}", SECOND], Verdict.EQUIVALENT),
        ([f"For small angles: {FIRST}", SECOND, "frequencies: sqrt(g/l), sqrt(g/l + 2*c/m)"], Verdict.EQUIVALENT),
        (
            [f"For small angles: {FIRST}", SECOND.replace("c*l", "2*c*l"), "frequencies: sqrt(g/l), sqrt(g/l + 2*c/m)"],
            Verdict.WRONG,
        ),
        ([FIRST, f"For small angles: {SECOND}"], Verdict.WRONG),
    ],
)
def test_a_mark_before_the_first_equation_counts_for_all_that_follow(lines: list[str], verdict: Verdict) -> None:
    problem = "coupled-pendulums"
    grader = Grader.of(Examiner(loaded(problem), solved(problem)))
    graded = grader.grade(Submission("x", (("answer.txt", "\n".join(lines).encode()),)))
    assert graded.verdict is verdict


@pytest.mark.parametrize(("sign", "verdict"), [("-", "equivalent"), ("+", "wrong")])
def test_linear_equations_beside_their_frequencies_need_no_word(sign: str, verdict: str) -> None:
    text = (
        "m l theta1'' + (m g + c l) theta1 - c l theta2 = 0\n"
        f"m l theta2'' + (m g + c l) theta2 {sign} c l theta1 = 0\n"
        "omega_1 = sqrt(g/l), omega_2 = sqrt(g/l + 2 c/m)\n"
    )
    grader = Grader.of(Examiner(loaded("coupled-pendulums"), solved("coupled-pendulums")))
    assert grader.grade(Submission("x", (("a.txt", text.encode()),))).verdict.value == verdict
