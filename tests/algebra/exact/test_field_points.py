"""Values in a prime field, and the numbers that they come from."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import (
    FieldPoint,
    Fields,
    Point,
    Surface,
    ZeroDivisorError,
)
from tests.algebra.exact.test_sampler import SURFACES
from tests.support.points import field_point

x, y, theta, u, v, w = sp.symbols("x y theta u v w", real=True)


def test_a_vanishing_denominator_names_its_node(point: Point) -> None:
    with pytest.raises(ZeroDivisorError) as caught:
        point.with_values({x: point.value(y)}).value(1 / (x - y) + 1)
    assert point.graph.expressions[caught.value.node or 0] == 1 / (x - y)


def test_reconstruction_of_values() -> None:
    point = field_point()
    assert isinstance(point, FieldPoint)
    assert point.reconstructed(point.value((2 * x + 2 * y) / (-7 * x - 7 * y))) == sp.Rational(-2, 7)
    assert point.reconstructed(point.value(x)) is None


ids = pytest.mark.parametrize("name", SURFACES)


@ids
def test_field_points_are_on_the_surface(name: str) -> None:
    constraints, q, _ = SURFACES[name]
    surface = Surface(constraints, q, fields=Fields(11))
    assert surface.exact
    for number in range(6):
        point = surface.point(number)
        assert point.exact
        assert point.values(constraints) == [0] * len(constraints)
