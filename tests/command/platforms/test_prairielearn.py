"""The results of PrairieLearn."""

from __future__ import annotations

from typing import Any

from lagsolve.platforms import prairielearn
from lagsolve.platforms.prairielearn import grade_element
from tests.command.platforms.test_gradescope import PENDULUM, RIGHT, WRONG, part


def test_prairielearn() -> None:
    found = prairielearn.results([part(RIGHT)])
    assert (found["gradable"], found["score"]) == (True, 1)
    [test] = found["tests"]
    assert {"name", "points", "max_points", "message", "output"} == set(test)
    assert prairielearn.results([part(RIGHT), part(WRONG)])["score"] == 0.5
    found = prairielearn.results([part("theta'' <script> = 0")])
    assert found["gradable"] is False
    assert "<script>" not in "".join(found["format_errors"])
    assert prairielearn.results([part(None)])["score"] == 0


def element(answer: object) -> dict[str, Any]:
    data: dict[str, Any] = {
        "submitted_answers": {"q": answer},
        "format_errors": {},
        "partial_scores": {},
        "feedback": {},
    }
    grade_element(data, "q", PENDULUM)
    return data


def test_the_grade_function_of_an_element() -> None:
    assert element(RIGHT)["partial_scores"]["q"]["score"] == 1
    wrong = element(WRONG)
    assert wrong["partial_scores"]["q"]["score"] == 0
    assert wrong["format_errors"] == wrong["feedback"] == {}
    for answer in ("x = = <b>", "", None, 3):
        assert set(element(answer)["format_errors"]) == {"q"}
        assert "<b>" not in element(answer)["format_errors"]["q"]
