"""The results for a problem: one record for each set of coordinates."""

from __future__ import annotations

from tests.support.shared import solved


def test_the_coordinates_of_the_file_are_the_first_of_them() -> None:
    solution = solved("ex11-ideal-pendulum")
    assert [v.name for v in solution.views] == ["", "angle", "depth"]
    assert [v.is_own for v in solution.views] == [True, False, False]
    assert solution.holds
    assert all(v.motion is not None for v in solution.views)
