"""Output for teaching platforms, against what their documentation accepts.

Gradescope   https://gradescope-autograders.readthedocs.io/en/latest/specs/#output-format
PrairieLearn https://prairielearn.readthedocs.io/en/latest/externalGrading/#grading-results, .../devElements/
CodeRunner   https://trampgeek.github.io/moodle-qtype_coderunner/ (combinator-template grading)
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import lagrange
from lagrange.answers.submissions import Submission
from lagrange.core.diagnostics import Source
from lagsolve.grading.examine import grader
from lagsolve.grading.students import Attempts, Roster
from lagsolve.grading.table import TableRow
from lagsolve.platforms import gradescope
from lagsolve.platforms.parts import ProblemResult
from lagsolve.platforms.prairielearn import grade_element
from tests.command.test_main import run
from tests.support.paths import PROBLEMS

PENDULUM = (PROBLEMS / "chapter6" / "ex11-ideal-pendulum.yaml").read_text(encoding="utf-8")
SOURCE = Source("ex11", PENDULUM)
RIGHT, WRONG = "theta'' + g/l*sin(theta) = 0\n", "l*theta'' = g*sin(theta)\n"


def written(*arguments: str) -> dict[str, Any]:
    found = run("grade", *arguments, "--jobs", "1")
    assert found.exit_code in (0, 3), found.stderr
    return json.loads(found.stdout)  # type: ignore[no-any-return]


GRADESCOPE = {
    "score": float, "execution_time": float, "output": str, "visibility": str, "stdout_visibility": str, "extra_data": dict,
    "tests": list, "leaderboard": list, "output_format": str, "test_output_format": str, "test_name_format": str,
}  # fmt: skip
TEST = {
    "score": float, "max_score": float, "name": str, "number": str, "output": str, "tags": list, "visibility": str,
    "extra_data": dict, "status": str, "name_format": str, "output_format": str,
}  # fmt: skip


def has_the_form(found: dict[str, Any], form: dict[str, type]) -> bool:
    return all(isinstance(value, (form[key], int) if form[key] is float else form[key]) for key, value in found.items())


def test_gradescope_gets_a_test_for_each_problem(submission: Path) -> None:
    Path("other.yaml").write_text("title: Other\ncoordinates: [x]\nequations: [\"x'' = 2\"]\n")
    (submission / "answers.md").write_text(f"## Problem 2\nx'' = 1\n\n## Problem 1\n{RIGHT}")
    found = written("ex11", "other.yaml", "submission", "--format", "gradescope", "--hint", "1")
    assert has_the_form(found, GRADESCOPE)
    assert all(has_the_form(t, TEST) for t in found["tests"])
    assert [(t["name"], t["number"], t["score"], t["max_score"]) for t in found["tests"]] == [
        ("ex11: Ideal pendulum", "1", 1, 1),
        ("other: Other", "2", 0, 1),
    ]
    assert found["score"] == 1
    assert "it does not follow" in found["tests"][1]["output"]
    assert "2" not in found["tests"][1]["output"]  # at hint level 1 nothing of the answer is told


def part(answer: str | None) -> ProblemResult:
    """What comes out for an answer to the pendulum."""
    files = () if answer is None else (("answer.txt", answer.encode()),)
    return ProblemResult("ex11", "Ideal pendulum", grader(SOURCE).grade(Submission("s", files)))


def test_gradescope_is_told_what_is_late_and_what_counts() -> None:
    late = [TableRow.of("s", part(WRONG).graded), replace(TableRow.of("s", part(WRONG).graded), late="2 h 5 min")]
    before = Roster("gradescope", previous=0.5)
    found = gradescope.results([part(WRONG)], late, before, None)
    assert (found["score"], found["output"]) == (0, "Handed in 2 h 5 min after it was due.")
    found = gradescope.results([part(WRONG)], late, before, Attempts.BEST)
    assert found["score"] == 0.5
    assert found["output"].endswith("An earlier submission has 0.5 points, which count.")
    assert gradescope.results([part(RIGHT)], [], before, Attempts.BEST)["score"] == 1


# In Python: nbgrader, Otter


def test_a_test_cell_of_nbgrader_ends_with_the_points(capsys: pytest.CaptureFixture[str]) -> None:
    assert lagrange.grade("ex11", RIGHT).points(4) == 4
    assert capsys.readouterr().out == ""
    assert lagrange.grade("ex11", WRONG).points(4) == 0
    assert "it does not follow" in capsys.readouterr().out


def test_a_test_of_otter_raises_with_the_feedback() -> None:
    lagrange.grade("ex11", RIGHT).require()
    with pytest.raises(AssertionError, match="it does not follow"):
        lagrange.grade("ex11", WRONG).require()
    with pytest.raises(AssertionError, match="unreadable"):
        lagrange.grade("ex11", "x = = 1").require()


def test_feedback_reveals_as_much_as_its_level() -> None:
    texts = [lagrange.grade("ex11", WRONG, hint=hint).feedback for hint in (1, 2, 3)]
    assert [("force term" in t, "gravity" in t) for t in texts] == [(False, False), (True, False), (False, True)]
    with pytest.raises(ValueError, match="hint levels"):
        lagrange.grade("ex11", WRONG, hint=4)


def test_an_answer_may_be_in_any_format_and_of_any_size() -> None:
    assert lagrange.grade("ex11", r"\[ l \ddot\theta = -g \sin\theta \]", kind=".tex").fraction == 1
    assert lagrange.grade("ex11", "degrees_of_freedom: 2\n", kind=".yaml").verdict == "wrong"
    huge = lagrange.grade("ex11", "x" * (3 << 20))
    assert (huge.verdict, huge.score) == ("unreadable", 0)
    assert len(lagrange.grade("ex11", "x = \n" * 900).feedback) < 21_000


def test_a_problem_that_is_none() -> None:
    with pytest.raises(lagrange.ProblemError):
        lagrange.grade("no-such-problem", RIGHT)
    with pytest.raises(lagrange.ProblemError):
        grade_element({"submitted_answers": {"q": "x=1"}, "format_errors": {}, "partial_scores": {}}, "q", "title: t\n")
