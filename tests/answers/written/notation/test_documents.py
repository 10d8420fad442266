"""Rows of tables, and lists of dashes.

Macros that a LaTeX answer defines, written out.
"""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.documents import (
    cells_of_row,
    in_plain_text,
    is_list_of_dashes,
    macros_of,
    with_macros,
)
from lagrange.core.diagnostics import Fragment


def test_rows_of_tables_and_lists_of_dashes() -> None:
    line = "| radial | m r'' = f |"
    assert [line[a:b].strip() for a, b in cells_of_row(line)] == ["radial", "m r'' = f"]
    assert cells_of_row("|x| = |y|") == []
    assert is_list_of_dashes("So:\n- x'' = g\n- y'' = 0\n")
    assert not is_list_of_dashes("- m x'' = c\nx = 0\n")


# Macros


@pytest.mark.parametrize(
    ("written", "body", "read"),
    [
        (r"\newcommand{\tdd}{\ddot\theta}", r"\tdd = 0", r"\ddot\theta  = 0"),
        (r"\newcommand{\diff}[2]{\frac{d #1}{d #2}}", r"\diff{x}{t} = 0", r"\frac{d x}{d t}  = 0"),
        (r"\def\a{m}\def\b{\a x}", r"\b^2", "{m  x}^2"),
        (r"\newcommand{\a}{\a\a}", r"\a", r"\a\a "),
    ],
)
def test_macros_are_written_out_once(written: str, body: str, read: str) -> None:
    assert with_macros(Fragment.of(body), macros_of(written)).text == read


# Pasted texts


@pytest.mark.parametrize(
    ("written", "plain"),
    [
        ("<p>&theta;'' = &minus;g/l</p>", "\nθ'' = −g/l\n"),
        ("S = <sup>1</sup>&frasl;<sub>4</sub> mg", "S = (1/4) mg"),
        ("* centre: `x' = v`", "* centre:  x' = v "),
        ("**Rolling begins** here", "  Rolling begins   here"),
        ("x**2 + y**2 = a", "x**2 + y**2 = a"),
        ("theta` = omega, phi` = 0", "theta` = omega, phi` = 0"),
        ("a < b, c > d", "a < b, c > d"),
    ],
)
def test_marks_of_documents_are_left_out(written: str, plain: str) -> None:
    assert in_plain_text(written) == plain
