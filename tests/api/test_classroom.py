"""Grading one answer from Python."""

from __future__ import annotations

import pytest

from lagrange.api.classroom import grade

RIGHT, WRONG = "theta'' = -g/l*sin(theta)", "theta'' = g/l*sin(theta)"


def test_points() -> None:
    right, wrong = grade("ex11-ideal-pendulum", RIGHT), grade("ex11-ideal-pendulum", WRONG)
    assert (right.verdict, wrong.verdict) == ("equivalent", "wrong")
    assert right.points(5) == 5
    assert wrong.points(5) == 0
    right.require()
    with pytest.raises(AssertionError, match="wrong"):
        wrong.require()
    assert RIGHT not in wrong.feedback  # the expected equation is not given away
