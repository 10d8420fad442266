"""Lines of action."""

from __future__ import annotations

import pytest

from lagrange.pictures.shapes import line_of_action


def test_a_force_along_its_line_has_the_moment() -> None:
    line = line_of_action((0.0, 2.0, 0.0), (0.0, 0.0, 6.0))
    assert line is not None
    assert line.nearest == pytest.approx((3.0, 0.0, 0.0))  # 3 i × 2 j = 6 k
    assert line_of_action((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)) is None
