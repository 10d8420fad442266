"""What `grade --format` writes."""

from __future__ import annotations

from collections.abc import Sequence

from lagrange.core.printable import json_text
from lagsolve.grading.examine import problem_of
from lagsolve.grading.run import GradingRun, Outcome
from lagsolve.grading.table import TableRow, csv_text
from lagsolve.platforms import gradescope, marks, prairielearn
from lagsolve.platforms.parts import ProblemResult


def written_as(
    format_: str, run: GradingRun, rows: Sequence[TableRow], outcomes: Sequence[Outcome], assignment: str | None
) -> str:
    """The text in a format of the command line."""
    titles = [problem_of(source).title for source in run.sources]
    match format_:
        case "moodle":
            return marks.moodle(rows, run.roster)
        case "canvas":
            return marks.canvas(rows, run.roster, assignment or ", ".join(titles))
        case "csv":
            return csv_text(rows)
    in_order = sorted(outcomes, key=lambda outcome: outcome[1])
    parts = [ProblemResult(run.problems[n][0], titles[n], graded) for _, n, graded in in_order]
    if format_ == "gradescope":
        return json_text(gradescope.results(parts, rows, run.roster, run.attempts), indent=1) + "\n"
    late = next((row.late for row in rows if row.late), "")
    return json_text(prairielearn.results(parts, late), indent=1) + "\n"
