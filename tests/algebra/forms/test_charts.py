"""The surface of geometric constraints as a graph over some of the coordinates, in jets."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.forms.charts import (
    SingularSurfaceError,
    agreed_on_surface,
    chart,
    independent_constraints,
    pulled_back,
)
from lagrange.algebra.forms.jets import JetRing, constant_term
from lagrange.core.symbols import Slots

x, y, z = sp.symbols("x y z", real=True)
SLOTS = Slots((x, y, z))


def test_a_form_on_a_surface_is_that_of_the_free_coordinates() -> None:
    """On z = x y, where z is bound, dz is y dx + x dy."""
    surface = Surface([x * y - z], SLOTS.coordinates)

    def values(point, finite) -> bool:
        ring = JetRing(point.arithmetic)
        local = chart(ring, point, finite, SLOTS, 2)
        ((bound, _),) = local.graph
        (row,) = pulled_back(ring, local, [[*(sp.Integer(k == 2) for k in range(3)), sp.S.Zero]])
        free = dict(zip(local.free, map(constant_term, row), strict=True))
        expected = {0: y, 1: x} if bound == 2 else {2: sp.S.One}
        return all(point.arithmetic.vanishes(free[k] - point.value(e)) for k, e in expected.items())

    assert agreed_on_surface(values, [x], surface, SLOTS, lambda why: pytest.fail(why))


def test_a_multiple_of_a_constraint_is_dropped() -> None:
    assert independent_constraints(Surface([x - y, 2 * x - 2 * y], SLOTS.coordinates), SLOTS) == (x - y,)


def test_a_squared_constraint_has_no_chart() -> None:
    with pytest.raises(SingularSurfaceError):
        independent_constraints(Surface([(x - y) ** 2], SLOTS.coordinates), SLOTS)


def test_points_that_differ_leave_a_question_undecided() -> None:
    answers = iter([True, False] * 50)
    assert (
        agreed_on_surface(lambda *_: next(answers), [x], Surface([], SLOTS.coordinates), SLOTS, lambda _: None) is None
    )
