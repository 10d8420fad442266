"""The viewpoint of a drawing."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.pictures.views import seen_from, view


def test_axes_point_as_the_words_say() -> None:
    down = view({"i": "right", "j": "down"}, frozenset({0, 1}))
    assert down.flat((1.0, 2.0, 0.0)) == (1.0, -2.0)
    assert view({"i": "down", "j": "right"}, frozenset({0, 1})).flat((1.0, 2.0, 0.0)) == (2.0, -1.0)
    assert view({"i": "down the incline", "j": "away from it"}, frozenset({0, 1})).flat((1.0, 2.0, 0.0)) == (1.0, 2.0)
    assert view({"i": "up"}, frozenset({0})).flat((2.0, 0.0, 0.0)) == (0.0, 2.0)
    assert view({"k": "up"}, frozenset({0, 2})).flat((1.0, 0.0, 2.0)) == (1.0, 2.0)


@pytest.mark.parametrize(
    "axes", [{}, {"k": "up"}, {"k": "down"}, {"i": "north", "j": "east", "k": "down"}, {"j": "up"}]
)
def test_space_is_right_handed(axes: dict[str, str]) -> None:
    """Three perpendicular unit vectors; two span the page and the third points to the reader: an orthographic
    projection, in which a sphere is a circle.
    """
    found = view(axes, frozenset({0, 1, 2}))
    rotation = sp.Matrix([[*u, d] for u, d in zip(found.units, found.toward_reader, strict=True)])
    assert max(abs(e) for e in rotation * rotation.T - sp.eye(3)) < 1e-12
    assert abs(float(rotation.det()) - 1) < 1e-12


def test_an_incline_slopes_where_no_word_says_otherwise() -> None:
    gravity = (0.6, -0.8, 0.0)
    sloping = {"i": "down the incline", "j": "away from it"}
    turned = view(sloping, frozenset({0, 1})).upright(gravity, sloping)
    x, y = turned.flat(gravity)
    assert abs(x) < 1e-12
    assert abs(y + 1) < 1e-12
    named = {"i": "right", "j": "up"}
    assert view(named, frozenset({0, 1})).upright(gravity, named) == view(named, frozenset({0, 1}))


def test_space_is_seen_from_where_the_file_says() -> None:
    """From the right, j, with k down: ahead, i, is on the right, and j points at the reader."""
    found = seen_from((0.0, 2.0, 0.0), (0.0, 0.0, 1.0))
    assert found.flat((1.0, 5.0, 0.0)) == pytest.approx((1, 0))
    assert found.flat((0.0, 5.0, 1.0)) == pytest.approx((0, -1))
    assert found.toward_reader == pytest.approx((0, 1, 0))
    assert found.shown == (0, 2)
    assert not found.planar


@pytest.mark.parametrize("axes", [{}, {"i": "right", "j": "front", "k": "down"}, {"k": "up"}, {"j": "up"}])
@pytest.mark.parametrize("gravity", [(0, 0, 1), (0, 0, -1), (0, 2, 0), (1, 0, 0), (0.5, 0, -0.8), (-1, 2, 0.3)])
def test_gravity_points_down_in_space(axes: dict[str, str], gravity: tuple[float, float, float]) -> None:
    found = view(axes, frozenset({0, 1, 2})).upright(gravity, axes)
    x, y = found.flat(gravity)
    assert abs(x) < 1e-9
    assert y < -0.1
    rotation = sp.Matrix([[*u, d] for u, d in zip(found.units, found.toward_reader, strict=True)])
    assert max(abs(e) for e in rotation * rotation.T - sp.eye(3)) < 1e-9
    assert abs(float(rotation.det()) - 1) < 1e-9


def test_depth_measured_downwards_is_below() -> None:
    axes = {"i": "right", "j": "front", "k": "down"}
    assert view(axes, frozenset({0, 1, 2})).flat((0.0, 0.0, 1.0))[1] < 0
