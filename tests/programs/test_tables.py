"""The table of a simulation."""

from __future__ import annotations

from lagrange.programs.tables import csv_text
from tests.programs.test_simulation import moved


def test_the_table_has_units_in_its_header() -> None:
    lines = csv_text(moved("ex11-ideal-pendulum", 1.0, samples=11)).splitlines()
    assert lines[0] == "t (s),theta (rad),theta' (rad/s),T_rod (N),energy (J)"
    assert len(lines) == 12
    assert all(len(line.split(",")) == 5 for line in lines)
