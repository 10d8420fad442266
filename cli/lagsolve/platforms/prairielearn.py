"""PrairieLearn: the results of an external grader, and the `grade` function of an element.

An external grader writes `/grade/results/results.json` (https://prairielearn.readthedocs.io/en/latest/externalGrading/):
`score` from 0 to 1, `gradable`, `format_errors`, `message`, `tests` with `name`, `points`, `max_points`, `message`,
`output`. A submission that cannot be read, or that a person has to look at, is `gradable: false`: the student loses
no attempt.

An element (https://prairielearn.readthedocs.io/en/latest/devElements/) has `parse(element_html, data)`, which puts
what it cannot read into `data["format_errors"][name]`, and `grade(element_html, data)`, which sets `score` and
`feedback` in `data["partial_scores"][name]`.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from lagrange.answers.verdicts import Verdict
from lagrange.api.classroom import feedback_text, grade_source
from lagrange.core.diagnostics import Source
from lagsolve.platforms.parts import ProblemResult

NOT_GRADABLE = (Verdict.UNREADABLE, Verdict.UNDECIDED)


def results(parts: Sequence[ProblemResult], late: str = "") -> dict[str, Any]:
    """The object of `results.json` for one submission."""
    out_of = sum(p.graded.possible or 1.0 for p in parts)
    unread = [p for p in parts if p.graded.verdict in NOT_GRADABLE]
    message = "\n".join(filter(None, (p.graded.headline if len(parts) == 1 else "" for p in parts)))
    fields: dict[str, Any] = {
        "gradable": not unread,
        "score": min(1.0, sum(p.graded.points or 0.0 for p in parts) / out_of),
        "message": "\n".join(filter(None, (message, f"Handed in {late} after it was due." if late else ""))),
        "tests": [
            {
                "name": f"{p.label}: {p.title}" if len(parts) > 1 else p.title,
                "points": p.graded.points or 0.0,
                "max_points": p.graded.possible or 1.0,
                "message": p.graded.headline,
                "output": feedback_text(p.graded),
            }
            for p in parts
        ],
    }
    if unread:
        fields["format_errors"] = [escape(feedback_text(p.graded)) for p in unread]
    return fields


def grade_element(
    data: dict[str, Any], name: str, problem: str, hint: int = 1, weight: int = 1, seed: str = ""
) -> None:
    """Grades `data["submitted_answers"][name]`, for the `grade` function of an element.

    problem  the text of the problem file
    weight   of this answer among those of the question

    Raises ProblemError if the problem cannot be read or solved, which PrairieLearn shows to the author.
    """
    answer = data["submitted_answers"].get(name)
    if not isinstance(answer, str) or not answer.strip():
        data["format_errors"][name] = "no answer was given"
        return
    grade = grade_source(Source("problem", problem), answer, hint, seed)
    if grade.verdict in NOT_GRADABLE:
        data["format_errors"][name] = escape(grade.feedback)
        return
    data["partial_scores"][name] = {"score": grade.fraction, "feedback": grade.feedback, "weight": weight}
