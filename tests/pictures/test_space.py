"""Surfaces and curves in space that constraints give."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from lagrange.pictures.floats import FloatVector
from lagrange.pictures.space import curve, surface

HERE = (0.6, 0.8, 1.0)


def bowl(p: FloatVector) -> float:
    return p[0] ** 2 + p[1] ** 2 - p[2]


def cone(p: FloatVector) -> float:
    return p[0] ** 2 + p[1] ** 2 - p[2] ** 2


def saddle(p: FloatVector) -> float:
    return p[0] * p[1] - 0.48 * p[2]


@pytest.mark.parametrize("f", [bowl, cone])
def test_a_surface_of_revolution_is_drawn_from_its_axis_to_above_the_particle(f) -> None:  # type: ignore[no-untyped-def]
    grid = surface(f, HERE)
    assert max(abs(f(p)) for row in grid[1:-1] for p in row) < 1e-6
    radii = [math.hypot(row[0][0], row[0][1]) for row in (grid[0], grid[-1])]
    assert min(radii) < 0.05
    assert 1.0 < max(radii) < 1.5


def test_any_other_surface_is_a_patch_around_the_particle() -> None:
    grid = surface(saddle, HERE)
    assert max(abs(saddle(p)) for row in grid for p in row) < 1e-6
    assert min(math.dist(p, HERE) for row in grid for p in row) < 1e-6


def test_two_surfaces_leave_a_closed_curve() -> None:
    def ball(p: FloatVector) -> float:
        return p[0] ** 2 + p[1] ** 2 + p[2] ** 2 - 2

    points = curve([bowl, ball], HERE)
    assert points[0] == points[-1]
    assert max(abs(f(p)) for f in (bowl, ball) for p in points) < 1e-6
    assert max(math.dist(a, b) for a, b in pairwise(points)) < 0.1
