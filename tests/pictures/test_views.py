"""From where a system is seen."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.pictures.views import view


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
    """The third axis points at the reader where the other two turn counterclockwise."""
    found = view(axes, frozenset({0, 1, 2}))
    i, j, k = found.units
    depth = [
        next((sign for slant, sign in (((-0.45, -0.36), 1), ((0.45, 0.36), -1)) if u == slant), 0) for u in (i, j, k)
    ]
    rows = [[*u, d] if d == 0 else [0, 0, d] for u, d in zip(found.units, depth, strict=True)]
    assert float(sp.Matrix(rows).det()) == 1
