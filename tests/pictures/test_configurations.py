"""What can be drawn of a system, and what is left out."""

from __future__ import annotations

import pytest

from lagrange.render import latex
from tests.support.drawings import scenes
from tests.support.shared import reported

LEFT_OUT = ("chapter6/ex02-fixed-surface", "chapter6/ex05-ice-skate", "statics/rocking-plank", "statics/lazy-tongs")


@pytest.mark.parametrize("name", LEFT_OUT)
def test_what_cannot_be_drawn_is_left_out(name: str) -> None:
    assert scenes(name) == []
    assert "tikzpicture" not in latex.render([(reported(name).derivation, reported(name).notation)])
