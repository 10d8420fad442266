"""Inequalities: their limit, and the side that they permit."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Fragment
from lagrange.expressions.relations import is_inequality, limit_of


@pytest.mark.parametrize(
    ("text", "limit", "side"),
    [("x >= a", "x = a", 1), ("x <= a", "x = a", -1), ("x = a", "x = a", None), ("x ≥ a", "x = a", 1)],
)
def test_sides(text: str, limit: str, side: int | None) -> None:
    found, permitted = limit_of(Fragment.of(text), "constraint")
    assert (" ".join(found.text.split()), permitted) == (limit, side)
    assert is_inequality(Fragment.of(text)) is (side is not None)
