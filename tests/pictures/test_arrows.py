"""Arrows in pictures of systems."""

from __future__ import annotations

import pytest

from lagrange.document.scene import StrokeKind
from tests.support.drawings import figures, lines_of


def test_a_blow_ends_where_it_strikes_in_the_position_before_it() -> None:
    """The rod hangs from its hinge, and J strikes it at right angles, from the left."""
    scene = figures("centre-of-percussion")[0]
    [blow] = [line for line in lines_of(scene, StrokeKind.FORCE) if abs(line.points[0][1] - line.points[1][1]) < 1e-6]
    assert blow.points[1][0] == pytest.approx(0, abs=1e-6)  # on the rod, below the hinge
    assert blow.points[0][0] < 0
    assert blow.points[1][1] < 0
