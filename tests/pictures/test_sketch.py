"""Labels are on nothing."""

from __future__ import annotations

from itertools import combinations

import pytest

from lagrange.document.scene import Box
from tests.support.drawings import scenes
from tests.support.paths import PROBLEMS

SHIPPED = sorted(p.relative_to(PROBLEMS).with_suffix("").as_posix() for p in PROBLEMS.glob("*/*.yaml"))


@pytest.mark.parametrize("name", SHIPPED)
def test_labels_are_on_nothing(name: str) -> None:
    for scene in scenes(name):
        for a, b in combinations(scene.labels, 2):
            assert not a.box.overlaps(b.box), (a, b)
        for label in scene.labels:
            assert not any(label.box.is_crossed(*piece) for line in scene.lines for piece in line.pieces), label
            assert not any(label.box.overlaps(Box(*d.at, *d.at).grown(d.radius * 0.99)) for d in scene.dots), label


def test_a_box_is_crossed() -> None:
    box = Box(0, 0, 2, 1)
    assert box.is_crossed((-1, 0.5), (3, 0.5))
    assert box.is_crossed((0.5, 0.5), (0.6, 0.6))
    assert not box.is_crossed((-1, 0.5), (-0.5, 0.5))
    assert not box.is_crossed((-1, 1), (1, 2.5))
