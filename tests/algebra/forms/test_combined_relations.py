"""Relations that are added so that a coordinate drops out."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.forms.combined_relations import combined_relations

w, x, y, z = sp.symbols("w x y z", real=True)
R, b = sp.symbols("R b", positive=True)


def test_two_relations_leave_one_with_fewer_coordinates() -> None:
    [found] = combined_relations([R * (x - w) - 2 * b * y, R * (x - w) + 2 * b * z], [w, x, y, z])
    assert sp.expand(found.function - (y + z)) == 0
    assert found.places == (0, 1)


def test_nothing_where_it_is_no_shorter_or_not_linear() -> None:
    assert combined_relations([x + y, y + z], [x, y, z]) == ()
    assert combined_relations([x**2 + y + z, x**3 + y - z], [x]) == ()
