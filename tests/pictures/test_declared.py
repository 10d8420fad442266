"""What a file declares is where it says."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from lagrange.document.scene import StrokeKind
from lagrange.pictures.declared import around
from tests.support.drawings import figures, lines_of


@pytest.mark.parametrize(
    "weights", [((-1.0, -3.0), (1.0, -2.0)), ((-2.0, 2.5), (3.0, 2.0)), ((-3.0, 0.2), (0.4, -3.0))]
)
def test_a_string_leaves_a_pulley_along_its_tangents(weights: tuple[tuple[float, float], tuple[float, float]]) -> None:
    before, after = weights
    arc = around((0.0, 0.0), 0.5, before, after)
    assert all(math.isclose(math.hypot(*p), 0.5) for p in arc)
    for end, weight in ((arc[0], before), (arc[-1], after)):
        along = weight[0] - end[0], weight[1] - end[1]
        assert abs(along[0] * end[0] + along[1] * end[1]) < 1e-9
    middle = arc[len(arc) // 2]
    assert middle[0] * (before[0] + after[0]) + middle[1] * (before[1] + after[1]) < 0


def test_the_strings_of_atwoods_machine_hang_vertically() -> None:
    [scene, *_] = figures("double-atwood")
    strings = lines_of(scene, StrokeKind.STRING)
    assert len(strings) == 2
    for string in strings:
        for a, b in (string.points[:2], string.points[-2:]):
            assert abs(a[0] - b[0]) < 0.02


def test_a_ladder_leans_on_its_wall_and_stands_on_its_floor() -> None:
    [scene, *_] = figures("ladder")
    [rod] = lines_of(scene, StrokeKind.ROD)
    [ground] = lines_of(scene, StrokeKind.GROUND)
    (wall, _), (_, floor) = ground.points[0], ground.points[-1]
    low, high = sorted(rod.points, key=lambda p: p[1])
    assert low[1] == pytest.approx(floor)
    assert high[0] == pytest.approx(wall)


def test_the_rod_in_the_bowl_touches_its_rim() -> None:
    [scene, *_] = figures("rod-in-bowl")
    [rod] = lines_of(scene, StrokeKind.ROD)
    bowl = max(lines_of(scene, StrokeKind.GROUND), key=lambda line: len(line.points))
    (ax, ay), (bx, by) = rod.points[0], rod.points[-1]
    assert min(math.dist((ax, ay), p) for p in bowl.points) < 0.1
    x, y = max(bowl.points)
    assert abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / math.dist((ax, ay), (bx, by)) < 0.02


def test_a_bridge_of_four_bars_is_closed() -> None:
    """Crank, coupler and rocker: three bars, each with the mass centre or hinge of the next on it."""
    [scene, *_] = figures("four-bar-linkage")
    bars = [line for line in lines_of(scene, StrokeKind.BODY) if line.closed and len(line.points) == 18]
    assert len(bars) == 3
    for a, b in pairwise(bars):
        assert min(math.dist(p, q) for p in a.points for q in b.points) < 0.1
