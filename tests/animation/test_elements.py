"""What a page evaluates: each expression once."""

from __future__ import annotations

import sympy as sp

from lagrange.animation.elements import Cells
from lagrange.core.vectors import Vector

x, y = sp.symbols("x y", real=True)


def test_each_expression_has_one_place() -> None:
    cells = Cells()
    first = cells.scalar(x * y)
    assert cells.scalar(x * y) == first
    place = cells.vector(Vector((x, y, sp.S.Zero)))
    assert cells.vector(Vector((x, y, sp.S.Zero))) == place
    assert cells.expressions[first] == x * y
    assert cells.expressions[place : place + 3] == [x, y, 0]
