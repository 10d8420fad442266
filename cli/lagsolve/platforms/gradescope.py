"""Gradescope: `results.json`, one test for each problem.

The format is that of https://gradescope-autograders.readthedocs.io/en/latest/specs/#output-format: at the top `score`,
`output`, `visibility`, `execution_time`, `extra_data`, and `tests` with `name`, `score`, `max_score`, `number`,
`output`, `visibility`. Nothing is printed for students on standard output, which Gradescope shows to instructors
only.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from lagrange.answers.verdicts import Verdict
from lagrange.api.classroom import feedback_text
from lagsolve.grading.students import Attempts, Roster
from lagsolve.grading.table import TableRow, number
from lagsolve.platforms.parts import ProblemResult


def results(
    parts: Sequence[ProblemResult], rows: Sequence[TableRow], roster: Roster, attempts: Attempts | None
) -> dict[str, Any]:
    """The object of `results.json` for one submission.

    With `attempts` best, the score of an earlier submission counts where it is higher.
    """
    tests = [
        {
            "name": f"{p.label}: {p.title}" if len(parts) > 1 else p.title,
            "number": str(n),
            "score": p.graded.points or 0.0,
            "max_score": p.graded.possible or 1.0,
            "output": feedback_text(p.graded),
            "visibility": "visible",
        }
        for n, p in enumerate(parts, start=1)
    ]
    score = sum(p.graded.points or 0.0 for p in parts)
    late = next((row.late for row in rows if row.late), "")
    said = [f"Handed in {late} after it was due."] if late else []
    undecided = [p.label for p in parts if p.graded.verdict is Verdict.UNDECIDED]
    if undecided:
        said.append(f"Not judged, a person has to look at it: {', '.join(undecided)}.")
    if attempts is Attempts.BEST and roster.previous is not None and roster.previous > score:
        said.append(f"An earlier submission has {number(roster.previous)} points, which count.")
        score = roster.previous
    fields: dict[str, Any] = {
        "score": score,
        "execution_time": round(sum(p.graded.seconds for p in parts), 3),
        "visibility": "visible",
        "tests": tests,
        "extra_data": {
            "program": "lagsolve",
            "verdicts": {p.label: p.graded.verdict.value for p in parts},
            "late": late,
        },
    }
    return fields | ({"output": "\n".join(said)} if said else {})
