"""Springs and dampers in pictures."""

from __future__ import annotations

import math

import pytest

from lagrange.document.scene import StrokeKind
from lagrange.pictures.sketch import Sketch
from lagrange.pictures.springs_dampers import draw_damper, draw_spring
from tests.support.drawings import lines_of, scenes


@pytest.mark.parametrize("far", [(0.7, 0.0), (2.0, 1.0), (-6.0, 3.0)])
def test_a_zigzag_stays_near_its_line_and_joins_its_ends(far: tuple[float, float]) -> None:
    sketch = Sketch()
    draw_spring(sketch, (0.0, 0.0), far)
    [spring] = sketch.lines
    assert (spring.points[0], spring.points[-1]) == ((0.0, 0.0), far)
    off = [(far[0] * y - far[1] * x) / math.hypot(*far) for x, y in spring.points]
    assert -0.13 < min(off) < -0.1 < 0.1 < max(off) < 0.13


def test_the_piston_of_a_damper_is_inside_its_cylinder() -> None:
    sketch = Sketch()
    draw_damper(sketch, (0.0, 0.0), (2.0, 0.0))
    _, cup, piston, _ = sketch.lines
    assert min(x for x, _ in cup.points) < piston.points[0][0] < max(x for x, _ in cup.points)


def test_a_spring_on_one_line_is_fastened_to_a_wall() -> None:
    [scene, *_] = scenes("motion/coupled-oscillators")
    [wall, *_] = lines_of(scene, StrokeKind.GROUND)
    [spring, *_] = lines_of(scene, StrokeKind.SPRING)
    middle = [sum(c) / 2 for c in zip(*wall.points, strict=True)]
    assert min(math.dist(middle, p) for p in (spring.points[0], spring.points[-1])) < 0.05
