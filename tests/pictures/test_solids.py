"""Bodies and circles as they are seen."""

from __future__ import annotations

import math

import pytest

from lagrange.document.scene import StrokeKind
from lagrange.pictures.floats import inner, outer
from lagrange.pictures.solids import across, hull
from tests.support.drawings import figures, lines_of


@pytest.mark.parametrize("axis", [(0.0, 0.0, 2.0), (1.0, 0.0, 0.0), (0.3, -0.5, 0.8)])
def test_two_vectors_across_an_axis(axis: tuple[float, float, float]) -> None:
    u, v = across(axis)
    assert math.isclose(inner(u, u), 1)
    assert math.isclose(inner(outer(u, v), axis), math.hypot(*axis))


def test_a_hull_leaves_out_what_is_inside() -> None:
    assert set(hull([(0, 0), (2, 0), (2, 2), (0, 2), (1, 1), (1, 0)])) == {(0, 0), (2, 0), (2, 2), (0, 2)}


def test_a_sphere_is_a_circle_whose_hidden_half_is_dashed() -> None:
    [scene, *_] = figures("rolling-ball")
    ball = max((line for line in lines_of(scene, StrokeKind.BODY)), key=lambda line: len(line.points))
    xs, ys = zip(*ball.points, strict=True)
    assert math.isclose(max(xs) - min(xs), max(ys) - min(ys), rel_tol=0.01)
    equator = [line for line in lines_of(scene, StrokeKind.REFERENCE) if len(line.points) > 10]
    assert equator


def test_the_disc_of_a_coin_touches_the_ground_at_its_contact() -> None:
    """The point Q, which the file gives, is on the rim that is drawn."""
    [scene, *_] = figures("rolling-coin")
    rim = max(lines_of(scene, StrokeKind.BODY), key=lambda line: len(line.points))
    [contact] = [d.at for d in scene.dots if min(math.dist(d.at, p) for p in rim.points) < 0.08]
    assert contact[1] == pytest.approx(min(p[1] for p in rim.points), abs=0.15)
