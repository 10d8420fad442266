"""One submission as a platform reports it: a part for each problem of the assignment."""

from __future__ import annotations

from lagrange.answers.submissions import Graded
from lagrange.core.records import record


@record
class ProblemResult:
    """What came out for one problem."""

    label: str
    title: str
    graded: Graded
