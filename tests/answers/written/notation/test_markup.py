"""Rows of tables, and lists of dashes."""

from __future__ import annotations

from lagrange.answers.written.notation.markup import cells_of_row, is_list_of_dashes


def test_rows_of_tables_and_lists_of_dashes() -> None:
    line = "| radial | m r'' = f |"
    assert [line[a:b].strip() for a, b in cells_of_row(line)] == ["radial", "m r'' = f"]
    assert cells_of_row("|x| = |y|") == []
    assert is_list_of_dashes("So:\n- x'' = g\n- y'' = 0\n")
    assert not is_list_of_dashes("- m x'' = c\nx = 0\n")
