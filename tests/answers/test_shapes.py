"""Notations that are rewritten as texts: lists as rows, ratios, tuples, operators, decimal commas, tables, units."""

from __future__ import annotations

import pytest

from lagrange.answers.written.approximations import results
from lagrange.answers.written.notation.decimal_commas import with_decimal_points
from lagrange.answers.written.notation.markup import cells_of_row, is_list_of_dashes
from lagrange.answers.written.notation.matrices import rows_of_lists, rows_with_names
from lagrange.answers.written.notation.operators import with_operators
from lagrange.answers.written.notation.ratios import extremes, name_of_extreme, ratios_of, tuples_of
from lagrange.answers.written.notation.units import plain_unit
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.edits import Draft


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


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        ("h : R = 5 : 2", ["(h)/(R) = (5)/(2)"]),
        ("ratio: x : y = -1 : 1", ["(x)/(y) = (-1)/(1)"]),
        ("A:B:C = 1:2:1", ["(A)/(B) = (1)/(2)", "(B)/(C) = (2)/(1)"]),
        ("P/W = 3 : tan(theta)", ["P/W = (3)/(tan(theta))"]),
        ("theta = 0: omega = 3", []),
        ("Equation: x = 2", []),
    ],
)
def test_ratios(text: str, equations: list[str]) -> None:
    assert ratios_of(text) == equations


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        ("(x, y) = (1, 2)", ["x = 1", "y = 2"]),
        ("(x, y) = (0, 0), (0, pi)", ["[x, y] = [0, 0]", "[x, y] = [0, pi]"]),
        ("(x, y) = (0, 0, 1)", []),
        ("(x + y) = (a)", []),
    ],
)
def test_tuples(text: str, equations: list[str]) -> None:
    assert tuples_of(text) == equations


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("m D^2 r - m r (D phi)^2", "m diff(diff(r, t), t) - m r (diff(phi, t))^2"),
        ("2 D r D phi", "2 diff(r, t) diff(phi, t)"),
        ("Dx + D²θ", "diff(x, t) + diff(diff(θ, t), t)"),
        ("D(m r^2 D phi)", "diff((m r^2 diff(phi, t)), t)"),
        ("(m D^2 + b D + c) x", "(m diff(diff(x, t), t) + b diff(x, t) + c x)"),
    ],
)
def test_the_operator_d(text: str, written: str) -> None:
    draft = Draft(Fragment.of(text))
    with_operators(draft, frozenset({"x"}))
    assert draft.text == written


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("h = 2,5 R, v = 3", "h = 2.5 R, v = 3"),
        ("sin(0,5 x)", "sin(0.5 x)"),
        (r"\frac{2,5}{3} x_{1,2}", r"\frac{2.5}{3} x_{1,2}"),
        ("atan2(1,2) + f(1,2) + [1,2]", "atan2(1,2) + f(1,2) + [1,2]"),
        ("n = 1,2,3 and W = 10,000", "n = 1,2,3 and W = 10,000"),
    ],
)
def test_decimal_commas(text: str, written: str) -> None:
    assert with_decimal_points(text) == written


def test_the_greatest_of_several_values() -> None:
    draft = Draft(Fragment.of("min(a, b)"))
    draft.apply(extremes(draft.text))
    assert draft.text == "(((a)+( b)-abs((a)-( b)))/2)"
    assert name_of_extreme("max(T) = 3 m g") == "T_max = 3 m g"


def test_rows_of_tables_and_lists_of_dashes() -> None:
    line = "| radial | m r'' = f |"
    assert [line[a:b].strip() for a, b in cells_of_row(line)] == ["radial", "m r'' = f"]
    assert cells_of_row("|x| = |y|") == []
    assert is_list_of_dashes("So:\n- x'' = g\n- y'' = 0\n")
    assert not is_list_of_dashes("- m x'' = c\nx = 0\n")


@pytest.mark.parametrize(
    ("lines", "kept"),
    [
        (["cos θ = 2/3, i.e. θ ≈ 48.19°"], ["cos θ = 2/3"]),
        (["(a) v = 1", "(b) T = 2"], ["v = 1", "T = 2"]),
        (["(a) x'' = 1"], ["(a) x'' = 1"]),
        ([r"\cos\theta=\frac23\Rightarrow\theta\approx 48"], [r"\cos\theta=\frac23"]),
        ([r"\omega_+ = 1"], [r"\omega_{plus} = 1"]),
    ],
)
def test_what_stands_beside_a_result(lines: list[str], kept: list[str]) -> None:
    assert [f.text.strip() for f in results([Fragment.of(line) for line in lines])] == kept


def test_units_of_latex_as_text() -> None:
    assert plain_unit(r"\mathrm{m}/\mathrm{s}^{2}") == "m/s^2"
