"""CodeRunner, a question type of Moodle: what a combinator template grader prints.

It is one JSON object with `fraction`, from 0 to 1, and HTML in `prologuehtml` and `epiloguehtml`
(https://trampgeek.github.io/moodle-qtype_coderunner/, "Combinator-template grading"). It is printed by a program on the
Jobe server, in the server's own sandbox, which limits time and memory; so the answer is graded in that very process.
"""

from __future__ import annotations

import json
from html import escape

from lagrange.api.classroom import grade_source
from lagrange.core.diagnostics import ProblemError, Source


def result(problem: str, answer: str, hint: int = 1, seed: str = "") -> str:
    """The JSON text for an answer to the problem file with this text."""
    try:
        grade = grade_source(Source("problem", problem), answer, hint, seed)
    except ProblemError as error:
        fault = "This question has a fault, which its author has to mend; nothing is wrong with your answer."
        return _printed(0.0, fault, str(error))
    return _printed(grade.fraction, grade.feedback, "")


def _printed(fraction: float, feedback: str, for_instructors: str) -> str:
    fields: dict[str, object] = {"fraction": fraction, "epiloguehtml": f"<pre>{escape(feedback)}</pre>"}
    if for_instructors:
        fields["instructorhtml"] = f"<pre>{escape(for_instructors)}</pre>"
    return json.dumps(fields)
