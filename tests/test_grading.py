"""One submission: its verdict, what is right of it, and that nothing it says is an exception."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import Examiner
from lagrange.answers.grading import Graded, Grader, Submission
from lagrange.core.diagnostics import ProblemError, Source
from lagrange.problem.loader import load, read_problem

SECOND = "l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi1 - phi2) + g*sin(phi2) = 0"


def prepared(name: str) -> Grader:
    return Grader.of(Examiner.of(load(next(PROBLEMS.glob(f"*/{name}*.yaml")))))


@pytest.fixture(scope="module")
def pendulum() -> Grader:
    return prepared("ex11")


@pytest.fixture(scope="module")
def double() -> Grader:
    return prepared("ex18")


def grade(grader: Grader, *texts: str | bytes) -> Graded:
    files = tuple((f"file{n}", t if isinstance(t, bytes) else t.encode()) for n, t in enumerate(texts, start=1))
    return grader.grade(Submission("somebody", files))


@pytest.mark.parametrize(
    ("text", "verdict", "right"),
    [
        ("theta'' + g/l*sin(theta) = 0", Verdict.EQUIVALENT, 1),
        ("# mine\n\n2 l θ̈ = −2 g sin θ\n", Verdict.EQUIVALENT, 1),
        ("theta'' = 0", Verdict.WRONG, 0),
        ("theta'' + g/l*sin(theta) = 0\ntheta'' = 0", Verdict.WRONG, 1),
        ("x^2 + y^2 = l^2", Verdict.INCOMPLETE, 0),
        ("0 = 0", Verdict.TRIVIAL, 0),
        ("theta'' + q = 0", Verdict.UNREADABLE, 0),
        ("theta'' + g/l*sin(theta) = 0\nsee = my other sheet", Verdict.UNREADABLE, 1),
        ("theta''/(sin(theta)^2 + cos(theta)^2 - 1) = 0", Verdict.UNREADABLE, 0),
        ("", Verdict.UNREADABLE, 0),
        (b"\xff\xfe\x00", Verdict.UNREADABLE, 0),
        ("x = 1\n" * 13, Verdict.UNREADABLE, 0),
        ("(" * 1999, Verdict.UNREADABLE, 0),
    ],
)
def test_the_verdict_and_what_is_right(text: str | bytes, verdict: Verdict, right: int, pendulum: Grader) -> None:
    graded = grade(pendulum, text)
    assert (graded.verdict, graded.right, graded.required) == (verdict, right, 1)
    assert graded.headline.startswith(f"{verdict}: ")
    assert graded.remark or verdict is Verdict.EQUIVALENT


@pytest.mark.parametrize(
    ("text", "right"),
    [
        (SECOND, 1),
        (f"{SECOND}\n{SECOND.replace('= 0', '= 1')}", 1),
        (f"{SECOND}\n3*({SECOND.replace('= 0', ') = 0')}", 1),
        (f"{SECOND.replace('l2', 'L2')}", 0),
    ],
)
def test_one_of_two_equations(text: str, right: int, double: Grader) -> None:
    graded = grade(double, text)
    assert (graded.right, graded.required) == (right, 2)


def test_the_files_of_one_submission_are_one_answer(double: Grader) -> None:
    answers = double.examiner.problem.answers
    assert answers is not None
    first, second = (f.text for f in answers.equations)
    assert grade(double, first).verdict is Verdict.INCOMPLETE
    assert grade(double, first, second).verdict is Verdict.EQUIVALENT
    assert "file2:1:" in " ".join(grade(double, first, "phi1'' = huh").messages)


def test_nothing_depends_on_what_was_graded_before(pendulum: Grader) -> None:
    texts = ["theta'' = 0", "theta'' + g/l*sin(theta) = 0", "???", "theta'' = 0"]
    found = [grade(pendulum, t) for t in texts]
    assert found[0].verdict is found[3].verdict is Verdict.WRONG
    assert (found[0].equations, found[0].messages) == (found[3].equations, found[3].messages)
    assert found[1].verdict is Verdict.EQUIVALENT


def test_positions_of_equilibrium_are_not_counted_as_equations() -> None:
    grader = prepared("ex16")
    answers = grader.examiner.problem.answers
    assert answers is not None
    assert answers.equilibrium
    graded = grade(grader, " or ".join(f.text for a in answers.equilibrium for f in a))
    assert graded.verdict in (Verdict.EQUIVALENT, Verdict.WRONG, Verdict.INCOMPLETE)
    assert (graded.right, graded.required) == (None, None)
    assert grade(grader, "0 = 0").required is None


def test_a_reference_given_outright() -> None:
    text = "title: r\nparameters: [m, k]\ncoordinates: [x]\nequations: [\"m*x'' + k*x = 0\"]\n"
    grader = Grader.of(Examiner.of(read_problem(Source("r.yaml", text))))
    assert grade(grader, "x'' = -(k/m) x").right == 1


def test_a_problem_without_equations_is_refused_before_anything_is_graded() -> None:
    with pytest.raises(ProblemError, match="no motion"):
        prepared("ex05")
