"""The state about which a motion is linearized."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.nearby.linear_motion import linear_motion
from tests.mechanics.nearby.test_linear_motion import DISC, problem_of


def test_velocities_that_nothing_determines(tmp_path) -> None:
    text = DISC.replace("phi': 0, theta': 0, ", "")
    with pytest.raises(ProblemError) as error:
        linear_motion(*problem_of(tmp_path, text))
    assert error.value.diagnostics[0].code == "undetermined-motion"
