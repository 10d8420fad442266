"""Coordinates that constraints relate, put in or moved to where the constraints hold."""

from __future__ import annotations

import sympy as sp

from lagrange.answers.friction.related_coordinates import dependent, on_relations

x, y = sp.symbols("x y", real=True)
a = sp.Symbol("a", positive=True)


def test_a_height_follows_from_the_distance_on_a_parabola() -> None:
    assert dependent([x**2 - 4 * a * y]) == {y: x**2 / (4 * a)}
    assert dependent([x**2 + y**2 - a**2]) == {}


def test_points_are_moved_onto_a_circle() -> None:
    moved = on_relations({x: 0.6, y: 0.9, a: 1.0}, [x**2 + y**2 - a**2])
    assert moved is not None
    assert abs(moved[x] ** 2 + moved[y] ** 2 - 1) < 1e-9
    assert on_relations({x: 3.0, y: 0.9, a: 1.0}, [x**2 + y**2 - a**2]) is None
