"""What a problem may ask for."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.coverage import chosen_coordinates, refuse_what_is_not_covered
from tests.support.shared import loaded


def test_choices() -> None:
    problem = loaded("ex11-ideal-pendulum")
    assert [c.name for c in chosen_coordinates(problem, None)] == ["angle", "depth"]
    assert [c.name for c in chosen_coordinates(problem, "depth")] == ["depth"]
    with pytest.raises(ProblemError, match="no choice `angel`"):
        chosen_coordinates(problem, "angel")
    refuse_what_is_not_covered(problem)
