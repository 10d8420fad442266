"""The names of units, each of which is read as a unit."""

from __future__ import annotations

from lagrange.core.unit_names import names_of_units
from lagrange.core.units import unit_of


def test_each_name_is_a_unit() -> None:
    names = names_of_units()
    assert {"kg", "cm", "MPa", "lb", "°", "1"} <= names
    assert [name for name in names if unit_of(name) is None] == []
