"""The exit status that follows from a verdict, and from an error."""

from __future__ import annotations

import pytest

from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError, UndecidedError
from lagsolve.exit_statuses import status_of_error, status_of_verdict


def test_every_verdict_has_a_status() -> None:
    statuses = {v.value: status_of_verdict(v) for v in Verdict}
    assert {name for name, status in statuses.items() if status == 0} == {"equivalent"}
    assert {name for name, status in statuses.items() if status > 1} == {"unreadable", "undecided"}


@pytest.mark.parametrize(("kind", "status"), [(ProblemError, 2), (UndecidedError, 3), (NotCoveredError, 3)])
def test_what_contradicts_itself_is_2_and_what_is_left_open_is_3(kind: type[ProblemError], status: int) -> None:
    error = kind("rest") if kind is NotCoveredError else kind(Diagnostic("code", "message"))
    assert status_of_error(error) == status
