"""A picture as data: its box has all that is drawn."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.document.scene import MARGIN, Box, Label, Polyline, Scene, StrokeKind


def test_the_box_has_all_that_is_drawn() -> None:
    line = Polyline(((0.0, 0.0), (3.0, 1.0)), StrokeKind.ROD)
    scene = Scene((line,), (), ())
    (left, bottom), (right, top) = scene.box.corners
    assert (left, bottom) == pytest.approx((-MARGIN, -MARGIN))
    assert (right, top) == pytest.approx((3 + MARGIN, 1 + MARGIN))
    assert isinstance(scene.box, Box)
    assert sp.Symbol("x") not in (Label,)
