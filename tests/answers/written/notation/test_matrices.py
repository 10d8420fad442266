"""Lists and matrices of a text, as rows and columns of equations."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.matrices import rows_of_lists, rows_with_names, with_named_matrices


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("[[a, b], [c, d]] [x''; y''] = [p; q]", ["(a)(x'') + (b)(y'') = (p)", "(c)(x'') + (d)(y'') = (q)"]),
        ("{{a, b}, {c, d}}.{x'', y''} == {p, q}", ["(a)(x'') + (b)(y'') = (p)", "(c)(x'') + (d)(y'') = (q)"]),
        ("[a b; c d]*[x''; y''] = [p; q]", ["(a)(x'') + (b)(y'') = (p)", "(c)(x'') + (d)(y'') = (q)"]),
        ("Matrix([x'', y'']) = -g*Matrix([0, 1])", ["(x'') = - (g)(0)", "(y'') = - (g)(1)"]),
        ("(■(a&b@c&d))(■(x@y))=(■(p@q))", ["(a)(x) + (b)(y) = (p)", "(c)(x) + (d)(y) = (q)"]),
        ("[[a, b], [c, d]] [x; y] = 0", ["(a)(x) + (b)(y) = 0", "(c)(x) + (d)(y) = 0"]),
        ("x[t] + y = 3", []),
        ("[a == b, c == d]", []),
        ("m [x'' - r] + c [x - l] = 0", []),
        ("[[a, b], [c, d]] [x; y; z] = [p; q]", []),
    ],
)
def test_lists_are_columns_and_matrices(text: str, rows: list[str]) -> None:
    assert rows_of_lists(text) == rows


def test_lists_may_have_names() -> None:
    lines = ["A = [a b; c d]", "rhs = [p; q];", "A*[x''; y''] = rhs", "z'' = 0"]
    rows = ["(a)(x'') + (b)(y'') = (p)", "(c)(x'') + (d)(y'') = (q)"]
    assert rows_with_names(lines) == [[], [], rows, None]
    assert rows_with_names(lines[:2]) == [None, None]


@pytest.mark.parametrize("unknown", ["[x''; y'']", "qdd", "acc"])
def test_a_system_may_be_divided_as_in_matlab(unknown: str) -> None:
    lines = ["A = [a b; c d]", "rhs = [p; q];", rf"{unknown} = A\rhs;"]
    x, y = ("x''", "y''") if "[" in unknown else ("state_1''", "state_2''")
    assert rows_with_names(lines) == [[], [], [f"(a)({x}) + (b)({y}) = (p)", f"(c)({x}) + (d)({y}) = (q)"]]


def test_a_quotient_of_no_system_is_no_equation_between_lists() -> None:
    assert rows_with_names(["A = [a b; c d]", "rhs = [p; q]", r"force = A\rhs"]) == [None, None, None]


def test_named_matrices_are_written_out() -> None:
    column = r"\begin{pmatrix}%s\\%s\end{pmatrix}"
    matrix = r"\begin{pmatrix}a & b\\c & d\end{pmatrix}"
    texts = [rf"M = {matrix}", rf"M\ddot q = {column % (1, 2)}"]
    rows = column % (r"\ddot{x}", r"\ddot{y}")
    assert with_named_matrices(texts, [["x", "y"]]) == [None, rf"{matrix}{rows} = {column % (1, 2)}"]
